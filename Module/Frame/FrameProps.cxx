// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/FrameProps.h"

#include "Camera/PropBounds.h"
#include "Frame/Stages.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <cstring>

namespace
{
// A renderer's stock culler asks every prop for its bounds before each frame.
bool HasAsked(vtkRenderer* renderer)
{
  vtkCullerCollection* const cullers = renderer->GetCullers();
  vtkCollectionSimpleIterator it;
  cullers->InitTraversal(it);
  while (vtkCuller* culler = cullers->GetNextCuller(it))
  {
    if (std::strcmp(culler->GetClassName(), "vtkFrustumCoverageCuller") == 0)
    {
      return true;
    }
  }
  return false;
}
}

namespace wfv
{
// Its first input. To ask the mapper takes a few percent of the time to draw a small prop; what its
// input comes from stays the same until the mapper is modified.
vtkDataObject* FrameProps::FindData(vtkMapper* mapper, const Entry& before, Entry& now)
{
  now.Mapper = mapper;
  const bool same = before.Mapper == mapper && before.Times[1] == now.Times[1];
  if (same && before.Producer)
  {
    now.Producer = before.Producer;
    now.Port = before.Port;
  }
  else if (mapper->GetNumberOfInputConnections(0) > 0)
  {
    now.Producer = mapper->GetInputAlgorithm(0, 0, now.Port);
  }
  return now.Producer ? now.Producer->GetExecutive()->GetOutputData(now.Port) : nullptr;
}

void FrameProps::Look(vtkProp* prop, bool asked, Entry& entry)
{
  Entry now;
  now.Prop = prop;
  auto* const actor = vtkActor::SafeDownCast(prop);
  vtkMapper* const mapper = actor ? actor->GetMapper() : nullptr;
  now.HasBounds = asked ? FindLastBounds(prop, now.Bounds) : FindBounds(prop, now.Bounds);
  // of anything but an actor there is no telling when it changes
  if (mapper)
  {
    now.Times[0] = actor->GetMTime();
    now.Times[1] = mapper->GetMTime();
    vtkDataObject* const data = FindData(mapper, entry, now);
    now.Data = data;
    now.Times[2] = data ? data->GetMTime() : 0;
    now.Times[3] = actor->GetShaderProperty()->GetMTime();
  }
  const bool same = mapper && entry.Prop == prop && entry.Data == now.Data &&
    std::equal(now.Times, now.Times + 4, entry.Times) && entry.HasBounds == now.HasBounds &&
    std::equal(now.Bounds, now.Bounds + 6, entry.Bounds);
  if (!same)
  {
    entry = now;
  }
}

bool FrameProps::WatchFilters()
{
  bool changes = false;
  for (Entry& entry : this->Entries)
  {
    auto* const actor = entry.Watched ? nullptr : vtkActor::SafeDownCast(entry.Prop);
    entry.Watched = true;
    if (actor && actor->GetMapper())
    {
      changes = this->Filters.Watch(actor->GetMapper()) || changes;
    }
  }
  return changes;
}

void FrameProps::Gather(vtkRenderer* renderer, vtkWideFoVCamera* camera, vtkProp** props, int count)
{
  bool asked = !this->Filters.Begin(renderer, camera) && HasAsked(renderer);
  this->Entries.resize(count);
  do
  {
    for (int i = 0; i < count; i++)
    {
      Look(props[i], asked, this->Entries[i]);
    }
    asked = false; // new filters have changed what was told
  } while (this->WatchFilters());
}

bool FrameProps::GetSceneBounds(vtkRenderer* renderer, double bounds[6]) const
{
  if (renderer->HasObserver(vtkCommand::ComputeVisiblePropBoundsEvent))
  {
    return false; // somebody wants to be asked
  }
  int visible = 0;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    visible += prop->GetVisibility() ? 1 : 0;
  }
  if (visible != this->GetCount())
  {
    return false;
  }
  vtkBoundingBox box;
  for (const Entry& entry : this->Entries)
  {
    if (entry.HasBounds && entry.Prop->GetUseBounds() &&
      vtkMath::AreBoundsInitialized(entry.Bounds))
    {
      box.AddBounds(entry.Bounds);
    }
  }
  vtkMath::UninitializeBounds(bounds);
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
  return true;
}

void FrameProps::Choose(wfv::Stages& stages, std::uint64_t view)
{
  for (Entry& entry : this->Entries)
  {
    if (entry.View != view)
    {
      const double* const bounds = entry.HasBounds ? entry.Bounds : nullptr;
      entry.Culled = stages.IsCulled(entry.Prop, bounds, entry.Traits);
      entry.Stage = entry.Culled ? nullptr : stages.Choose(entry.Prop, bounds, entry.Traits);
      entry.View = view;
      stages.Counts.ChosenProps += entry.Times[0] > 0; // an actor
    }
  }
}
}
