// SPDX-License-Identifier: BSD-3-Clause
#include "Projections/Bounds/Curvature.h"

#include <algorithm>
#include <mutex>

namespace wfv
{
namespace
{
// For what lies between the samples; Testing/Unit/Projections/Bounds/CurvatureTest.cxx looks there.
constexpr double CurvatureSafety = 1.25;

// Radians: how far round what the window shows, and at how many distances on the way.
const double Margin = glm::radians(10.0);
constexpr int MarginSteps = 2;
constexpr int MarginDirections = 8;

// Samples along each side of the window, and along its border.
constexpr int Inner = 24;
constexpr int Border = 32;

// Step of the second differences: radians, and of half the field of view where that is
// narrow. Their own error is about its square.
constexpr double LargestStep = 2e-3;
constexpr double PartOfView = 0.02;

// Sine of the angle from a singular point below which nothing is asked: the stages draw no
// chords there.
const double Singular = WFV_SINGULAR_ANGLE - 0.005;

// -z of the directions that a planar map still has a place for.
constexpr double PlanarEnd = 0.02;

// The face of a cube that a direction meets, any numbers.
int FaceOf(const vec3& d)
{
  const vec3 a = glm::abs(d);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  return d[axis] < 0 ? axis : axis + 3;
}

// True where the map is discontinuous or kinked between a and b, which are a few steps apart.
bool IsDiscontinuous(Family family, const vec3& a, const vec3& b)
{
  switch (family)
  {
    case Family::Meridian:
      return (a.x < 0) != (b.x < 0) && a.z > 0;
    case Family::Planar:
      return a.z > -PlanarEnd || b.z > -PlanarEnd;
    case Family::Faces:
      return FaceOf(a) != FaceOf(b);
    default:
      return false;
  }
}

double StepIn(const WfvView& v)
{
  return std::min(LargestStep, PartOfView * std::min(v.halfFov.x, v.halfFov.y));
}

// Second derivatives of x and y along a great circle through d in the direction t.
vec2 Second(const Projection& p, const WfvView& v, const vec3& d, const vec3& t, double step)
{
  const vec3 a = d * std::cos(step) + t * std::sin(step);
  const vec3 b = d * std::cos(step) - t * std::sin(step);
  return (p.Project(a, v) - p.Project(d, v) * 2.0 + p.Project(b, v)) / (step * step);
}

// Largest size of a quadratic form over unit vectors, from its values along two
// perpendicular ones and along their middle.
double Largest(double uu, double vv, double middle)
{
  const double mean = 0.5 * (uu + vv);
  return std::abs(mean) + std::hypot(0.5 * (uu - vv), middle - mean);
}

struct Tangents
{
  vec3 U;
  vec3 V;
  explicit Tangents(const vec3& d)
    : U(glm::normalize(glm::cross(d, std::abs(d.x) < 0.5 ? vec3(1, 0, 0) : vec3(0, 1, 0))))
    , V(glm::cross(d, this->U))
  {
  }
  vec3 At(double angle) const { return this->U * std::cos(angle) + this->V * std::sin(angle); }
};

// The weighted curvature and stretch at one direction of the map's own frame; 0 where they are not
// asked for.
vec3 CurvatureAt(const Projection& p, const WfvView& v, const vec3& d)
{
  const double sine = SineToSingularity(p.Axis, d);
  if (sine < Singular)
  {
    return vec3(0);
  }
  const vec2 second = SecondAt(p, v, d);
  const vec2 first = FirstAt(p, v, d);
  return vec3(std::max(second.x, second.y), first.x, first.y) * (sine * sine);
}

// The directions on the border of what is seen: of the window, and of a round map's rim.
std::vector<vec3> BorderDirections(const Projection& p, const WfvView& v)
{
  std::vector<vec3> directions;
  for (int i = 0; i < Border; i++)
  {
    // four sides, from corner to corner
    const int side = i % 4;
    const int step = i / 4;
    const double t = -1 + 2 * step / (Border / 4.0);
    const vec2 ndc =
      side < 2 ? vec2(side ? -t : t, side ? 1 : -1) : vec2(side == 2 ? 1 : -1, side == 2 ? t : -t);
    const WfvRay ray = p.Unproject(ndc - v.center, v);
    if (ray.inside)
    {
      directions.push_back(ray.direction);
    }
    if (p.Axis == Family::Azimuthal)
    {
      directions.push_back(wfvAzimuthalDirection(vec2(2 * WFV_PI * i / Border, v.maxAngle)));
    }
  }
  return directions;
}

vec3 Compute(const Projection& p, const WfvView& v)
{
  vec3 curvature(0);
  for (int i = 0; i <= Inner; i++)
  {
    for (int j = 0; j <= Inner; j++)
    {
      const vec2 ndc(-1 + 2.0 * i / Inner, -1 + 2.0 * j / Inner);
      const WfvRay ray = p.Unproject(ndc - v.center, v);
      curvature = ray.inside ? glm::max(curvature, CurvatureAt(p, v, ray.direction)) : curvature;
    }
  }
  for (const vec3& d : BorderDirections(p, v))
  {
    curvature = glm::max(curvature, CurvatureAt(p, v, d));
    const Tangents tangents(d);
    for (int i = 0; i < MarginSteps * MarginDirections; i++)
    {
      const vec3 t = tangents.At(2 * WFV_PI * i / MarginDirections);
      const int step = 1 + i / MarginDirections;
      const double a = Margin * step / MarginSteps;
      curvature = glm::max(curvature, CurvatureAt(p, v, d * std::cos(a) + t * std::sin(a)));
    }
  }
  return CurvatureSafety * curvature;
}

// One view that was asked for.
struct Kept
{
  const Projection* Map;
  WfvView View;
  vec3 Curvature; // and stretch

  bool Is(const Projection& p, const WfvView& v) const
  {
    const WfvView& w = this->View;
    return this->Map == &p && w.halfFov == v.halfFov && w.scale == v.scale && w.lens == v.lens &&
      w.lens5 == v.lens5 && w.lensHigh == v.lensHigh && w.center == v.center;
  }
};
}

vec2 SecondAt(const Projection& p, const WfvView& v, const vec3& d)
{
  const double step = StepIn(v);
  const Tangents tangents(d);
  vec2 second[3];
  for (int i = 0; i < 3; i++)
  {
    const vec3 t = tangents.At(0.25 * WFV_PI * i);
    if (IsDiscontinuous(p.Axis, d + t * step, d - t * step) ||
      IsDiscontinuous(p.Axis, d + t * step, d))
    {
      return vec2(0);
    }
    second[i] = Second(p, v, d, t, step);
  }
  return vec2(
    Largest(second[0].x, second[2].x, second[1].x), Largest(second[0].y, second[2].y, second[1].y));
}

vec2 FirstAt(const Projection& p, const WfvView& v, const vec3& d)
{
  const double step = StepIn(v);
  const Tangents tangents(d);
  vec2 squares(0);
  for (const vec3& t : { tangents.U, tangents.V })
  {
    if (IsDiscontinuous(p.Axis, d + t * step, d - t * step) ||
      IsDiscontinuous(p.Axis, d + t * step, d))
    {
      return vec2(0);
    }
    const vec3 a = d * std::cos(step) + t * std::sin(step);
    const vec3 b = d * std::cos(step) - t * std::sin(step);
    const vec2 first = (p.Project(a, v) - p.Project(b, v)) / (2 * step);
    squares += first * first;
  }
  return glm::sqrt(squares);
}

double SineToSingularity(Family family, const vec3& d)
{
  switch (family)
  {
    case Family::Meridian:
      return std::hypot(d.x, d.z);
    case Family::Azimuthal:
      return d.z > 0 ? std::hypot(d.x, d.y) : 1;
    default:
      return 1;
  }
}

namespace
{
vec3 CurvatureAndStretch(const Projection& p, const WfvView& v)
{
  if (p.Axis == Family::Sampled)
  {
    return vec3(0); // nothing is drawn by chords there
  }
  constexpr std::size_t MaxKept = 16; // as many views as a program may draw in turn
  static std::mutex mutex;
  static std::vector<Kept> kept;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto known =
    std::find_if(kept.begin(), kept.end(), [&](const Kept& k) { return k.Is(p, v); });
  if (known != kept.end())
  {
    return known->Curvature;
  }
  if (kept.size() == MaxKept)
  {
    kept.erase(kept.begin());
  }
  kept.push_back({ &p, v, Compute(p, v) });
  return kept.back().Curvature;
}
}

double Curvature(const Projection& p, const WfvView& v)
{
  return CurvatureAndStretch(p, v).x;
}

vec2 Stretch(const Projection& p, const WfvView& v)
{
  const vec3 both = CurvatureAndStretch(p, v);
  return vec2(both.y, both.z);
}
}
