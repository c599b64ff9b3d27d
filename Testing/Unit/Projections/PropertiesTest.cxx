// SPDX-License-Identifier: BSD-3-Clause
// What a projection says of itself, asserted numerically.
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <sstream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Relative; differences over two steps to each side err by about the fourth power of the
// step, times a fifth derivative that may be 1e6 near a pole.
constexpr double DifferenceStep = 1e-4; // radians
constexpr double DerivativeError = 1e-8;

// Relative error of a length that is exact but for rounding.
constexpr double PropertyRounding = 1e-12;

View FullView(const Projection& p)
{
  ViewOptions o;
  o.HorizontalFov = p.Axis == Family::Planar ? 90 : p.MaxHorizontalFov;
  o.VerticalFov = std::min(p.MaxVerticalFov, o.HorizontalFov);
  o.Aspect = 1;
  return View(p, o);
}

// The raw map, of (lambda, phi) or (azimuth, theta).
vec2 RawMap(const View& view, const vec2& angles)
{
  const vec2 m = view.GetProjection().Map(angles, view.GetParameters());
  const vec2 scale = view.GetParameters().scale;
  return vec2(m.x / scale.x, m.y / scale.y);
}

// The raw place of a direction, and the derivatives of the map at it along two
// perpendicular unit tangents of the sphere.
struct Derivatives
{
  vec2 Du;
  vec2 Dv;
};

vec2 RawProject(const View& view, const vec3& d)
{
  const vec3 ndc = view.Forward(d).Ndc;
  const vec2 scale = view.GetParameters().scale;
  return vec2(ndc.x / scale.x, ndc.y / scale.y);
}

Derivatives Differentiate(const View& view, const vec3& d)
{
  const vec3 other = std::abs(d.x) < 0.5 ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 u = glm::normalize(glm::cross(d, other));
  const vec3 v = glm::cross(d, u);
  const double h = DifferenceStep;
  const auto difference = [&](const vec3& t, double a) {
    return RawProject(view, d * std::cos(a) + t * std::sin(a)) -
      RawProject(view, d * std::cos(a) - t * std::sin(a));
  };
  const auto along = [&](const vec3& t) {
    return (difference(t, h) * 8.0 - difference(t, 2 * h)) / (12 * h);
  };
  return { along(u), along(v) };
}

// Directions well inside the domain of the map, away from where it tears.
std::vector<vec3> SmoothDirections(const Projection& p)
{
  constexpr double Margin = 0.05; // radians, so that a difference never crosses a tear
  std::vector<vec3> inside;
  for (const vec3& d : RandomDirections(4000))
  {
    const vec2 a = wfvMeridianAngles(d);
    const vec2 end = p.Axis == Family::Meridian
      ? vec2(0.5 * p.MaxHorizontalFov * Degree, 0.5 * p.MaxVerticalFov * Degree)
      : vec2(WFV_PI, 0.5 * WFV_PI);
    const bool tears = std::abs(a.x) > end.x - Margin || std::abs(a.y) > end.y - Margin;
    const bool beyond = p.Axis == Family::Azimuthal &&
      wfvAzimuthalAngles(d).y > 0.5 * p.MaxHorizontalFov * Degree - Margin;
    if (!tears && !beyond && (p.Axis != Family::Planar || d.z < -0.1))
    {
      inside.push_back(d);
    }
  }
  return inside;
}

void CheckEqualArea(const Projection& p)
{
  const View view = FullView(p);
  for (const vec3& d : SmoothDirections(p))
  {
    const Derivatives j = Differentiate(view, d);
    ASSERT_NEAR(std::abs(Cross(j.Du, j.Dv)), 1, DerivativeError) << p.Name << " " << Text(d);
  }
}

void CheckConformal(const Projection& p)
{
  const View view = FullView(p);
  for (const vec3& d : SmoothDirections(p))
  {
    const Derivatives j = Differentiate(view, d);
    const double size = glm::length(j.Du);
    ASSERT_NEAR(glm::length(j.Dv) / size, 1, DerivativeError) << p.Name << " " << Text(d);
    ASSERT_NEAR(glm::dot(j.Du, j.Dv) / (size * size), 0, DerivativeError)
      << p.Name << " " << Text(d);
  }
}

// Lengths are kept along every meridian and the equator (meridian family), or along
// every line through the centre (azimuthal).
void CheckEquidistant(const Projection& p)
{
  const View view = FullView(p);
  const bool meridian = p.Axis == Family::Meridian;
  const double span = meridian ? 0.5 * WFV_PI : WFV_PI;
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> turn(-WFV_PI, WFV_PI);
  std::uniform_real_distribution<double> along(meridian ? -span : 0, span);
  for (int i = 0; i < 2000; ++i)
  {
    const double a = turn(engine);
    const double s = along(engine);
    const double t = along(engine);
    const vec2 difference = RawMap(view, vec2(a, t)) - RawMap(view, vec2(a, s));
    ASSERT_NEAR(glm::length(difference), std::abs(t - s), PropertyRounding)
      << p.Name << " at " << a;
    if (meridian)
    {
      const double b = turn(engine);
      const vec2 equator = RawMap(view, vec2(a, 0)) - RawMap(view, vec2(b, 0));
      ASSERT_NEAR(glm::length(equator), std::abs(a - b), PropertyRounding) << p.Name << " equator";
    }
  }
}

// Distances along the equator and along the central meridian have one scale each.
void CheckEquidistantAxes(const Projection& p)
{
  const View view = FullView(p);
  const vec2 unit(RawMap(view, vec2(1, 0)).x, RawMap(view, vec2(0, 1)).y);
  for (int i = -100; i <= 100; ++i)
  {
    const double lambda = WFV_PI * i / 100;
    const double phi = 0.5 * lambda;
    ASSERT_NEAR(RawMap(view, vec2(lambda, 0)).x, unit.x * lambda, PropertyRounding) << p.Name;
    ASSERT_NEAR(RawMap(view, vec2(0, phi)).y, unit.y * phi, PropertyRounding) << p.Name;
  }
}

// Meridians (axis 0) or parallels (axis 1) are drawn as straight lines along the borders.
void CheckStraight(const Projection& p, int axis)
{
  const View view = FullView(p);
  const std::vector<vec3> d = SmoothDirections(p);
  for (std::size_t i = 0; i + 1 < d.size(); ++i)
  {
    vec2 a = wfvMeridianAngles(d[i]);
    vec2 b = wfvMeridianAngles(d[i + 1]);
    b[axis] = a[axis];
    const double u = RawMap(view, a)[axis];
    ASSERT_NEAR(RawMap(view, b)[axis], u, PropertyRounding * std::max(1.0, std::abs(u))) << p.Name;
  }
}

// Planes through the axis of view are straight lines through the centre.
void CheckStraightRadials(const Projection& p)
{
  const View view = FullView(p);
  for (const vec3& d : SmoothDirections(p))
  {
    const vec2 m = RawProject(view, d);
    const double size = std::max(1.0, glm::length(m));
    ASSERT_LE(std::abs(Cross(m, vec2(d.x, d.y))), PropertyRounding * size)
      << p.Name << " " << Text(d);
    ASSERT_GT(glm::dot(m, vec2(d.x, d.y)), 0) << p.Name << " " << Text(d);
  }
}

// On each face of the cube, turning by an angle about the axes of the face moves as far
// everywhere: 45 degrees are half the face.
void CheckEquiangular(const Projection& p)
{
  const View view = FullView(p);
  const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  // right, up and forward of the faces, left to right, the upper row first
  const vec3 faces[6][3] = { { -z, y, -x }, { x, y, -z }, { z, y, x }, { z, x, -y }, { y, x, z },
    { -z, x, y } };
  for (int f = 0; f < 6; ++f)
  {
    const vec2 centre(2. / 3 * (f % 3 - 1), f < 3 ? 0.5 : -0.5);
    for (int i = -44; i <= 44; ++i)
    {
      for (int j = -44; j <= 44; ++j)
      {
        const vec3 d =
          faces[f][2] + faces[f][0] * std::tan(i * Degree) + faces[f][1] * std::tan(j * Degree);
        const vec2 m = RawProject(view, glm::normalize(d));
        ASSERT_NEAR(m.x, centre.x + i / 45. / 3, PropertyRounding) << f << " " << i << " " << j;
        ASSERT_NEAR(m.y, centre.y + j / 45. / 2, PropertyRounding) << f << " " << i << " " << j;
      }
    }
  }
}

// Three points of a straight line in space lie on a straight line in the picture.
void CheckStraightLines(const Projection& p)
{
  const View view = FullView(p);
  const std::vector<vec3> d = SmoothDirections(p);
  for (std::size_t i = 0; i + 1 < d.size(); i += 2)
  {
    const vec3 a = d[i] * 3.0;
    const vec3 b = d[i + 1];
    const vec2 u = RawProject(view, a);
    const vec2 v = RawProject(view, a * 0.3 + b * 0.7);
    const vec2 w = RawProject(view, b);
    const double size = glm::length(w - u) * std::max(1.0, glm::length(v - u));
    ASSERT_LE(std::abs(Cross(v - u, w - u)), PropertyRounding * std::max(1.0, size))
      << p.Name << " from " << Text(a) << " to " << Text(b);
  }
}
}

TEST(Properties, EachIsAsserted)
{
  const std::map<std::string, void (*)(const Projection&)> checks{
    { "equidistant", CheckEquidistant }, { "equal-area", CheckEqualArea },
    { "conformal", CheckConformal }, { "straight-lines", CheckStraightLines },
    { "equidistant-axes", CheckEquidistantAxes }, { "equiangular", CheckEquiangular },
    { "straight-meridians", [](const Projection& p) { CheckStraight(p, 0); } },
    { "straight-parallels", [](const Projection& p) { CheckStraight(p, 1); } },
    { "straight-radials", CheckStraightRadials }
  };
  for (const Projection& p : Projections())
  {
    std::istringstream words(p.Properties);
    std::string word;
    int count = 0;
    for (; words >> word; ++count)
    {
      if (word.back() == ',')
      {
        word.pop_back();
      }
      SCOPED_TRACE(p.Name + ": " + word);
      const auto check = checks.find(word);
      ASSERT_NE(check, checks.end()) << "no check knows this property";
      check->second(p);
    }
    EXPECT_GT(count, 0) << p.Name;
  }
}

// The checks can tell: a property that a projection lacks fails its condition.
TEST(Properties, AreNotHeldByAll)
{
  const View flat = FullView(*FindProjection("equirectangular"));
  const Derivatives j = Differentiate(flat, wfvMeridianDirection(vec2(0.3, 1.0)));
  EXPECT_GT(std::abs(std::abs(Cross(j.Du, j.Dv)) - 1), 0.5);
  const View hammer = FullView(*FindProjection("hammer"));
  const Derivatives k = Differentiate(hammer, wfvMeridianDirection(vec2(2.0, 1.0)));
  EXPECT_GT(std::abs(glm::length(k.Dv) / glm::length(k.Du) - 1), 0.1);
}
