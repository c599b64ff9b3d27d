// SPDX-License-Identifier: BSD-3-Clause
#include "Camera/PropBounds.h"

#include "Drawables/Kinds/DrawableKinds.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkFollower.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkProp3DFollower.h"
#include "vtkPropCollection.h"

#include <algorithm>
#include <cmath>

namespace
{
class ActorAccess : public vtkActor
{
public:
  static const double* GetLastBounds(vtkActor* actor) { return actor->*(&ActorAccess::Bounds); }
};

// A sphere round the place that they turn about.
void HoldTurns(vtkProp* prop, double bounds[6])
{
  const bool turns = vtkFollower::SafeDownCast(prop) || vtkProp3DFollower::SafeDownCast(prop);
  if (!turns || !vtkMath::AreBoundsInitialized(bounds))
  {
    return;
  }
  double place[3];
  auto* const turned = vtkProp3D::SafeDownCast(prop);
  vtkMath::Add(turned->GetPosition(), turned->GetOrigin(), place);
  double farthest[3];
  for (int i = 0; i < 3; i++)
  {
    farthest[i] = std::max(place[i] - bounds[2 * i], bounds[2 * i + 1] - place[i]);
  }
  const double radius = vtkMath::Norm(farthest);
  for (int i = 0; i < 3; i++)
  {
    bounds[2 * i] = place[i] - radius;
    bounds[2 * i + 1] = place[i] + radius;
  }
}

bool FindBoundsOfParts(vtkProp* prop, double bounds[6])
{
  prop->HasTranslucentPolygonalGeometry(); // brings its parts up to date
  vtkNew<vtkPropCollection> parts;
  prop->GetActors(parts);
  vtkBoundingBox box;
  for (int i = 0; i < parts->GetNumberOfItems(); i++)
  {
    auto* const part = vtkProp::SafeDownCast(parts->GetItemAsObject(i));
    const double* const own = part && part->GetVisibility() ? part->GetBounds() : nullptr;
    if (own && vtkMath::AreBoundsInitialized(own))
    {
      box.AddBounds(own);
    }
  }
  vtkMath::UninitializeBounds(bounds);
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
  return box.IsValid();
}
}

namespace wfv
{
bool HasOtherBounds(vtkProp* prop)
{
  return vtkFollower::SafeDownCast(prop) || vtkProp3DFollower::SafeDownCast(prop) ||
    HasTrait(prop, PartsKnowBounds);
}

bool FindBounds(vtkProp* prop, double bounds[6])
{
  if (HasTrait(prop, PartsKnowBounds))
  {
    return FindBoundsOfParts(prop, bounds);
  }
  const double* const own = prop->GetBounds();
  if (own)
  {
    std::copy_n(own, 6, bounds);
    HoldTurns(prop, bounds);
  }
  return own != nullptr;
}

bool FindLastBounds(vtkProp* prop, double bounds[6])
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  if (!actor || !IsStockActor(actor))
  {
    return FindBounds(prop, bounds);
  }
  std::copy_n(ActorAccess::GetLastBounds(actor), 6, bounds);
  return true;
}

double DistanceToBox(const double point[3], const double bounds[6])
{
  double squared = 0;
  for (int i = 0; i < 3; i++)
  {
    const double outside =
      std::max({ bounds[2 * i] - point[i], point[i] - bounds[2 * i + 1], 0.0 });
    squared += outside * outside;
  }
  return std::sqrt(squared);
}
}
