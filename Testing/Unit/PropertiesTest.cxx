// SPDX-License-Identifier: BSD-3-Clause
// What a projection says of itself, asserted numerically.
#include "Views.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Relative; second differences in double with this step err by about its square.
constexpr double DifferenceStep = 1e-5; // radians
constexpr double DerivativeError = 1e-8;

// Relative error of a length that is exact but for rounding.
constexpr double Rounding = 1e-12;

View FullView(const Projection& p)
{
  ViewOptions o;
  o.HorizontalFov = p.Axis == Family::Planar ? 90 : 360;
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
  const double s = std::sin(h);
  const double c = std::cos(h);
  const auto along = [&](const vec3& t) {
    return (RawProject(view, d * c + t * s) - RawProject(view, d * c - t * s)) / (2 * h);
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
    const bool tears = std::abs(a.x) > WFV_PI - Margin || std::abs(a.y) > 0.5 * WFV_PI - Margin;
    if (!tears && (p.Axis != Family::Planar || d.z < -0.1))
    {
      inside.push_back(d);
    }
  }
  return inside;
}

double Cross(const vec2& a, const vec2& b)
{
  return a.x * b.y - a.y * b.x;
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
    ASSERT_NEAR(glm::length(difference), std::abs(t - s), Rounding) << p.Name << " at " << a;
    if (meridian)
    {
      const double b = turn(engine);
      const vec2 equator = RawMap(view, vec2(a, 0)) - RawMap(view, vec2(b, 0));
      ASSERT_NEAR(glm::length(equator), std::abs(a - b), Rounding) << p.Name << " equator";
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
    ASSERT_LE(std::abs(Cross(v - u, w - u)), Rounding * std::max(1.0, size))
      << p.Name << " from " << Text(a) << " to " << Text(b);
  }
}
}

TEST(Properties, EachIsAsserted)
{
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
      if (word == "equidistant")
      {
        CheckEquidistant(p);
      }
      else if (word == "equal-area")
      {
        CheckEqualArea(p);
      }
      else if (word == "conformal")
      {
        CheckConformal(p);
      }
      else if (word == "straight-lines")
      {
        CheckStraightLines(p);
      }
      else
      {
        ADD_FAILURE() << "no check knows this property";
      }
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
