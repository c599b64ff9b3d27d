// SPDX-License-Identifier: BSD-3-Clause
#include "Camera/SceneBounds.h"

#include "Compat/Splats.h"

#include "vtkActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
// The names of these arrays are for the mappers alone.
class BallAccess : public vtkOpenGLSphereMapper
{
public:
  static const char* Name(vtkOpenGLSphereMapper* m) { return m->*(&BallAccess::ScaleArray); }
};

class StickAccess : public vtkOpenGLStickMapper
{
public:
  static const char* Name(vtkOpenGLStickMapper* m) { return m->*(&StickAccess::ScaleArray); }
};

// The largest value of a component of a point array, or the one given where there is none.
double Largest(vtkPolyData* data, const char* name, int component, double otherwise)
{
  vtkDataArray* array = data && name ? data->GetPointData()->GetArray(name) : nullptr;
  if (!array || component >= array->GetNumberOfComponents())
  {
    return otherwise;
  }
  double range[2];
  array->GetRange(range, component);
  return std::max(0.0, range[1]);
}

double ReachOfMapper(vtkMapper* mapper)
{
  // most are these, and to ask of what class something is takes long
  const char* const name = mapper->GetClassName();
  if (!std::strcmp(name, "vtkOpenGLPolyDataMapper") ||
    !std::strcmp(name, "vtkWideFoVPolyDataMapper"))
  {
    return 0;
  }
  if (auto* balls = vtkOpenGLSphereMapper::SafeDownCast(mapper))
  {
    return Largest(balls->GetInput(), BallAccess::Name(balls), 0, balls->GetRadius());
  }
  if (auto* sticks = vtkOpenGLStickMapper::SafeDownCast(mapper))
  {
    const char* name = StickAccess::Name(sticks);
    return Largest(sticks->GetInput(), name, 1, 0) + 0.5 * Largest(sticks->GetInput(), name, 0, 0);
  }
  if (auto* splats = vtkPointGaussianMapper::SafeDownCast(mapper))
  {
    return splats->GetScaleFactor() * wfv::SplatBound(splats) *
      Largest(splats->GetInput(), splats->GetScaleArray(), 0, 1);
  }
  return 0;
}

// Of tubes and points as spheres, over their distance: a pixel of a map is seen under no
// more than this, but at places where maps shrink.
double ReachOfPixels(vtkProperty* property, vtkRenderer* renderer)
{
  const double tubes = property->GetRenderLinesAsTubes() ? property->GetLineWidth() : 0;
  const double spheres = property->GetRenderPointsAsSpheres() ? property->GetPointSize() : 0;
  if (tubes == 0 && spheres == 0)
  {
    return 0;
  }
  const int* size = renderer->GetSize();
  return std::max(tubes, spheres) * vtkMath::Pi() / std::max(1, std::min(size[0], size[1]));
}

// Of an actor without a mapper, such as axes, which is drawn by others that it keeps to itself: its
// letters stand beside its bounds. Stock VTK adds as much to the clipping range of any scene.
double ReachBesideBounds(vtkActor* actor)
{
  const double* const bounds = actor->GetBounds();
  return bounds && vtkMath::AreBoundsInitialized(bounds)
    ? 0.5 * vtkBoundingBox(bounds).GetDiagonalLength()
    : 0;
}

double ReachOfActor(vtkActor* actor, vtkRenderer* renderer, double farthest)
{
  if (!actor->GetVisibility())
  {
    return 0;
  }
  if (!actor->GetMapper())
  {
    return ReachBesideBounds(actor);
  }
  const double pixels = farthest * ReachOfPixels(actor->GetProperty(), renderer);
  return std::max(ReachOfMapper(actor->GetMapper()), pixels);
}

// Of the actors in something that is more than one. Such a collection may hold other props as well.
// A text is a rectangle, and one of no letters ends the program where it is asked.
double ReachOfParts(vtkProp* prop, vtkRenderer* renderer, double farthest)
{
  double reach = 0;
  if (vtkBillboardTextActor3D::SafeDownCast(prop))
  {
    return reach;
  }
  vtkNew<vtkPropCollection> parts;
  prop->GetActors(parts);
  vtkCollectionSimpleIterator it;
  parts->InitTraversal(it);
  while (vtkObject* const part = parts->GetNextItemAsObject(it))
  {
    auto* const actor = vtkActor::SafeDownCast(part);
    reach = std::max(reach, actor ? ReachOfActor(actor, renderer, farthest) : 0.0);
  }
  return reach;
}

double Reach(vtkRenderer* renderer, double farthest)
{
  double reach = 0;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    auto* const actor = vtkActor::SafeDownCast(prop);
    reach = std::max(reach,
      actor ? ReachOfActor(actor, renderer, farthest) : ReachOfParts(prop, renderer, farthest));
  }
  return reach;
}

bool IsEndless(const double bounds[6])
{
  return !std::all_of(bounds, bounds + 6, [](double x) { return std::isfinite(x); });
}
}

namespace wfv
{
void LeaveOutEndless(vtkRenderer* renderer, double bounds[6])
{
  if (!IsEndless(bounds))
  {
    return;
  }
  vtkBoundingBox box;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = props->GetNextProp(it))
  {
    const double* const own =
      prop->GetVisibility() && prop->GetUseBounds() ? prop->GetBounds() : nullptr;
    if (own && !IsEndless(own) && vtkMath::AreBoundsInitialized(own))
    {
      box.AddBounds(own);
    }
  }
  vtkMath::UninitializeBounds(bounds);
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
}

void InflateForQuadrics(vtkRenderer* renderer, const double eye[3], double bounds[6])
{
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    return;
  }
  vtkBoundingBox box(bounds);
  double centre[3];
  box.GetCenter(centre);
  const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(centre, eye));
  const double reach = Reach(renderer, distance + 0.5 * box.GetDiagonalLength());
  if (reach > 0 && std::isfinite(reach))
  {
    box.Inflate(reach);
    box.GetBounds(bounds);
  }
}
}
