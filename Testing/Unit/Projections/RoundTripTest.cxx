// SPDX-License-Identifier: BSD-3-Clause
// Forward and ray undo each other, in double, over the whole domain.
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Largest error of a round trip, radians for directions, NDC for points of a picture.
constexpr double RoundTrip = 1e-12;

// What turning a unit vector by the tilt and back may add, radians.
constexpr double TiltRounding = 8 * std::numeric_limits<double>::epsilon();

// Error, the case that has it.
struct WorstTrip
{
  double Error = 0;
  std::string Case;
  void Add(double error, const std::string& name)
  {
    if (!(error <= this->Error)) // NaN counts
    {
      this->Error = error;
      this->Case = name;
    }
  }
};

// The sine of the distance to the nearest point where the map tears (a pole, the antipode,
// the plane beside a planar eye).
double SineToSingularity(const View& view, const vec3& direction)
{
  const vec3 p = wfvTilt(direction, view.GetParameters());
  switch (view.GetProjection().Axis)
  {
    case Family::Meridian:
      return std::hypot(p.x, p.z);
    case Family::Azimuthal:
      return p.z > 0 ? std::hypot(p.x, p.y) : 1;
    case Family::Planar:
      return -p.z;
    default:
      return 1;
  }
}

// The same to a place that the map puts infinitely far away, where it stretches as the
// square: the poles, straight behind, or the meridian behind.
double SineToInfinity(const View& view, const vec3& direction)
{
  const Projection& p = view.GetProjection();
  if (p.Limit.empty() || p.Axis == Family::Faces)
  {
    return 1;
  }
  const vec3 d = wfvTilt(direction, view.GetParameters());
  const double behind =
    p.Axis == Family::Azimuthal ? 0.5 - 0.5 * d.z : 0.5 - 0.5 * d.z / std::hypot(d.x, d.z);
  const double side = p.MaxHorizontalFov < 360 ? std::sqrt(behind) : 1;
  return p.Axis == Family::Azimuthal ? side : std::min(side, std::hypot(d.x, d.z));
}

// How much NDC an angle of one radian may become here: one over half a field of view, by
// the factor that a lens or a perspective may add, one over the sine near a tear.
double Stretch(const View& view, const vec3& direction)
{
  constexpr double LensAndPerspective = 2;
  const vec2 half = view.GetParameters().halfFov;
  const double infinity = SineToInfinity(view, direction);
  return LensAndPerspective / std::min(half.x, half.y) / SineToSingularity(view, direction) /
    (infinity * infinity);
}

// NDC, relative outside the picture: two directions at so nearly the same place in the picture are
// one there. On a border where a map is flat (the poles of an equal-area cylinder, the rim of an
// orthographic picture) that is half the digits of a direction, and no inverse can tell.
constexpr double SamePlace = 2 * std::numeric_limits<double>::epsilon();

// Radians: half of double's digits.
constexpr double HalfTheDigits = 4e-8;

// Error of a direction that went forward and back. A tilt's rounding moves the place too,
// far where the map stretches.
double DirectionError(
  const NamedView& v, const vec3& direction, const NdcPoint& p, const vec3& back)
{
  const double error = glm::length(back - direction);
  const vec3 again = v.TheView.Forward(back).Ndc;
  const double stretch = std::max(Stretch(v.TheView, direction), Stretch(v.TheView, back));
  const double turned = v.Options.Tilt == 0 ? 0 : TiltRounding * stretch;
  const double size = std::max(1.0, std::hypot(p.Ndc.x, p.Ndc.y));
  const bool same = std::hypot(again.x - p.Ndc.x, again.y - p.Ndc.y) <= SamePlace * size + turned;
  return same && error <= HalfTheDigits ? 0 : error;
}

// True where a point lies on a border between the faces of a cube: there the direction has
// two places, and coming back to either is right.
bool TwoPlaces(const View& view, const vec2& ndc, const vec3& direction)
{
  const vec3 p = view.Forward(direction).Ndc;
  return view.GetProjection().Axis == Family::Faces &&
    std::hypot(p.x - ndc.x, p.y - ndc.y) > RoundTrip &&
    glm::length(view.Ray(vec2(p.x, p.y)).Direction - direction) <= RoundTrip;
}

// A grid of NDC over the window with points 1e-9 inside its borders.
std::vector<vec2> WindowPoints()
{
  std::vector<double> t{ -1, -1 + 1e-9, -1 + 1e-5, -1e-9, 0, 1e-9, 1 - 1e-5, 1 - 1e-9, 1 };
  for (int i = 0; i < 60; ++i)
  {
    t.push_back(-1 + 2 * (i + 0.5) / 60);
  }
  std::vector<vec2> points;
  for (double x : t)
  {
    for (double y : t)
    {
      points.emplace_back(x, y);
    }
  }
  return points;
}

// Moves a point of the picture 1e-9 (NDC) towards the centre: at the very border of the
// map two places mean the same direction, and either is right.
vec2 Inwards(const vec2& p)
{
  const double r = std::hypot(p.x, p.y);
  return r > 1e-9 ? vec2(p.x * (1 - 1e-9 / r), p.y * (1 - 1e-9 / r)) : p;
}
}

TEST(RoundTrip, DirectionForwardRay)
{
  WorstTrip worst;
  long count = 0;
  for (const NamedView& v : AllViews())
  {
    for (const vec3& d : DirectionsFor(v.TheView))
    {
      if (!InDomain(v.TheView, d))
      {
        continue;
      }
      const NdcPoint p = v.TheView.Forward(d);
      const ViewRay ray = v.TheView.Ray(vec2(p.Ndc.x, p.Ndc.y));
      ++count;
      // a planar map has no place for what is nearly beside the eye
      EXPECT_TRUE(ray.Inside || SineToSingularity(v.TheView, d) < 1e-5) << v.Name << " " << Text(d);
      if (ray.Inside)
      {
        const double error = DirectionError(v, d, p, ray.Direction);
        worst.Add(error, v.Name + " direction " + Text(d));
      }
    }
  }
  RecordProperty("worst", worst.Case);
  std::cout << count << " directions, worst error " << worst.Error << " rad: " << worst.Case
            << "\n";
  EXPECT_GT(count, 100000);
  EXPECT_LE(worst.Error, RoundTrip) << worst.Case;
}

TEST(RoundTrip, NdcRayForward)
{
  WorstTrip worst;
  long count = 0;
  const std::vector<vec2> points = WindowPoints();
  for (const NamedView& v : AllViews())
  {
    for (const vec2& point : points)
    {
      const vec2 ndc = Inwards(point);
      const ViewRay ray = v.TheView.Ray(ndc);
      const ViewRay atBorder = v.TheView.Ray(point);
      if (!ray.Inside || !atBorder.Inside || TwoPlaces(v.TheView, ndc, ray.Direction))
      {
        continue;
      }
      ++count;
      const NdcPoint p = v.TheView.Forward(ray.Direction);
      // Without a tilt the bound holds up to the poles; with one, the rounding of the
      // turn is stretched as the map stretches there.
      const double stretch =
        v.Options.Tilt == 0 ? 0 : TiltRounding * Stretch(v.TheView, ray.Direction);
      const double error = std::hypot(p.Ndc.x - ndc.x, p.Ndc.y - ndc.y);
      worst.Add(std::max(0.0, error - stretch), v.Name + " ndc " + Text(ndc));
    }
  }
  std::cout << count << " points, worst error " << worst.Error << " ndc: " << worst.Case << "\n";
  EXPECT_GT(count, 100000);
  EXPECT_LE(worst.Error, RoundTrip) << worst.Case;
}

TEST(RoundTrip, DepthIsThatOfTheContract)
{
  for (const Projection& p : Projections())
  {
    ViewOptions o;
    o.HorizontalFov = std::max(90., p.MinHorizontalFov);
    o.VerticalFov = std::max(60., p.MinVerticalFov);
    o.Radii = { { 2, 10 } };
    const View view(p, o);
    EXPECT_DOUBLE_EQ(view.Forward(vec3(0, 0, -2)).Ndc.z, -1) << p.Name;
    EXPECT_DOUBLE_EQ(view.Forward(vec3(0, 0, -10)).Ndc.z, 1) << p.Name;
    EXPECT_DOUBLE_EQ(view.Forward(vec3(0, 0, -6)).Ndc.z, 0) << p.Name;
    EXPECT_TRUE(view.Forward(vec3(0, 0, -6)).Inside) << p.Name;
    EXPECT_FALSE(view.Forward(vec3(0, 0, -1)).Inside) << p.Name;
    EXPECT_FALSE(view.Forward(vec3(0, 0, -11)).Inside) << p.Name;
    EXPECT_FALSE(view.Forward(vec3(0, 0, 0)).Inside) << p.Name;
  }
}
