// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVCamera.h"

#include "Projections/Projection.h"

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
// Smallest field of view, degrees: below it float32 cannot tell pixels apart.
constexpr double MinFieldOfView = 0.01;

// Near over far of the automatic clip spheres, where the bounds reach the eye. Depth
// is linear in the distance, so this costs no precision far away; it only keeps the
// eye itself out.
constexpr double NearOverFar = 1e-4;

// Room, relative, that the automatic clip spheres leave beyond the bounds.
constexpr double ClipMargin = 1e-3;

double ClampAngle(vtkObject* self, const char* what, double value, double max)
{
  const double clamped = std::isnan(value) ? max : std::clamp(value, MinFieldOfView, max);
  if (clamped != value)
  {
    vtkWarningWithObjectMacro(self,
      << what << " " << value << " is outside [" << MinFieldOfView << ", " << max
      << "] degrees; " << clamped << " is used");
  }
  return clamped;
}

// Distances from a point to the nearest and farthest point of a box.
void DistanceToBounds(const double p[3], const double b[6], double& nearest, double& farthest)
{
  double near2 = 0;
  double far2 = 0;
  for (int i = 0; i < 3; i++)
  {
    const double low = b[2 * i] - p[i];
    const double high = p[i] - b[2 * i + 1];
    const double outside = std::max({ low, high, 0.0 });
    const double reach = std::max(std::abs(low), std::abs(high));
    near2 += outside * outside;
    far2 += reach * reach;
  }
  nearest = std::sqrt(near2);
  farthest = std::sqrt(far2);
}
}

struct vtkWideFoVCamera::Internals
{
  wfv::ViewOptions Options;
  std::optional<wfv::View> Cache;
  double CacheAspect = 0;
  vtkMTimeType CacheTime = 0;
  vtkTimeStamp MatrixTime;
  vtkRenderer* MatrixRenderer = nullptr;
};

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
     << indent << "AutomaticClipRadii: " << this->AutomaticClipRadii << "\n"
     << indent << "Lens:";
  for (double c : o.Lens)
  {
    os << " " << c;
  }
  os << "\n";
}

void vtkWideFoVCamera::CopyView(const vtkWideFoVCamera* source)
{
  this->Internal->Options = source->Internal->Options;
  this->Definition = source->Definition;
  this->AutomaticClipRadii = source->AutomaticClipRadii;
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
    for (const wfv::Projection& p : wfv::Projections())
    {
      known += " " + p.Name;
    }
    vtkErrorMacro(<< "No projection is named " << (name ? name : "(null)") << "; there are" << known);
    return;
  }
  if (found == this->Definition)
  {
    return;
  }
  this->Definition = found;
  this->Modified();
  this->SetHorizontalFieldOfView(this->Internal->Options.HorizontalFov);
  this->SetVerticalFieldOfView(this->Internal->Options.VerticalFov);
}

const char* vtkWideFoVCamera::GetProjection()
{
  return this->Definition->Name.c_str();
}

int vtkWideFoVCamera::GetNumberOfProjections()
{
  return static_cast<int>(wfv::Projections().size());
}

const char* vtkWideFoVCamera::GetProjectionName(int index)
{
  const bool known = index >= 0 && index < vtkWideFoVCamera::GetNumberOfProjections();
  return known ? wfv::Projections()[index].Name.c_str() : nullptr;
}

void vtkWideFoVCamera::SetHorizontalFieldOfView(double degrees)
{
  const double v =
    ClampAngle(this, "Horizontal field of view", degrees, this->Definition->MaxHorizontalFov);
  wfv::ViewOptions& o = this->Internal->Options;
  if (v == o.HorizontalFov)
  {
    return;
  }
  o.HorizontalFov = v;
  this->Modified();
  const bool lens = o.Lens[0] != 0;
  if (lens && !wfv::LensIsMonotone(o.Lens, vtkMath::RadiansFromDegrees(0.5 * v)))
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
  const double v =
    ClampAngle(this, "Vertical field of view", degrees, this->Definition->MaxVerticalFov);
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
  this->SetVerticalFieldOfView(std::min(degrees, this->Definition->MaxVerticalFov));
}

void vtkWideFoVCamera::SetTilt(double degrees)
{
  const double v = std::isnan(degrees) ? 0 : std::clamp(degrees, -180.0, 180.0);
  if (v != degrees)
  {
    vtkWarningMacro(<< "Tilt " << degrees << " is outside [-180, 180] degrees; " << v << " is used");
  }
  if (v != this->Internal->Options.Tilt)
  {
    this->Internal->Options.Tilt = v;
    this->Modified();
  }
}

double vtkWideFoVCamera::GetTilt()
{
  return this->Internal->Options.Tilt;
}

bool vtkWideFoVCamera::SetLens(double c1, double c2, double c3, double c4, double c5)
{
  const std::array<double, 5> lens{ { c1, c2, c3, c4, c5 } };
  const double rim = vtkMath::RadiansFromDegrees(0.5 * this->Internal->Options.HorizontalFov);
  if (!wfv::LensIsMonotone(lens, rim))
  {
    vtkErrorMacro(<< "The lens " << c1 << ", " << c2 << ", " << c3 << ", " << c4 << ", " << c5
                  << " does not grow everywhere up to half the field of view; it is refused");
    return false;
  }
  this->Internal->Options.Lens = lens;
  this->Modified();
  return true;
}

void vtkWideFoVCamera::ClearLens()
{
  this->Internal->Options.Lens.fill(0);
  this->Modified();
}

void vtkWideFoVCamera::GetLens(double coefficients[5])
{
  std::copy_n(this->Internal->Options.Lens.begin(), 5, coefficients);
}

void vtkWideFoVCamera::SetClipRadii(double nearRadius, double farRadius)
{
  if (!(nearRadius > 0) || !(farRadius > nearRadius) || !std::isfinite(farRadius))
  {
    vtkErrorMacro(<< "The clip spheres need 0 < near < far, not " << nearRadius << " and "
                  << farRadius << "; they are unchanged");
    return;
  }
  this->AutomaticClipRadii = 0;
  this->Internal->Options.Radii = { { nearRadius, farRadius } };
  this->Modified();
}

void vtkWideFoVCamera::GetClipRadii(double radii[2])
{
  std::copy_n(this->Internal->Options.Radii.begin(), 2, radii);
}

double vtkWideFoVCamera::GetNearClipRadius()
{
  return this->Internal->Options.Radii[0];
}

double vtkWideFoVCamera::GetFarClipRadius()
{
  return this->Internal->Options.Radii[1];
}

void vtkWideFoVCamera::ResetClipRadii(const double bounds[6])
{
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    return;
  }
  double nearest;
  double farthest;
  DistanceToBounds(this->GetPosition(), bounds, nearest, farthest);
  if (!(farthest > 0) || !std::isfinite(farthest))
  {
    return;
  }
  const double f = farthest * (1 + ClipMargin);
  const double n = std::max(nearest * (1 - ClipMargin), NearOverFar * f);
  std::array<double, 2>& radii = this->Internal->Options.Radii;
  if (n != radii[0] || f != radii[1])
  {
    radii = { { n, f } };
    this->Modified();
    if (this->IsWide())
    {
      // for those who know no clip spheres
      this->SetClippingRange(n, f);
    }
  }
}

bool vtkWideFoVCamera::IsWide()
{
  return this->Definition->Axis != wfv::Family::Planar;
}

const wfv::View& vtkWideFoVCamera::GetView(double aspect)
{
  Internals& in = *this->Internal;
  if (!in.Cache || in.CacheAspect != aspect || in.CacheTime < this->GetMTime())
  {
    wfv::ViewOptions options = in.Options;
    options.Aspect = aspect;
    if (!this->Definition->HasLens)
    {
      options.Lens.fill(0);
    }
    in.Cache.emplace(*this->Definition, options);
    in.CacheAspect = aspect;
    in.CacheTime = this->GetMTime();
  }
  return *in.Cache;
}

bool vtkWideFoVCamera::WorldToNDC(const double world[3], double aspect, double ndc[3])
{
  double p[4] = { world[0], world[1], world[2], 1 };
  this->GetModelViewTransformMatrix()->MultiplyPoint(p, p);
  const wfv::NdcPoint q = this->GetView(aspect).Forward(wfv::vec3(p[0], p[1], p[2]));
  ndc[0] = q.Ndc.x;
  ndc[1] = q.Ndc.y;
  ndc[2] = q.Ndc.z;
  return q.Inside;
}

bool vtkWideFoVCamera::NDCToWorld(const double ndc[3], double aspect, double world[3])
{
  double origin[3];
  double direction[3];
  const bool inside = this->NDCToRay(ndc, aspect, origin, direction);
  const std::array<double, 2>& radii = this->Internal->Options.Radii;
  const double rho = radii[0] + 0.5 * (ndc[2] + 1) * (radii[1] - radii[0]);
  for (int i = 0; i < 3; i++)
  {
    world[i] = origin[i] + rho * direction[i];
  }
  return inside;
}

bool vtkWideFoVCamera::NDCToRay(
  const double ndc[2], double aspect, double origin[3], double direction[3])
{
  const wfv::ViewRay ray = this->GetView(aspect).Ray(wfv::vec2(ndc[0], ndc[1]));
  double o[4] = { ray.Origin.x, ray.Origin.y, ray.Origin.z, 1 };
  double d[4] = { ray.Direction.x, ray.Direction.y, ray.Direction.z, 0 };
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(this->GetModelViewTransformMatrix(), inverse);
  inverse->MultiplyPoint(o, o);
  inverse->MultiplyPoint(d, d);
  vtkMath::Normalize(d);
  std::copy_n(o, 3, origin);
  std::copy_n(d, 3, direction);
  return ray.Inside;
}

void vtkWideFoVCamera::PrepareFrame(vtkRenderer* renderer)
{
  if (this->AutomaticClipRadii)
  {
    double bounds[6];
    renderer->ComputeVisiblePropBounds(bounds);
    this->ResetClipRadii(bounds);
  }
}

void vtkWideFoVCamera::Render(vtkRenderer* renderer)
{
  this->PrepareFrame(renderer);
  this->Superclass::Render(renderer);
}

void vtkWideFoVCamera::UpdateViewport(vtkRenderer* renderer)
{
  this->PrepareFrame(renderer);
  this->Superclass::UpdateViewport(renderer);
}

void vtkWideFoVCamera::GetKeyMatrices(vtkRenderer* renderer, vtkMatrix4x4*& wcvc,
  vtkMatrix3x3*& normals, vtkMatrix4x4*& vcdc, vtkMatrix4x4*& wcdc)
{
  this->Superclass::GetKeyMatrices(renderer, wcvc, normals, vcdc, wcdc);
  if (!this->IsWide())
  {
    return;
  }
  // Stock mappers then write view coordinates to gl_Position; the stages that the
  // pass adds do the rest.
  vcdc->Identity();
  wcdc->DeepCopy(wcvc);
}

void vtkWideFoVCamera::ComputeProjectionTransform(double aspect, double nearz, double farz)
{
  if (this->IsWide())
  {
    this->Superclass::ComputeProjectionTransform(aspect, nearz, farz);
    return;
  }
  // The planes touch the clip spheres: near at the corner of the picture, far on the axis.
  const wfv::ViewOptions& o = this->Internal->Options;
  const double tx = std::tan(vtkMath::RadiansFromDegrees(0.5 * o.HorizontalFov));
  const double ty = std::tan(vtkMath::RadiansFromDegrees(0.5 * o.VerticalFov));
  const double n = o.Radii[0] / std::sqrt(1 + tx * tx + ty * ty);
  this->ProjectionTransform->Identity();
  this->ProjectionTransform->AdjustZBuffer(-1, +1, nearz, farz);
  this->ProjectionTransform->Frustum(-n * tx, n * tx, -n * ty, n * ty, n, o.Radii[1]);
}

void vtkWideFoVCamera::GetFrustumPlanes(double aspect, double planes[24])
{
  if (!this->IsWide())
  {
    this->Superclass::GetFrustumPlanes(aspect, planes);
    return;
  }
  // Six planes that everything is in front of: cullers that think in a linear
  // frustum must drop nothing.
  std::fill_n(planes, 24, 0.0);
  for (int i = 0; i < 6; i++)
  {
    planes[4 * i + 3] = std::numeric_limits<float>::max();
  }
}
