// SPDX-License-Identifier: BSD-3-Clause
#include "Clusters/EyeCircle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wfv
{
namespace
{
// Edges that one with a chord is away from the axis at least.
constexpr double LeastEdges = 4;

// Of the angle that an edge has, seen from the axis: by no more do the places turn about the circle
// that its points are seen from, beyond LeastRadii.
constexpr double TurningOfPlaces = 2.2;

// Over the sine of the angle between a point's direction and that of the ray that meets it: what
// the level distance and the height add, where the former is LeastRadii or more.
constexpr double AsideSafety = 1.4;

// How many times longer than a bound for all directions says an edge may be, squared, where places
// of it are looked at.
constexpr double MostTimesLonger2 = 8 * 8;
}

EyeCircle::EyeCircle(const WfvView& view, const StereoModel* stereo, double radius,
  const ChordLimits* limits, double tolerance)
  : View(view)
  , Stereo(stereo)
  , Radius(radius)
  , Limits(limits)
  , Tolerance(tolerance)
{
}

// The squared distance of a point from the axis.
double EyeCircle::AxisDistance2(const vec3& p) const
{
  const double height = glm::dot(p, vec3(0, this->View.tilt.x, -this->View.tilt.y));
  return std::max(0.0, glm::dot(p, p) - height * height);
}

// Whether the distance of an edge from the axis is little beside its length.
bool EyeCircle::IsNearAxis(const vec3& p, double edge2) const
{
  return !(this->AxisDistance2(p) - edge2 > LeastEdges * LeastEdges * edge2);
}

// Where an eye sees a point, as if from the origin.
vec3 EyeCircle::SeenBy(int eye, const vec3& p) const
{
  WfvView v = this->View;
  v.eye = eye;
  const auto s = this->Stereo->See(p, v);
  return s.distance * s.direction;
}

double EyeCircle::LimitAt(const vec3& p) const
{
  const double level = std::sqrt(this->AxisDistance2(p));
  if (!(level > LeastRadii * this->Radius))
  {
    return 0;
  }
  const double sine = AsideSafety * this->Radius / glm::length(p);
  const double larger = 1 + AsideSafety * this->Radius / level;
  return this->Limits->LeastAround(p, sine) / (larger * larger);
}

double EyeCircle::LimitAround(const vec3& centre, double radius, double edge) const
{
  const double distance = glm::length(centre);
  const double nearest = distance - radius;
  const double level = std::sqrt(this->AxisDistance2(centre)) - radius;
  const double r = this->Radius;
  if (!(level > LeastRadii * r && level * level > (1 + LeastEdges * LeastEdges) * edge * edge))
  {
    return 0;
  }
  const double off = r * edge * edge / (level * level) / nearest;
  const double stretch = this->Limits->MostStretchAround(centre, radius / distance);
  const double left = 1 - off * stretch / this->Tolerance;
  const double larger = 1 + AsideSafety * r / level;
  const double sine = radius / distance + AsideSafety * r / nearest;
  return std::max(0.0, left) * this->Limits->LeastAround(centre, sine) / (larger * larger);
}

// An edge is no great circle: from each place another ray looks, by as much as the circle turns
// between them. By so many tolerances that moves it, at the most.
double EyeCircle::TurningOf(const vec3& p, double edge2) const
{
  if (this->IsNearAxis(p, edge2))
  {
    return std::numeric_limits<double>::infinity();
  }
  const double level2 = this->AxisDistance2(p) - edge2;
  const double off = this->Radius * edge2 / level2 / glm::length(p);
  return off * this->Limits->StretchAt(p) / this->Tolerance;
}

bool EyeCircle::IsShort(const vec3& p, double edge2, double limit2) const
{
  return edge2 + this->TurningOf(p, edge2) * limit2 <= limit2;
}

bool EyeCircle::HasChord(const vec3& p, const vec3& q, double limit2) const
{
  const vec3 way = q - p;
  const double length2 = glm::dot(way, way);
  if (this->IsShort(p, length2, limit2))
  {
    return true;
  }
  if (!(length2 <= MostTimesLonger2 * limit2) || this->IsNearAxis(p, length2))
  {
    return false;
  }
  bool near = true;
  for (const int eye : { WFV_EYE_LEFT, WFV_EYE_RIGHT })
  {
    std::array<vec3, 5> seen;
    for (std::size_t i = 0; i < seen.size(); i++)
    {
      seen[i] = this->SeenBy(eye, p + 0.25 * double(i) * way);
    }
    near = near && this->Limits->AreNearChord(seen);
  }
  return near;
}

// Its points are seen from near the places of the circle that its corners are.
bool EyeCircle::MaySeeAtSeam(const vec3 p[3], double longest, double beside) const
{
  const double level2 =
    std::min({ this->AxisDistance2(p[0]), this->AxisDistance2(p[1]), this->AxisDistance2(p[2]) });
  const double level = std::sqrt(level2) - longest;
  if (!(level > LeastRadii * this->Radius))
  {
    return true;
  }
  const double turning = this->Radius * std::min(2.0, TurningOfPlaces * longest / level);
  bool sees = false;
  for (const int eye : { WFV_EYE_LEFT, WFV_EYE_RIGHT })
  {
    const vec3 seen[3] = { this->SeenBy(eye, p[0]), this->SeenBy(eye, p[1]),
      this->SeenBy(eye, p[2]) };
    sees = sees || IsAtSeam(seen, beside + turning);
  }
  return sees;
}

bool IsAtSeam(const vec3 p[3], double beside)
{
  return std::min({ p[0].x, p[1].x, p[2].x }) <= beside &&
    std::max({ p[0].x, p[1].x, p[2].x }) >= -beside &&
    std::max({ p[0].z, p[1].z, p[2].z }) >= -beside;
}
}
