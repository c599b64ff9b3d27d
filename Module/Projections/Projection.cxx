// SPDX-License-Identifier: BSD-3-Clause
#include "Projection.h"

#include "WideFoVGlsl.h"

#define float double
namespace wfv
{
namespace equirectangular
{
#include "equirectangular.glsl"
}
namespace hammer
{
#include "hammer.glsl"
}
namespace azimuthal_equidistant
{
#include "azimuthal-equidistant.glsl"
}
namespace perspective
{
#include "perspective.glsl"
}
}
#undef float

#define WFV_FUNCTIONS(ns)                                                                          \
  p.Map = ns::wfvMap;                                                                              \
  p.Project = ns::wfvProject;                                                                      \
  p.Unproject = ns::wfvUnproject;                                                                  \
  p.Bounds = ns::wfvBounds

namespace wfv
{
namespace
{
const double Degree = WFV_PI / 180;

// Largest field of view of the perspective, degrees: beyond it a pixel's tangent
// leaves what float32 can tell apart.
constexpr double MaxPerspective = 179;

Projection Equirectangular()
{
  Projection p;
  p.Name = "equirectangular";
  p.Title = "Equirectangular";
  p.Properties = "equidistant";
  p.UnboundedPoles = true;
  p.Glsl = equirectangular_glsl;
  WFV_FUNCTIONS(equirectangular);
  return p;
}

Projection Hammer()
{
  Projection p;
  p.Name = "hammer";
  p.Title = "Hammer";
  p.Properties = "equal-area";
  p.StraightSeam = false;
  p.Glsl = hammer_glsl;
  WFV_FUNCTIONS(hammer);
  return p;
}

Projection AzimuthalEquidistant()
{
  Projection p;
  p.Name = "azimuthal-equidistant";
  p.Title = "Azimuthal equidistant (fisheye, dome)";
  p.Properties = "equidistant";
  p.Axis = Family::Azimuthal;
  p.MaxVerticalFov = 360;
  p.HasLens = true;
  p.StraightSeam = false;
  p.UnboundedPoles = true;
  p.Glsl = azimuthal_equidistant_glsl;
  WFV_FUNCTIONS(azimuthal_equidistant);
  return p;
}

Projection Perspective()
{
  Projection p;
  p.Name = "perspective";
  p.Title = "Perspective";
  p.Properties = "straight-lines";
  p.Axis = Family::Planar;
  p.MaxHorizontalFov = MaxPerspective;
  p.MaxVerticalFov = MaxPerspective;
  p.Glsl = perspective_glsl;
  WFV_FUNCTIONS(perspective);
  return p;
}

bool HasLens(const std::array<double, 5>& lens)
{
  for (double c : lens)
  {
    if (c != 0)
    {
      return true;
    }
  }
  return false;
}
}

const std::vector<Projection>& Projections()
{
  static const std::vector<Projection> all{ Equirectangular(), Hammer(), AzimuthalEquidistant(),
    Perspective() };
  return all;
}

const Projection* FindProjection(const std::string& name)
{
  for (const Projection& p : Projections())
  {
    if (p.Name == name)
    {
      return &p;
    }
  }
  return nullptr;
}

const char* CommonGlsl()
{
  return common_glsl;
}

const char* DepthGlsl()
{
  return depth_glsl;
}

const char* MathGlsl()
{
  return glsl_math_glsl;
}

bool LensIsMonotone(const std::array<double, 5>& lens, double maxAngle)
{
  // The slope is a quartic: its sign is checked on a grid far finer than its four
  // roots can hide in for any lens that exists.
  constexpr int Steps = 4096;
  for (int i = 0; i <= Steps; i++)
  {
    const double t = maxAngle * i / Steps;
    const double slope =
      lens[0] + t * (2 * lens[1] + t * (3 * lens[2] + t * (4 * lens[3] + t * 5 * lens[4])));
    if (!(slope > 0) || !std::isfinite(slope))
    {
      return false;
    }
  }
  return true;
}

namespace
{
std::string Text(double v)
{
  std::string s = std::to_string(v);
  s.erase(s.find_last_not_of('0') + 1);
  return s.back() == '.' ? s.substr(0, s.size() - 1) : s;
}

std::string CheckFov(
  const std::string& which, const std::string& projection, double degrees, double max)
{
  if (degrees > 0 && degrees <= max)
  {
    return "";
  }
  return "the " + which + " field of view of " + projection + " must be above 0 and at most " +
    Text(max) + " degrees, not " + Text(degrees);
}

std::string CheckLens(const Projection& p, const ViewOptions& o)
{
  if (!HasLens(o.Lens))
  {
    return "";
  }
  if (!p.HasLens)
  {
    return p.Name + " takes no lens; azimuthal-equidistant does";
  }
  const bool fits = LensIsMonotone(o.Lens, 0.5 * o.HorizontalFov * Degree);
  return fits ? "" : "the lens polynomial does not grow everywhere up to half the field of view";
}
}

std::string CheckOptions(const Projection& p, const ViewOptions& o)
{
  for (const std::string& problem :
    { CheckFov("horizontal", p.Name, o.HorizontalFov, p.MaxHorizontalFov),
      CheckFov("vertical", p.Name, o.VerticalFov, p.MaxVerticalFov), CheckLens(p, o) })
  {
    if (!problem.empty())
    {
      return problem;
    }
  }
  if (!std::isfinite(o.Tilt))
  {
    return "the tilt must be a finite number of degrees";
  }
  if (!(o.Radii[0] > 0) || !(o.Radii[1] > o.Radii[0]) || !std::isfinite(o.Radii[1]))
  {
    return "the clip spheres need 0 < near < far, not " + Text(o.Radii[0]) + " and " +
      Text(o.Radii[1]);
  }
  return "";
}

View::View(const Projection& projection, const ViewOptions& o)
  : Map(&projection)
{
  WfvView& v = this->Parameters;
  v.halfFov = vec2(0.5 * o.HorizontalFov * Degree, 0.5 * o.VerticalFov * Degree);
  v.tilt = vec2(std::cos(o.Tilt * Degree), std::sin(o.Tilt * Degree));
  v.radii = vec2(o.Radii[0], o.Radii[1]);
  v.lens = vec4(o.Lens[0], o.Lens[1], o.Lens[2], o.Lens[3]);
  v.lens5 = o.Lens[4];
  v.maxAngle = v.halfFov.x;
  v.depthMapping = static_cast<int>(o.Mapping);
  v.scale = vec2(1, 1);
  if (projection.Axis == Family::Azimuthal)
  {
    // theta = fov/2 has r = 1, or r as the lens says; a circle stays a circle
    const double rim = HasLens(o.Lens) ? 1 : projection.Map(vec2(0, v.maxAngle), v).x;
    v.scale = vec2(std::min(1.0, 1 / o.Aspect) / rim, std::min(1.0, o.Aspect) / rim);
    return;
  }
  const double x = projection.Map(vec2(v.halfFov.x, 0), v).x;
  const double y = projection.Map(vec2(0, v.halfFov.y), v).y;
  v.scale = vec2(1 / x, 1 / y);
}

NdcPoint View::Forward(vec3 point) const
{
  const WfvView& v = this->Parameters;
  const vec3 p = wfvTilt(point, v);
  const double rho = std::hypot(std::hypot(p.x, p.y), p.z);
  NdcPoint result{ vec3(0, 0, 2 * wfvDepthOf(rho, v) - 1), false };
  const bool behind = this->Map->Axis == Family::Planar && !(p.z < 0);
  if (!(rho > 0) || !std::isfinite(rho) || behind)
  {
    return result;
  }
  const vec2 xy = this->Map->Project(p / rho, v);
  result.Ndc.x = xy.x;
  result.Ndc.y = xy.y;
  result.Inside = std::abs(xy.x) <= 1 && std::abs(xy.y) <= 1 && std::abs(result.Ndc.z) <= 1 &&
    this->Map->Unproject(xy, v).inside;
  return result;
}

ViewRay View::Ray(vec2 ndc) const
{
  const WfvRay ray = this->Map->Unproject(ndc, this->Parameters);
  return { vec3(0, 0, 0), wfvUntilt(ray.direction, this->Parameters), ray.inside };
}
}
