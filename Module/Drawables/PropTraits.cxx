// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/PropTraits.h"

#include "Drawables/Kinds/DrawableKinds.h"

#include "vtkActor.h"
#include "vtkFollower.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkProp3DFollower.h"
#include "vtkShaderProperty.h"

#include <algorithm>

namespace wfv
{
bool IsStockActor(vtkActor* actor)
{
  return HasTrait(actor, StockActor) && HasTrait(actor->GetMapper(), StockMesh);
}

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

bool FindBounds(vtkProp* prop, double bounds[6])
{
  const double* const own = prop->GetBounds();
  if (own)
  {
    std::copy_n(own, 6, bounds);
    HoldTurns(prop, bounds);
  }
  return own != nullptr;
}

bool HasOwnShaders(vtkActor* actor)
{
  vtkShaderProperty* const shaders = actor->GetShaderProperty();
  return shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode() ||
    shaders->GetNumberOfShaderReplacements() > 0;
}
}
