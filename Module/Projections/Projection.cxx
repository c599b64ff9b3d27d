// SPDX-License-Identifier: BSD-3-Clause
#include "Projection.h"

#include "Bounds/Curvature.h"
#include "DirectionMap.h"
#include "NumberText.h"
#include "StereoModel.h"

#include <algorithm>

namespace wfv
{
namespace
{
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

const Projection* FindProjection(const std::string& name)
{
  for (const Projection* p : AllProjections())
  {
    if (p->Name == name)
    {
      return p;
    }
  }
  return nullptr;
}

std::vector<const Projection*> AllProjections()
{
  std::vector<const Projection*> all;
  for (const Projection& p : Projections())
  {
    all.push_back(&p);
  }
  all.push_back(&SampledProjection());
  return all;
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
std::string CheckFov(
  const std::string& which, const Projection& p, double degrees, double min, double max)
{
  if (degrees > 0 && degrees >= min && degrees <= max)
  {
    return "";
  }
  const std::string range = min < max ? "above 0 and at most " + NumberText(max) : NumberText(max);
  const std::string why = p.Limit.empty() ? "" : " (" + p.Limit + ")";
  return "the " + which + " field of view of " + p.Name + " must be " + range + " degrees, not " +
    NumberText(degrees) + why;
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
  const bool fits = LensIsMonotone(o.Lens, glm::radians(0.5 * o.HorizontalFov));
  return fits ? "" : "the lens polynomial does not grow everywhere up to half the field of view";
}
}

std::string CheckOptions(const Projection& p, const ViewOptions& o)
{
  for (const std::string& problem :
    { CheckFov("horizontal", p, o.HorizontalFov, p.MinHorizontalFov, p.MaxHorizontalFov),
      CheckFov("vertical", p, o.VerticalFov, p.MinVerticalFov, p.MaxVerticalFov), CheckLens(p, o) })
  {
    if (!problem.empty())
    {
      return problem;
    }
  }
  if (o.Stereo.Model)
  {
    const std::string problem = o.Stereo.Model->Check(o.Stereo, p);
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
    return "the clip spheres need 0 < near < far, not " + NumberText(o.Radii[0]) + " and " +
      NumberText(o.Radii[1]);
  }
  return "";
}

namespace
{
// Angle from the axis of a perspective to the corners of its picture, radians.
double CornerAngle(const vec2& halfFov)
{
  return std::atan(glm::length(glm::tan(halfFov)));
}
}

bool FitsFrame(const ViewOptions& o)
{
  const vec2 half = 0.5 * glm::radians(vec2(o.HorizontalFov, o.VerticalFov));
  const double most = 0.5 * glm::radians(FramedPerspective().MaxHorizontalFov);
  return o.Center == vec2(0) && CornerAngle(half) <= most;
}

namespace
{
// NDC per unit of the raw map.
vec2 Scale(const Projection& p, const ViewOptions& o, const WfvView& v)
{
  switch (p.Axis)
  {
    case Family::Azimuthal:
    {
      if (p.Framed)
      {
        return 1.0 / glm::tan(v.halfFov);
      }
      // theta = fov/2 has r = 1, or r as the lens says; a circle stays a circle
      const double rim = HasLens(o.Lens) ? 1 : p.Map(vec2(0, v.maxAngle), v).x;
      return vec2(std::min(1.0, 1 / o.Aspect) / rim, std::min(1.0, o.Aspect) / rim);
    }
    case Family::Faces:
    case Family::Sampled:
      return vec2(1, 1);
    default:
      return vec2(1 / p.Map(vec2(v.halfFov.x, 0), v).x, 1 / p.Map(vec2(0, v.halfFov.y), v).y);
  }
}
}

namespace
{
// In place of a direction map that nobody has set.
std::shared_ptr<const DirectionMap> NothingToSee()
{
  static const auto map = std::make_shared<const DirectionMap>(2, 2, std::vector<float>(12, 0.f));
  return map;
}
}

View::View(const Projection& projection, const ViewOptions& o)
  : Map(&projection)
  , Stereo(o.Stereo.Model)
  , Tables(projection.Axis == Family::Sampled && !o.Map ? NothingToSee() : o.Map)
  , Center(projection.Axis == Family::Planar ? o.Center : vec2(0))
{
  WfvView& v = this->Parameters;
  v.map = this->Tables.get();
  v.tables = v.map ? v.map->GetSizes() : vec4(0);
  v.halfFov = glm::radians(vec2(0.5 * o.HorizontalFov, 0.5 * o.VerticalFov));
  v.tilt = vec2(std::cos(glm::radians(o.Tilt)), std::sin(glm::radians(o.Tilt)));
  v.radii = vec2(o.Radii[0], o.Radii[1]);
  v.lens = vec4(o.Lens[0], o.Lens[1], o.Lens[2], o.Lens[3]);
  v.lens5 = o.Lens[4];
  v.maxAngle = projection.Framed ? CornerAngle(v.halfFov) : v.halfFov.x;
  v.depthMapping = static_cast<int>(o.Mapping);
  v.scale = vec2(1, 1);
  v.scale = Scale(projection, o, v);
  v.curvature = Curvature(projection, v);
  v.eye = static_cast<int>(o.Stereo.Eye);
  const StereoParameters both =
    this->Stereo ? this->Stereo->Parameters(o.Stereo, v) : StereoParameters();
  v.halfEyes = both.HalfEyes;
  v.stereo = both.Others;
}

namespace
{
// The cube ends with the window; other pictures go on beyond it.
bool InCube(const StereoModel* model, const vec2& place)
{
  return !model || model->Traits.StraightRays || (std::abs(place.x) <= 1 && std::abs(place.y) <= 1);
}
}

NdcPoint View::Forward(vec3 point) const
{
  const WfvView& v = this->Parameters;
  const vec3 p = wfvTilt(point, v);
  const WfvRayHit hit = this->Stereo ? this->Stereo->See(p, v) : wfvRayHitFrom(p, vec3(0));
  NdcPoint result{ vec3(0, 0, 2 * wfvDepthOf(hit.distance, v) - 1), false };
  const bool behind = this->Map->Axis == Family::Planar && !(hit.direction.z < 0);
  if (!(hit.distance > 0) || !std::isfinite(hit.distance) || behind)
  {
    return result;
  }
  vec2 xy = this->Map->Project(hit.direction, v);
  if (v.map && std::abs(xy.x) > 1)
  {
    xy = v.map->Find(hit.direction);
  }
  const bool shown = this->Map->Unproject(xy, v).inside && InCube(this->Stereo, xy);
  xy = (this->Stereo ? this->Stereo->Shift(xy, result.Ndc.z, v) : xy) + this->Center;
  result.Ndc.x = xy.x;
  result.Ndc.y = xy.y;
  result.Inside =
    hit.seen && std::abs(xy.x) <= 1 && std::abs(xy.y) <= 1 && std::abs(result.Ndc.z) <= 1 && shown;
  return result;
}

ViewRay View::Ray(vec2 ndc) const
{
  const WfvView& v = this->Parameters;
  return this->RayAt(vec3(ndc.x, ndc.y, this->Stereo ? this->Stereo->DepthWithoutParallax(v) : 0));
}

ViewRay View::RayAt(vec3 ndc) const
{
  const WfvView& v = this->Parameters;
  const vec2 at = vec2(ndc.x, ndc.y) - this->Center;
  const vec2 place = this->Stereo ? this->Stereo->Unshift(at, ndc.z, v) : at;
  const WfvRay ray = this->Map->Unproject(place, v);
  const vec3 eye = this->Stereo ? this->Stereo->EyeAt(ray.direction, v) : vec3(0);
  return { wfvUntilt(eye, v), wfvUntilt(ray.direction, v),
    ray.inside && InCube(this->Stereo, place) };
}
}
