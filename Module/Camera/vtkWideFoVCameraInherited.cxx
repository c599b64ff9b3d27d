// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVCamera: what vtkCamera offers for a perspective, as a wide view understands it.
#include "vtkWideFoVCamera.h"

#include "Camera/CameraInternals.h"
#include "Compat/Reports.h"

#include "vtkMath.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
// vtkCamera's own defaults, which a wide view leaves alone, and what a screenshot rounds the angle
// by, degrees: vtkWindowToImageFilter takes it to float32 radians and back.
constexpr double StockViewAngle = 30;
constexpr double ViewAngleRounding = 1e-3;
constexpr double StockEyeAngle = 2;

// Whether a screenshot of several tiles is being made, for which VTK turns and narrows the camera;
// a wide view knows its tiles by the window.
bool IsTiled(vtkRenderer* renderer)
{
  int scale[2] = { 1, 1 };
  if (vtkWindow* const window = renderer->GetVTKWindow())
  {
    window->GetTileScale(scale);
  }
  return scale[0] > 1 || scale[1] > 1;
}

// Once a process: screenshots draw with cameras of their own.
void WarnOnce(vtkObject* self, const std::string& name, const std::string& instead)
{
  if (wfv::IsNews("camera " + name))
  {
    vtkWarningWithObjectMacro(
      self, << "vtkCamera's " << name << " has no meaning in this view and is ignored" << instead);
  }
}

// Of two that are too large, or too small, one warning is enough.
void SetBothFields(vtkWideFoVCamera* camera, const wfv::Projection& p, double wide, double high)
{
  camera->SetHorizontalFieldOfView(wide);
  const bool said = camera->GetHorizontalFieldOfView() != wide;
  const double least = std::max(MinFieldOfView, p.MinVerticalFov);
  camera->SetVerticalFieldOfView(said ? std::clamp(high, least, p.MaxVerticalFov) : high);
}
}

double vtkWideFoVCamera::GetFieldOfViewAngle()
{
  const bool across =
    this->UseHorizontalViewAngle || this->Definition->Axis == wfv::Family::Azimuthal;
  return across ? this->GetHorizontalFieldOfView() : this->GetVerticalFieldOfView();
}

void vtkWideFoVCamera::SetViewAngle(double degrees)
{
  const double now = this->GetFieldOfViewAngle();
  const double h = this->GetHorizontalFieldOfView();
  const double v = this->GetVerticalFieldOfView();
  if (this->Definition->Axis == wfv::Family::Planar)
  {
    // the sides of the picture keep their proportion, as with vtkCamera
    const auto half = [](double angle) {
      return std::tan(vtkMath::RadiansFromDegrees(0.5 * angle));
    };
    const auto scaled = [&](double angle) {
      const double t = half(angle) * half(degrees) / half(now);
      return 2 * vtkMath::DegreesFromRadians(std::atan(t));
    };
    const double wide = degrees < 180 ? scaled(h) : degrees;
    const double high = degrees < 180 ? scaled(v) : degrees;
    SetBothFields(this, *this->Definition, wide, high);
    return;
  }
  SetBothFields(this, *this->Definition, h * degrees / now, v * degrees / now);
}

double vtkWideFoVCamera::GetViewAngle()
{
  if (Internals::FramesInDrawing == 0 || !this->IsWide())
  {
    return this->ViewAngle;
  }
  // a perspective as high as the picture whose pixels in the middle are under the angle of this
  // one's
  const double half = 0.5 * vtkMath::RadiansFromDegrees(this->GetFieldOfViewAngle());
  return vtkMath::DegreesFromRadians(2 * std::atan(half));
}

void vtkWideFoVCamera::SetNothingBehind(bool nothing)
{
  this->Internal->NothingBehind = nothing;
}

double* vtkWideFoVCamera::GetViewPlaneNormal()
{
  static double none[3] = { 0, 0, 0 };
  return this->Internal->NothingBehind ? none : this->ViewPlaneNormal;
}

vtkMatrix4x4* vtkWideFoVCamera::GetCompositeProjectionTransformMatrix(
  double aspect, double nearz, double farz)
{
  const bool ofPicture = Internals::FramesInDrawing == 0 && nearz == 0 && this->IsWide();
  if (ofPicture && wfv::IsNews("camera matrix"))
  {
    vtkWarningMacro("a wide view has no matrix: what finds places by one, such as "
                    "vtkSelectVisiblePoints and vtkDepthImageToPointCloud, finds others than are "
                    "seen; ask WorldToNDC, NDCToWorld or the renderer's coordinates");
  }
  return this->Superclass::GetCompositeProjectionTransformMatrix(aspect, nearz, farz);
}

void vtkWideFoVCamera::GetPosition(double position[3])
{
  this->Superclass::GetPosition(position);
  this->Internal->Questions.AskPosition(position);
}

void vtkWideFoVCamera::GetFocalPoint(double point[3])
{
  this->Superclass::GetFocalPoint(point);
  this->Internal->Questions.AskFocalPoint(point);
}

void vtkWideFoVCamera::GetDirectionOfProjection(double direction[3])
{
  this->Superclass::GetDirectionOfProjection(direction);
  if (this->Internal->Questions.AskDirection())
  {
    std::fill_n(direction, 3, 0.0);
  }
}

double* vtkWideFoVCamera::GetClippingRange()
{
  double* const range = this->Internal->PickRange.data();
  return this->Internal->Questions.AskRange(range) ? range : this->Superclass::GetClippingRange();
}

wfv::FlatQuestions& vtkWideFoVCamera::GetFlatQuestions()
{
  return this->Internal->Questions;
}

void vtkWideFoVCamera::Zoom(double factor)
{
  if (factor > 0)
  {
    this->SetViewAngle(this->GetFieldOfViewAngle() / factor);
  }
}

void vtkWideFoVCamera::SetEyeSeparation(double distance)
{
  this->SetInterpupillaryDistance(distance);
}

double vtkWideFoVCamera::GetEyeSeparation()
{
  return this->GetInterpupillaryDistance();
}

void vtkWideFoVCamera::WarnOfFlatRenderer(vtkRenderer* renderer)
{
  if (this->Internal->InFrame || renderer->GetSelector())
  {
    return; // a wide frame is drawn, and says itself what it leaves out
  }
  vtkRenderPass* const pass = renderer->GetPass();
  const std::string name = pass ? pass->GetClassName() : "no pass";
  if (wfv::IsNews("flat " + name))
  {
    vtkWarningMacro(<< "what a renderer draws by " << name
                    << " is left out, for it would be flat: draw it by a vtkWideFoVPass, or by "
                       "mappers of the class vtkWideFoVPolyDataMapper");
  }
}

void vtkWideFoVCamera::WarnOfWhatIsIgnored(vtkRenderer* renderer)
{
  const bool tiled = IsTiled(renderer);
  const bool shifted = this->WindowCenter[0] != 0 || this->WindowCenter[1] != 0;
  const auto check = [this](bool set, const char* name, const char* instead) {
    if (set)
    {
      WarnOnce(this, name, instead);
    }
  };
  check(this->ParallelProjection != 0, "ParallelProjection", "");
  check(this->UserTransform != nullptr, "UserTransform", "; SetUserViewTransform works");
  // vtkRenderLargeImage sets both
  check(!tiled && shifted, "WindowCenter",
    "; for a large picture take vtkWindowToImageFilter, not vtkRenderLargeImage");
  check(!tiled && !shifted && std::abs(this->ViewAngle - StockViewAngle) > ViewAngleRounding,
    "ViewAngle, set by a pointer to vtkCamera,", "; call SetViewAngle or Zoom of vtkWideFoVCamera");
  check(this->ViewShear[0] != 0 || this->ViewShear[1] != 0, "ViewShear (or ObliqueAngles)", "");
  check(this->UseOffAxisProjection != 0, "UseOffAxisProjection",
    "; vtkWideFoVScreenCamera sees through a screen");
  check(this->UseExplicitProjectionTransformMatrix, "ExplicitProjectionTransformMatrix", "");
  check(this->EyeAngle != StockEyeAngle, "EyeAngle", "; see SetStereoModel");
}
