// SPDX-License-Identifier: BSD-3-Clause
#include "PickerAnswer.h"

#include "Camera/Tile.h"
#include "vtkWideFoVCamera.h"

#include "vtkBox.h"
#include "vtkCell.h"
#include "vtkCellPicker.h"
#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkProp3D.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
// Of the near clip radius, where nothing is drawn: between these the ray of a pixel that the map
// does not cover hits nothing.
constexpr std::array<double, 2> Nowhere{ 1e-3, 2e-3 };

// Of the distance to what is hit: how far before it the ray begins. Points beside it may be as much
// nearer.
constexpr double Before = 1e-3;
constexpr double BeforeLine = 0.9;

// Of the distance between two origins: as good as none.
constexpr double SamePlace = 1e-9;

// Of the window's diagonal: how near to a line the ray has to pass to hit it, as VTK's handles have
// it.
constexpr double LineTolerance = 0.01;

// The first thing between two places that the picker hits. True of a line where lines are asked
// for, else of anything.
bool Hits(vtkCellPicker* picker, const wfv::PickRay& ray, vtkRenderer* renderer, bool lines)
{
  auto* const camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  camera->GetFlatQuestions().ExpectMiddle();
  double from[3];
  double to[3];
  for (int i = 0; i < 3; i++)
  {
    from[i] = ray.Origin[i] + ray.Range[0] * ray.Direction[i];
    to[i] = ray.Origin[i] + ray.Range[1] * ray.Direction[i];
  }
  const bool hits = picker->Pick3DPoint(from, to, renderer) != 0;
  vtkDataSet* const data = hits ? picker->GetDataSet() : nullptr;
  const bool line =
    data && picker->GetCellId() >= 0 && data->GetCell(picker->GetCellId())->GetCellDimension() < 2;
  return lines ? line : hits;
}

// Returns the distance at which a ray enters the bounds of a prop that keeps its actors to itself,
// as widgets do, so that no picker finds them; the end of the ray if it enters none.
double DistanceToWidgets(const wfv::PickRay& ray, vtkRenderer* renderer)
{
  double nearest = ray.Range[1];
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = props->GetNextProp(it))
  {
    const bool keeps = prop->GetVisibility() && !vtkProp3D::SafeDownCast(prop);
    const double* const bounds = keeps ? prop->GetBounds() : nullptr;
    double at[3];
    double way[3];
    for (int i = 0; i < 3; i++)
    {
      way[i] = nearest * ray.Direction[i];
    }
    double share = 1;
    if (bounds && vtkMath::AreBoundsInitialized(bounds) &&
      vtkBox::IntersectBox(bounds, ray.Origin.data(), way, at, share) && share > 0)
    {
      nearest *= share;
    }
  }
  return nearest;
}

// The ray from there to what this one hits. Where it hits nothing, to the nearest widget, or to
// what is far.
wfv::PickRay SeenFrom(const double place[3], vtkRenderer* renderer, const wfv::PickRay& ray)
{
  vtkNew<vtkCellPicker> surfaces;
  vtkNew<vtkCellPicker> lines;
  lines->SetTolerance(LineTolerance);
  const double aim = DistanceToWidgets(ray, renderer);
  double hit[3];
  for (int i = 0; i < 3; i++)
  {
    hit[i] = ray.Origin[i] + aim * ray.Direction[i];
  }
  wfv::PickRay before = ray;
  const bool surface = Hits(surfaces, ray, renderer, false);
  if (surface)
  {
    surfaces->GetPickPosition(hit);
    before.Range[1] = std::sqrt(vtkMath::Distance2BetweenPoints(hit, ray.Origin.data()));
  }
  const bool line = Hits(lines, before, renderer, true);
  if (line)
  {
    lines->GetPickPosition(hit);
  }
  wfv::PickRay seen;
  std::copy_n(place, 3, seen.Origin.begin());
  vtkMath::Subtract(hit, place, seen.Direction.data());
  const double distance = vtkMath::Normalize(seen.Direction.data());
  // of a line the hit is the nearest place, which another ray may find a little before
  const double share = surface && !line ? 1 - Before : line ? BeforeLine : 0;
  seen.Range = { share * distance, distance + ray.Range[1] };
  return seen;
}
}

namespace wfv
{
PickRay FindPickRay(vtkRenderer* renderer, vtkWideFoVCamera* camera, const double ndc[2])
{
  PickRay ray;
  const bool inside =
    camera->NDCToRay(ndc, PictureAspect(renderer), ray.Origin.data(), ray.Direction.data());
  camera->GetClipRadii(ray.Range.data());
  if (!inside)
  {
    ray.Range = { Nowhere[0] * ray.Range[0], Nowhere[1] * ray.Range[0] };
    ray.Direction = { 0, 0, 0 };
    camera->GetDirectionOfProjection(ray.Direction.data());
    return ray;
  }
  const double* const place = camera->GetPosition();
  const double apart = std::sqrt(vtkMath::Distance2BetweenPoints(ray.Origin.data(), place));
  return apart <= SamePlace * ray.Range[1] ? ray : SeenFrom(place, renderer, ray);
}

double FindDiagonal(vtkRenderer* renderer, vtkWideFoVCamera* camera, const double place[3])
{
  const int* const size = renderer->GetSize();
  const double aspect = PictureAspect(renderer);
  double ndc[3];
  camera->WorldToNDC(place, aspect, ndc);
  double longest = 0;
  for (int axis = 0; axis < 2; axis++)
  {
    double next[3] = { ndc[0], ndc[1], ndc[2] };
    next[axis] += (next[axis] > 0 ? -2.0 : 2.0) / std::max(size[axis], 1);
    double world[3];
    if (camera->NDCToWorld(next, aspect, world))
    {
      longest = std::max(longest, std::sqrt(vtkMath::Distance2BetweenPoints(world, place)));
    }
  }
  return std::hypot(size[0], size[1]) * longest;
}
}
