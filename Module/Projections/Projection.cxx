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
bool HasLens(const LensCoefficients& lens)
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

bool LensIsMonotone(const LensCoefficients& lens, double most)
{
  // The slope is of the eighth degree: its sign is checked on a grid far finer than its
  // roots can hide in for any lens that exists.
  constexpr int Steps = 4096;
  for (int i = 0; i <= Steps; i++)
  {
    const double t = most * i / Steps;
    double slope = 0;
    for (std::size_t k = lens.size(); k > 0; k--)
    {
      slope = slope * t + double(k) * lens[k - 1];
    }
    if (!(slope > 0) || !std::isfinite(slope))
    {
      return false;
    }
  }
  return true;
}

namespace
{
// What the lens of these options is to a view.
void SetLens(WfvView& v, const LensCoefficients& lens)
{
  v.lens = vec4(lens[0], lens[1], lens[2], lens[3]);
  v.lens5 = lens[4];
  v.lensHigh = vec4(lens[5], lens[6], lens[7], lens[8]);
}

double RadiusThrough(const Projection& p, const LensCoefficients& lens, double end, double theta)
{
  WfvView v{};
  v.scale = vec2(1, 1);
  v.maxAngle = end;
  SetLens(v, lens);
  return p.Map(vec2(0, theta), v).x;
}
}

bool LensFits(const Projection& p, const LensCoefficients& lens, double maxAngle)
{
  return LensIsMonotone(lens, RadiusThrough(p, {}, maxAngle, maxAngle));
}

double RadiusAt(const Projection& p, const ViewOptions& o, double theta)
{
  return RadiusThrough(p, o.Lens, glm::radians(0.5 * o.HorizontalFov), theta);
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

// Of a picture that was measured: its longer side, pixels; its focal lengths, in its sides, and how
// far beside it the axis is, likewise. Beyond there float32 tells no pixels apart.
constexpr double MostPixels = 1e6;
constexpr double LeastFocal = 1e-3;
constexpr double MostAside = 10;

std::string CheckLens(const Projection& p, const ViewOptions& o)
{
  if (!HasLens(o.Lens))
  {
    return "";
  }
  if (!p.HasLens)
  {
    return p.Name + " takes no lens; azimuthal-equidistant and brown-conrady do";
  }
  const bool fits = LensFits(p, o.Lens, glm::radians(0.5 * o.HorizontalFov));
  return fits ? "" : "the lens polynomial does not grow everywhere up to half the field of view";
}

std::string CheckMeasured(const Projection& p, const ViewOptions& o)
{
  const MeasuredPicture& m = o.Measured;
  if (m.Size == vec2(0))
  {
    return "";
  }
  if (p.Axis != Family::Azimuthal)
  {
    return p.Name + " has no circle to be put anywhere; round projections do";
  }
  if (o.Stereo.Model && !o.Stereo.Model->Traits.StraightRays)
  {
    return "the stereo model " + o.Stereo.Model->Name + " needs the axis in the middle";
  }
  const auto good = [](double v, double least, double most) { return v >= least && v <= most; };
  for (int i = 0; i < 2; i++)
  {
    if (!good(m.Size[i], 1, MostPixels))
    {
      return "the measured picture must be 1 to " + NumberText(MostPixels) +
        " pixels wide and high, not " + NumberText(m.Size[i]);
    }
    if (!good(m.Focal[i] / m.Size[i], LeastFocal, 1 / LeastFocal))
    {
      return "the focal length must be " + NumberText(LeastFocal) + " to " +
        NumberText(1 / LeastFocal) + " times the size of its picture, not " +
        NumberText(m.Focal[i]) + " of " + NumberText(m.Size[i]) + " pixels";
    }
    if (!good(m.Axis[i] / m.Size[i], -MostAside, 1 + MostAside))
    {
      return "the principal point must be at most " + NumberText(MostAside) +
        " pictures beside its picture, not at " + NumberText(m.Axis[i]) + " of " +
        NumberText(m.Size[i]) + " pixels";
    }
  }
  return "";
}
}

std::string CheckOptions(const Projection& p, const ViewOptions& o)
{
  for (const std::string& problem :
    { CheckFov("horizontal", p, o.HorizontalFov, p.MinHorizontalFov, p.MaxHorizontalFov),
      CheckFov("vertical", p, o.VerticalFov, p.MinVerticalFov, p.MaxVerticalFov), CheckLens(p, o),
      CheckMeasured(p, o) })
  {
    if (!problem.empty())
    {
      return problem;
    }
  }
  if (o.Stereo.Model)
  {
    std::string problem = o.Stereo.Model->Check(o.Stereo, p);
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
// True where the picture tells how large the map is and where.
bool IsMeasured(const Projection& p, const ViewOptions& o)
{
  return p.Axis == Family::Azimuthal && !p.Framed && o.Measured.IsSet();
}

// Part of the window that shows the measured picture, along x and y.
vec2 FitOf(const ViewOptions& o)
{
  const double wider = o.Aspect * o.Measured.Size.y / o.Measured.Size.x;
  return vec2(std::min(1.0, 1 / wider), std::min(1.0, wider));
}

// NDC of the axis of a round map.
vec2 CenterOf(const Projection& p, const ViewOptions& o)
{
  if (!IsMeasured(p, o))
  {
    return vec2(0);
  }
  const vec2 axis = 2.0 * o.Measured.Axis / o.Measured.Size - 1.0;
  return vec2(axis.x, -axis.y) * FitOf(o);
}

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
      if (IsMeasured(p, o))
      {
        return 2.0 * o.Measured.Focal / o.Measured.Size * FitOf(o);
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
  , Center(projection.Axis == Family::Planar ? o.Center : CenterOf(projection, o))
{
  WfvView& v = this->Parameters;
  v.map = this->Tables.get();
  v.tables = v.map ? v.map->GetSizes() : vec4(0);
  v.halfFov = glm::radians(vec2(0.5 * o.HorizontalFov, 0.5 * o.VerticalFov));
  v.tilt = vec2(std::cos(glm::radians(o.Tilt)), std::sin(glm::radians(o.Tilt)));
  v.radii = vec2(o.Radii[0], o.Radii[1]);
  SetLens(v, o.Lens);
  v.maxAngle = projection.Framed ? CornerAngle(v.halfFov) : v.halfFov.x;
  v.depthMapping = static_cast<int>(o.Mapping);
  v.scale = vec2(1, 1);
  v.scale = Scale(projection, o, v);
  v.center = CenterOf(projection, o);
  if (IsMeasured(projection, o))
  {
    v.halfFov = glm::min(v.halfFov, 1.0 / v.scale); // what pixels measure, about
  }
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
