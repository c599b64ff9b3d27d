// SPDX-License-Identifier: BSD-3-Clause
// wfv::SortedDraw: triangles that stand behind others.
#include "vtkWideFoVHiddenWork.h"
#include "vtkWideFoVSortedDraw.h"
#include "vtkWideFoVStages.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
// Triangles a thread takes at least.
constexpr vtkIdType HideGrain = 4096;
constexpr vtkIdType LargeGrain = 16; // of those that are looked for in all of the picture

// Triangles that may be anywhere in the picture, of which more would take longer to look at than
// they do to draw.
constexpr std::size_t MostAnywhere = 4096;

// Of the triangles that are looked at, the share of hidden ones that is worth another order.
constexpr double LeastShare = 1.0 / 16;
}

namespace wfv
{
// Everything in the order in which it was sorted.
void SortedDraw::Show(Entry& e, vtkPolyData* data)
{
  if (e.GetNumberOfHidden(0) == 0)
  {
    return;
  }
  for (const Lot lot : { Covered, Calm, Plain })
  {
    e.ShowLot(lot);
  }
  this->Load(e, data);
}

// Hidden ones before all others, each eye its own. hidden: by which eyes.
void SortedDraw::PutBehind(Entry& e, vtkPolyData* data, const std::vector<unsigned char>& hidden)
{
  const auto found =
    std::count_if(hidden.begin(), hidden.end(), [](unsigned char eyes) { return eyes != 0; });
  if (static_cast<double>(found) < LeastShare * static_cast<double>(hidden.size()))
  {
    return;
  }
  const unsigned char* answers = hidden.data();
  for (const Lot lot : { Covered, Calm, Plain })
  {
    const std::size_t all = e.Lots[lot].All;
    e.HideInLot(lot, answers);
    answers += all;
  }
  this->Load(e, data);
}

void SortedDraw::Load(Entry& e, vtkPolyData* data)
{
  this->Mesh.Update(data);
  this->NumbersOf = this->NumbersOf == &e ? nullptr : this->NumbersOf;
  e.Loaded = e.FoldsLoaded = false;
  this->Upload(e);
}

template <typename Real>
void SortedDraw::FindHiddenIn(const Entry& e, const Real* points,
  const DepthPicture* const depths[], const SampleRays& rays, std::vector<unsigned char>& hidden)
{
  const Scene<Real> all{ this->Mesh, points, Affine(e.ToMap), e.View };
  const std::size_t anywhere = e.Lots[Covered].All;
  const bool looks = e.View.Rays && anywhere > 0 && anywhere <= MostAnywhere;
  RayBlocks blocks[SortView::MostEyes];
  for (int i = 0; looks && i < e.View.GetNumberOfEyes(); i++)
  {
    blocks[i].Make(e.View, e.View.GetViewOf(i), rays);
  }
  const sorting::HiddenWork<Real, Entry> work(all, e, depths, rays, blocks, hidden);
  const auto first = static_cast<vtkIdType>(anywhere);
  vtkSMPTools::For(0, first, looks ? LargeGrain : HideGrain, work);
  vtkSMPTools::For(first, static_cast<vtkIdType>(hidden.size()), HideGrain, work);
}

bool SortedDraw::FindHidden(Entry& e, vtkPolyData* data, HiddenScene& scene)
{
  const SortView& view = e.View;
  const DepthPicture* depths[SortView::MostEyes] = { nullptr, nullptr };
  bool known = true;
  for (int i = 0; i < view.GetNumberOfEyes(); i++)
  {
    const double x = view.Own ? view.GetViewOf(i).stereo.x : 0;
    depths[i] = scene.AskFor(x < 0 ? -1 : x > 0 ? 1 : 0);
    known = known && depths[i];
  }
  if (!known)
  {
    return false;
  }
  this->Mesh.Update(data);
  const bool whole = e.TakeNaturalOrder();
  std::vector<unsigned char> hidden(e.Order.size());
  vtkDataArray* const points = data->GetPoints()->GetData();
  if (auto* singles = vtkFloatArray::SafeDownCast(points))
  {
    this->FindHiddenIn(e, singles->GetPointer(0), depths, scene.GetRays(view), hidden);
  }
  else if (auto* doubles = vtkDoubleArray::SafeDownCast(points))
  {
    this->FindHiddenIn(e, doubles->GetPointer(0), depths, scene.GetRays(view), hidden);
  }
  this->PutBehind(e, data, hidden);
  if (whole && e.GetNumberOfHidden(0) == 0)
  {
    e.Order.clear();
  }
  return true;
}

void SortedDraw::Hide(Entry& e, vtkPolyData* data, vtkWideFoVStages* stages)
{
  HiddenScene& scene = stages->Hidden;
  e.Skips = false;
  if (scene.IsPaused())
  {
    return;
  }
  const std::uint64_t number = scene.GetNumber();
  if (e.HiddenIn != number)
  {
    this->Show(e, data);
    e.HiddenIn = 0;
  }
  // what is far is sorted as without stereo, of which there are no depths where two eyes are drawn
  const bool seen = e.View.Own || this->Eye == 0;
  const bool may = number > 0 && seen && !e.Haste && e.All > 0 && e.View.Bends &&
    (e.View.Plain || e.View.Calm) &&
    e.Actor->GetMapper()->GetResolveCoincidentTopology() == VTK_RESOLVE_OFF;
  if (may && e.HiddenIn == 0 && this->FindHidden(e, data, scene))
  {
    e.HiddenIn = number;
  }
  e.Skips = e.HiddenIn > 0;
}
}
