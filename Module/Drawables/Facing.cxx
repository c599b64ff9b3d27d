// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/Facing.h"

#include "Camera/PictureScale.h"
#include "Camera/Tile.h"
#include "Projections/Projection.h"
#include "vtkWideFoVCamera.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
// Finds the origin of the ray to a place. If no ray reaches the place, takes the camera's position.
void FindEye(vtkWideFoVCamera* camera, double aspect, const double place[3], double eye[3])
{
  double ndc[3];
  double direction[3];
  const bool seen = camera->WorldToNDC(place, aspect, ndc);
  if (!seen || !camera->NDCToRay(ndc, aspect, eye, direction))
  {
    camera->GetPosition(eye);
  }
}

// The axes of what faces a camera, as vtkFollower reckons them.
void FindFollowerAxes(vtkCamera* camera, const double place[3], double axes[3][3])
{
  double eye[3];
  double ahead[3];
  double right[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(ahead);
  vtkMath::Cross(ahead, camera->GetViewUp(), right);
  vtkMath::Normalize(right);
  vtkMath::Subtract(eye, place, axes[2]);
  vtkMath::Normalize(axes[2]);
  vtkMath::Cross(axes[2], right, axes[1]);
  vtkMath::Normalize(axes[1]);
  vtkMath::Cross(axes[1], axes[2], axes[0]);
}

// Finds the up direction of labels, a unit vector in world coordinates.
void FindUp(vtkRenderer* renderer, vtkWideFoVCamera* camera, wfv::LabelUp kind, double up[3])
{
  if (kind == wfv::LabelUp::World)
  {
    std::copy_n(renderer->GetEnvironmentUp(), 3, up);
  }
  else
  {
    vtkMatrix4x4* const view = camera->GetModelViewTransformMatrix();
    for (int i = 0; i < 3; i++)
    {
      up[i] = view->GetElement(1, i);
    }
  }
  vtkMath::Normalize(up);
}
}

namespace wfv
{
void LookAt(vtkCamera* flat, vtkWideFoVCamera* camera, double aspect, const double place[3])
{
  constexpr double Upright = 1e-3; // sine of the least angle between up and the line of sight
  double eye[3];
  double sight[3];
  double up[3];
  double side[3];
  FindEye(camera, aspect, place, eye);
  vtkMath::Subtract(place, eye, sight);
  vtkMath::Normalize(sight);
  camera->GetViewUp(up);
  vtkMath::Normalize(up);
  vtkMath::Cross(sight, up, side);
  if (vtkMath::Norm(side) < Upright)
  {
    // straight above or below: its top is away from where the camera looks
    const double sign = vtkMath::Dot(sight, up) > 0 ? -1 : 1;
    camera->GetDirectionOfProjection(up);
    vtkMath::MultiplyScalar(up, sign);
  }
  flat->SetPosition(eye);
  flat->SetFocalPoint(place);
  flat->SetViewUp(up);
  flat->Modified(); // followers ask whether it was
}

bool TurnFollower(vtkMatrix4x4* matrix, vtkWideFoVCamera* camera, double aspect)
{
  constexpr double Same = 1e-6; // of a unit vector
  const double place[3] = { matrix->GetElement(0, 3), matrix->GetElement(1, 3),
    matrix->GetElement(2, 3) };
  double before[3][3];
  double after[3][3];
  FindFollowerAxes(camera, place, before);
  vtkNew<vtkCamera> flat;
  LookAt(flat, camera, aspect, place);
  FindFollowerAxes(flat, place, after);
  double turned[3][3];
  for (int axis = 0; axis < 3; axis++)
  {
    double column[3] = { matrix->GetElement(0, axis), matrix->GetElement(1, axis),
      matrix->GetElement(2, axis) };
    const double scale = vtkMath::Normalize(column);
    if (!(std::sqrt(vtkMath::Distance2BetweenPoints(column, before[axis])) < Same))
    {
      return false;
    }
    std::transform(
      after[axis], after[axis] + 3, turned[axis], [scale](double x) { return scale * x; });
  }
  for (int i = 0; i < 9; i++)
  {
    matrix->SetElement(i % 3, i / 3, turned[i / 3][i % 3]);
  }
  return true;
}

double FindLabelTurn(
  vtkRenderer* renderer, vtkWideFoVCamera* camera, LabelUp up, const double place[3])
{
  constexpr double Upright = 1e-3; // sine of the least angle between up and the line of sight
  const bool round = camera->GetProjectionDefinition().Axis == Family::Azimuthal;
  if (up == LabelUp::Picture || (up == LabelUp::Automatic && !round))
  {
    return 0;
  }
  double top[3];
  double eye[3];
  double sight[3];
  double side[3];
  FindUp(renderer, camera, up, top);
  camera->GetPosition(eye);
  vtkMath::Subtract(place, eye, sight);
  vtkMath::Normalize(sight);
  vtkMath::Cross(sight, top, side);
  if (!(vtkMath::Norm(side) > Upright))
  {
    return 0; // there every way leads away from it
  }
  double across[3];
  double way[2];
  vtkMath::Cross(side, sight, across);
  vtkMath::Normalize(across);
  FindStep(camera, PictureAspect(renderer), place, across, way);
  return vtkMath::DegreesFromRadians(std::atan2(-way[0], way[1]));
}
}
