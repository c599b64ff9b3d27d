// SPDX-License-Identifier: BSD-3-Clause
#include "Camera/SceneBounds.h"

#include "Camera/PropBounds.h"
#include "Drawables/Kinds/DrawableKinds.h"

#include "vtkActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkBoundingBox.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
// Of tubes and points as spheres, over their distance: a pixel of a map is seen under no
// more than this, but at places where maps shrink.
double OverhangOfPixels(vtkProperty* property, vtkRenderer* renderer)
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
// letters stand beside its bounds, as handles of widgets do. Stock VTK adds as much to the clipping
// range of any scene.
double OverhangBesideBounds(vtkProp* prop)
{
  const double* const bounds = prop->GetBounds();
  return bounds && vtkMath::AreBoundsInitialized(bounds)
    ? 0.5 * vtkBoundingBox(bounds).GetDiagonalLength()
    : 0;
}

double OverhangOfActor(vtkActor* actor, vtkRenderer* renderer, double farthest)
{
  if (!actor->GetVisibility())
  {
    return 0;
  }
  if (!actor->GetMapper())
  {
    return OverhangBesideBounds(actor);
  }
  const double pixels = farthest * OverhangOfPixels(actor->GetProperty(), renderer);
  return std::max(wfv::Overhang(actor->GetMapper()), pixels);
}

// Of the actors in something that is more than one. Such a collection may hold other props as well.
// A text is a rectangle, and one of no letters ends the program where it is asked.
double OverhangOfParts(vtkProp* prop, vtkRenderer* renderer, double farthest)
{
  double overhang = 0;
  if (vtkBillboardTextActor3D::SafeDownCast(prop))
  {
    return overhang;
  }
  if (wfv::HasTrait(prop, wfv::BesideBounds))
  {
    overhang = prop->GetVisibility() ? OverhangBesideBounds(prop) : 0;
  }
  vtkNew<vtkPropCollection> parts;
  prop->GetActors(parts);
  vtkCollectionSimpleIterator it;
  parts->InitTraversal(it);
  while (vtkObject* const part = parts->GetNextItemAsObject(it))
  {
    auto* const actor = vtkActor::SafeDownCast(part);
    overhang = std::max(overhang, actor ? OverhangOfActor(actor, renderer, farthest) : 0.0);
  }
  return overhang;
}

double OverhangOfAll(vtkRenderer* renderer, double farthest)
{
  double overhang = 0;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    auto* const actor = vtkActor::SafeDownCast(prop);
    overhang = std::max(overhang,
      actor ? OverhangOfActor(actor, renderer, farthest)
            : OverhangOfParts(prop, renderer, farthest));
  }
  return overhang;
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

void HoldOtherBounds(vtkRenderer* renderer, double bounds[6])
{
  vtkBoundingBox box(bounds);
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = props->GetNextProp(it))
  {
    double own[6];
    if (prop->GetVisibility() && prop->GetUseBounds() && HasOtherBounds(prop) &&
      FindBounds(prop, own) && vtkMath::AreBoundsInitialized(own))
    {
      box.AddBounds(own);
    }
  }
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
  const double overhang = OverhangOfAll(renderer, distance + 0.5 * box.GetDiagonalLength());
  if (overhang > 0 && std::isfinite(overhang))
  {
    box.Inflate(overhang);
    box.GetBounds(bounds);
  }
}
}
