// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVScreenCamera.h"

#include "Stereo/Screen.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPerspectiveTransform.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkWideFoVScreenCamera);

// The screen, and who stands before it.
struct vtkWideFoVScreenCamera::Room
{
  wfv::Screen Screen;
  wfv::Head Head;

  // The one that the camera is now, or the middle.
  wfv::vec3 EyeOf(vtkWideFoVCamera* camera) const
  {
    return wfv::EyeOf(this->Head, camera->GetInterpupillaryDistance(),
      static_cast<wfv::Eye>(camera->GetCurrentEye()));
  }
};

namespace
{
wfv::vec3 ToVector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

void FromVector(const wfv::vec3& from, double v[3])
{
  v[0] = from.x;
  v[1] = from.y;
  v[2] = from.z;
}

// From the room to the eye's own coordinates, along the sides of the screen.
void ToFrustum(const wfv::ScreenFrustum& frustum, const wfv::vec3& eye, vtkMatrix4x4* matrix)
{
  const wfv::vec3 rows[3] = { frustum.Right, frustum.Up, frustum.Back };
  for (int i = 0; i < 3; i++)
  {
    for (int j = 0; j < 3; j++)
    {
      matrix->SetElement(i, j, rows[i][j]);
    }
    matrix->SetElement(i, 3, -glm::dot(rows[i], eye));
  }
}
}

vtkWideFoVScreenCamera::vtkWideFoVScreenCamera()
  : In(new Room)
{
  this->vtkWideFoVCamera::SetProjection("perspective");
  this->UpdateEye();
}

vtkWideFoVScreenCamera::~vtkWideFoVScreenCamera() = default;

void vtkWideFoVScreenCamera::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const wfv::vec3& v) {
    os << indent << name << ": " << v.x << ", " << v.y << ", " << v.z << "\n";
  };
  print("LowerLeft", this->In->Screen.LowerLeft);
  print("LowerRight", this->In->Screen.LowerRight);
  print("UpperRight", this->In->Screen.UpperRight);
  print("HeadPosition", this->In->Head.Position);
  const std::array<double, 4>& turn = this->In->Head.Turn;
  os << indent << "HeadTurn: " << turn[0] << ", " << turn[1] << ", " << turn[2] << ", " << turn[3]
     << "\n";
}

vtkObjectBase* vtkWideFoVScreenCamera::NewInstanceInternal() const
{
  vtkWideFoVScreenCamera* const camera = vtkWideFoVScreenCamera::New();
  camera->CopyView(this);
  return camera;
}

void vtkWideFoVScreenCamera::CopyView(const vtkWideFoVCamera* source)
{
  this->Superclass::CopyView(source);
  if (const auto* screen = dynamic_cast<const vtkWideFoVScreenCamera*>(source))
  {
    *this->In = *screen->In;
  }
  this->vtkWideFoVCamera::SetProjection("perspective");
  this->UpdateEye();
}

bool vtkWideFoVScreenCamera::SetScreen(
  const double lowerLeft[3], const double lowerRight[3], const double upperRight[3])
{
  const wfv::Screen screen{ ToVector(lowerLeft), ToVector(lowerRight), ToVector(upperRight) };
  const std::string problem = wfv::CheckScreen(screen);
  if (!problem.empty())
  {
    vtkErrorMacro(<< "The screen is refused: " << problem);
    return false;
  }
  this->In->Screen = screen;
  this->Modified();
  this->UpdateEye();
  return true;
}

void vtkWideFoVScreenCamera::GetScreen(
  double lowerLeft[3], double lowerRight[3], double upperRight[3])
{
  FromVector(this->In->Screen.LowerLeft, lowerLeft);
  FromVector(this->In->Screen.LowerRight, lowerRight);
  FromVector(this->In->Screen.UpperRight, upperRight);
}

bool vtkWideFoVScreenCamera::SetHeadPosition(double x, double y, double z)
{
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    vtkErrorMacro(<< "The position " << x << ", " << y << ", " << z
                  << " of the head is not finite; it is unchanged");
    return false;
  }
  this->In->Head.Position = { x, y, z };
  this->Modified();
  this->UpdateEye();
  return true;
}

void vtkWideFoVScreenCamera::GetHeadPosition(double position[3])
{
  FromVector(this->In->Head.Position, position);
}

bool vtkWideFoVScreenCamera::SetHeadTurn(double x, double y, double z, double w)
{
  const double square = x * x + y * y + z * z + w * w;
  if (!std::isnormal(square))
  {
    vtkErrorMacro(<< "The quaternion " << x << ", " << y << ", " << z << ", " << w
                  << " is no turn of the head; it is unchanged");
    return false;
  }
  this->In->Head.Turn = { { x, y, z, w } };
  this->Modified();
  this->UpdateEye();
  return true;
}

void vtkWideFoVScreenCamera::GetHeadTurn(double quaternion[4])
{
  std::copy_n(this->In->Head.Turn.begin(), 4, quaternion);
}

void vtkWideFoVScreenCamera::SetProjection(const char* name)
{
  if (name == nullptr || std::string(name) != "perspective")
  {
    vtkErrorMacro(<< "A flat screen shows the projection perspective, not "
                  << (name ? name : "(null)"));
  }
}

void vtkWideFoVScreenCamera::SetInterpupillaryDistance(double distance)
{
  this->Superclass::SetInterpupillaryDistance(distance);
  this->UpdateEye();
}

double vtkWideFoVScreenCamera::GetBaselineRadius()
{
  return this->GetCurrentEye() != MIDDLE_EYE ? 0.5 * this->GetInterpupillaryDistance() : 0;
}

double vtkWideFoVScreenCamera::GetScreenDistance()
{
  return wfv::LookThrough(this->In->Screen, this->In->EyeOf(this)).Distance;
}

void vtkWideFoVScreenCamera::UpdateEye()
{
  const wfv::ScreenFrustum frustum = wfv::LookThrough(this->In->Screen, this->In->EyeOf(this));
  const double half[2] = { frustum.Half.x, frustum.Half.y };
  const double center[2] = { frustum.Center.x, frustum.Center.y };
  this->SetFrustum(half, center);
  this->ComputeViewTransform();
}

void vtkWideFoVScreenCamera::ComputeViewTransform()
{
  this->Superclass::ComputeViewTransform();
  const wfv::vec3 eye = this->In->EyeOf(this);
  vtkNew<vtkMatrix4x4> toFrustum;
  ToFrustum(wfv::LookThrough(this->In->Screen, eye), eye, toFrustum);
  this->ViewTransform->Identity();
  this->ViewTransform->Concatenate(toFrustum);
  this->ViewTransform->Concatenate(this->Transform->GetMatrix());
}

// The middle between the eyes.
void vtkWideFoVScreenCamera::GetViewpoint(double world[3])
{
  vtkNew<vtkMatrix4x4> toWorld;
  vtkMatrix4x4::Invert(this->Transform->GetMatrix(), toWorld);
  double head[4] = { 0, 0, 0, 1 };
  FromVector(this->In->Head.Position, head);
  toWorld->MultiplyPoint(head, head);
  std::copy_n(head, 3, world);
}

void vtkWideFoVScreenCamera::PrepareFrame(vtkRenderer* renderer)
{
  this->FindEye(renderer);
  this->UpdateEye();
  this->Superclass::PrepareFrame(renderer);
}

// Cullers ask before the frame is prepared.
void vtkWideFoVScreenCamera::GetFrustumPlanes(double aspect, double planes[24])
{
  this->UpdateEye();
  this->Superclass::GetFrustumPlanes(aspect, planes);
}
