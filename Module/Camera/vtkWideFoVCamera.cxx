// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVCamera.h"

#include "Camera/CameraInternals.h"

#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPerspectiveTransform.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

vtkStandardNewMacro(vtkWideFoVCamera);

namespace
{
double ClampAngle(vtkObject* self, const char* what, double value, double least, double max)
{
  const double min = std::max(MinFieldOfView, least);
  const double clamped = std::isnan(value) ? max : std::clamp(value, min, max);
  if (clamped != value)
  {
    vtkWarningWithObjectMacro(self, << what << " " << value << " is outside [" << min << ", " << max
                                    << "] degrees; " << clamped << " is used");
  }
  return clamped;
}
}

vtkWideFoVCamera::vtkWideFoVCamera()
  : Internal(new Internals)
  , Definition(wfv::FindProjection("equirectangular"))
{
}

vtkWideFoVCamera::~vtkWideFoVCamera() = default;

void vtkWideFoVCamera::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const wfv::ViewOptions& o = this->Internal->Options;
  os << indent << "Projection: " << this->Definition->Name << "\n"
     << indent << "HorizontalFieldOfView: " << o.HorizontalFov << "\n"
     << indent << "VerticalFieldOfView: " << o.VerticalFov << "\n"
     << indent << "Tilt: " << o.Tilt << "\n"
     << indent << "ClipRadii: " << o.Radii[0] << ", " << o.Radii[1] << "\n"
     << indent << "DepthMapping: " << this->GetDepthMapping() << "\n"
     << indent << "DirectionMap: " << (o.Map ? "set" : "(none)") << "\n"
     << indent << "AutomaticClipRadii: " << this->AutomaticClipRadii << "\n"
     << indent << "ExactPerspective: " << this->ExactPerspective << "\n"
     << indent << "StereoModel: " << this->GetStereoModel() << "\n"
     << indent << "InterpupillaryDistance: " << o.Stereo.InterpupillaryDistance << "\n"
     << indent << "PoleFade: " << o.Stereo.PoleFade[0] << ", " << o.Stereo.PoleFade[1] << "\n"
     << indent << "WarpedStereo: " << o.Stereo.Iod << ", " << o.Stereo.Distance << ", "
     << o.Stereo.Offset << "\n"
     << indent << "Separation: " << o.Stereo.Separation << "\n"
     << indent << "Convergence: " << o.Stereo.Convergence << "\n"
     << indent << "CircleConvergence: " << o.Stereo.CircleConvergence << "\n"
     << indent << "Lens:";
  for (double c : o.Lens)
  {
    os << " " << c;
  }
  const wfv::MeasuredPicture& m = o.Measured;
  os << "\n"
     << indent << "MeasuredPicture: " << m.Size.x << " x " << m.Size.y << ", axis " << m.Axis.x
     << ", " << m.Axis.y << ", focal lengths " << m.Focal.x << ", " << m.Focal.y << "\n";
}

void vtkWideFoVCamera::CopyView(const vtkWideFoVCamera* source)
{
  this->Internal->Options = source->Internal->Options;
  this->Definition = source->Definition;
  this->AutomaticClipRadii = source->AutomaticClipRadii;
  this->ExactPerspective = source->ExactPerspective;
  this->Modified();
}

vtkObjectBase* vtkWideFoVCamera::NewInstanceInternal() const
{
  vtkWideFoVCamera* camera = vtkWideFoVCamera::New();
  camera->CopyView(this);
  return camera;
}

void vtkWideFoVCamera::ShallowCopy(vtkCamera* source)
{
  this->Superclass::ShallowCopy(source);
  if (auto* wide = vtkWideFoVCamera::SafeDownCast(source))
  {
    this->CopyView(wide);
  }
}

void vtkWideFoVCamera::DeepCopy(vtkCamera* source)
{
  this->Superclass::DeepCopy(source);
  if (auto* wide = vtkWideFoVCamera::SafeDownCast(source))
  {
    this->CopyView(wide);
  }
}

void vtkWideFoVCamera::SetProjection(const char* name)
{
  const wfv::Projection* found = name ? wfv::FindProjection(name) : nullptr;
  if (!found)
  {
    std::string known;
    for (const wfv::Projection* p : wfv::AllProjections())
    {
      known += " " + p->Name;
    }
    vtkErrorMacro(<< "No projection is named " << (name ? name : "(null)") << "; there are"
                  << known);
    return;
  }
  if (found == this->Definition)
  {
    return;
  }
  this->Definition = found;
  this->Modified();
  // clamped without a word: nobody asked for these with this projection
  wfv::ViewOptions& o = this->Internal->Options;
  const auto fit = [](double v, double min, double max) {
    return std::clamp(v, std::max(MinFieldOfView, min), max);
  };
  this->SetHorizontalFieldOfView(
    fit(o.HorizontalFov, found->MinHorizontalFov, found->MaxHorizontalFov));
  this->SetVerticalFieldOfView(fit(o.VerticalFov, found->MinVerticalFov, found->MaxVerticalFov));
}

const char* vtkWideFoVCamera::GetProjection()
{
  return this->Definition->Name.c_str();
}

int vtkWideFoVCamera::GetNumberOfProjections()
{
  return static_cast<int>(wfv::AllProjections().size());
}

const char* vtkWideFoVCamera::GetProjectionName(int index)
{
  const bool known = index >= 0 && index < vtkWideFoVCamera::GetNumberOfProjections();
  return known ? wfv::AllProjections()[index]->Name.c_str() : nullptr;
}

void vtkWideFoVCamera::SetHorizontalFieldOfView(double degrees)
{
  const double v = ClampAngle(this, "Horizontal field of view", degrees,
    this->Definition->MinHorizontalFov, this->Definition->MaxHorizontalFov);
  wfv::ViewOptions& o = this->Internal->Options;
  if (v == o.HorizontalFov)
  {
    return;
  }
  o.HorizontalFov = v;
  this->Modified();
  const bool lens = o.Lens[0] != 0;
  if (lens && !wfv::LensFits(*this->Definition, o.Lens, vtkMath::RadiansFromDegrees(0.5 * v)))
  {
    vtkWarningMacro(<< "The lens does not grow up to half of " << v << " degrees; it is removed");
    this->ClearLens();
  }
}

double vtkWideFoVCamera::GetHorizontalFieldOfView()
{
  return this->Internal->Options.HorizontalFov;
}

void vtkWideFoVCamera::SetVerticalFieldOfView(double degrees)
{
  const double v = ClampAngle(this, "Vertical field of view", degrees,
    this->Definition->MinVerticalFov, this->Definition->MaxVerticalFov);
  if (v != this->Internal->Options.VerticalFov)
  {
    this->Internal->Options.VerticalFov = v;
    this->Modified();
  }
}

double vtkWideFoVCamera::GetVerticalFieldOfView()
{
  return this->Internal->Options.VerticalFov;
}

void vtkWideFoVCamera::SetFieldOfView(double degrees)
{
  this->SetHorizontalFieldOfView(degrees);
  this->SetVerticalFieldOfView(
    std::clamp(degrees, this->Definition->MinVerticalFov, this->Definition->MaxVerticalFov));
}

void vtkWideFoVCamera::SetTilt(double degrees)
{
  const double v = std::isnan(degrees) ? 0 : std::clamp(degrees, -180.0, 180.0);
  if (v != degrees)
  {
    vtkWarningMacro(<< "Tilt " << degrees << " is outside [-180, 180] degrees; " << v
                    << " is used");
  }
  if (v != this->Internal->Options.Tilt)
  {
    this->Internal->Options.Tilt = v;
    this->Modified();
  }
}

void vtkWideFoVCamera::SetDepthMapping(int mapping)
{
  const auto v = static_cast<wfv::DepthMapping>(
    std::clamp(mapping, static_cast<int>(LINEAR), static_cast<int>(REVERSED)));
  if (v != this->Internal->Options.Mapping)
  {
    this->Internal->Options.Mapping = v;
    this->Modified();
  }
}

int vtkWideFoVCamera::GetDepthMapping()
{
  return static_cast<int>(this->Internal->Options.Mapping);
}

double vtkWideFoVCamera::GetTilt()
{
  return this->Internal->Options.Tilt;
}
