// SPDX-License-Identifier: BSD-3-Clause
// The figure `curvature` of a view bounds how far chords are from their edges, in the picture.
#include "Projections/Bounds/Curvature.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Radians: the longest edge that the stages judge by the curvature, five degrees
// (WFV_EASY_EDGE), and the nearest to a singular point (WFV_SINGULAR_ANGLE).
constexpr double LongestEdge = 0.089;
constexpr double NearestSingular = 0.035;

// Sine of the angle to the nearest singular point of the family.
double Sine(Family family, const vec3& d)
{
  return family == Family::Meridian          ? std::hypot(d.x, d.z)
    : family == Family::Azimuthal && d.z > 0 ? std::hypot(d.x, d.y)
                                             : 1;
}

// The face of a cube that a direction meets.
vec3 FaceOf(const vec3& d)
{
  const vec3 a = glm::abs(d);
  const double largest = std::max({ a.x, a.y, a.z });
  return glm::trunc(d / largest);
}

bool IsDiscontinuous(const View& view, const vec3& a, const vec3& b)
{
  switch (view.GetProjection().Axis)
  {
    case Family::Meridian:
      return (a.x < 0) != (b.x < 0) && (a.z > 0 || b.z > 0);
    case Family::Faces:
      return FaceOf(a) != FaceOf(b);
    case Family::Planar:
      return a.z > -0.02 || b.z > -0.02;
    default:
      return false;
  }
}

// Largest ratio of the distance between chord and edge, on one axis, to the bound.
double WorstRatio(const View& view, const vec3& a, const vec3& b, double angle)
{
  const Projection& p = view.GetProjection();
  const WfvView& v = view.GetParameters();
  const vec2 na = p.Project(a, v);
  const vec2 nb = p.Project(b, v);
  vec2 worst(0);
  double sine = 1;
  for (int i = 0; i <= 8; ++i)
  {
    const double t = i / 8.0;
    const vec3 d = (a * std::sin((1 - t) * angle) + b * std::sin(t * angle)) / std::sin(angle);
    sine = std::min(sine, Sine(p.Axis, d));
    worst = glm::max(worst, glm::abs(p.Project(d, v) - (na * (1 - t) + nb * t)));
  }
  if (sine < NearestSingular)
  {
    return 0;
  }
  return std::max(worst.x, worst.y) / (v.curvature * angle * angle / (8 * sine * sine));
}

// Edges that begin at what the window shows.
double WorstOf(const NamedView& named, int count, std::mt19937_64& engine)
{
  std::uniform_real_distribution<double> unit(-1, 1);
  const View& view = named.TheView;
  const WfvView& v = view.GetParameters();
  double worst = 0;
  for (int i = 0; i < count; ++i)
  {
    vec2 ndc(unit(engine), unit(engine));
    // half of them near the borders
    ndc[i & 1] =
      i % 4 < 2 ? ndc[i & 1] : std::copysign(1 - std::pow(10, -2 + 2 * unit(engine)), ndc[i & 1]);
    const WfvRay ray = view.GetProjection().Unproject(ndc, v);
    if (!ray.inside)
    {
      continue;
    }
    const vec3 a = ray.direction;
    const vec3 other(unit(engine), unit(engine), unit(engine));
    const vec3 t = glm::normalize(other - a * glm::dot(other, a));
    const double angle = LongestEdge * std::pow(10, -1 + unit(engine));
    const vec3 b = a * std::cos(angle) + t * std::sin(angle);
    if (!IsDiscontinuous(view, a, b))
    {
      worst = std::max(worst, WorstRatio(view, a, b, angle));
    }
  }
  return worst;
}

std::vector<NamedView> Views()
{
  std::vector<NamedView> views;
  for (const NamedView& v : AllViews())
  {
    const double fov = v.Options.HorizontalFov;
    if (v.Options.Tilt == 0 && fov >= 1 && fov < 359 + 1.5)
    {
      views.push_back(v);
    }
  }
  return views;
}
}

TEST(Curvature, BoundsEveryChord)
{
  std::mt19937_64 engine(11);
  double least = 1;
  std::string loosest;
  for (const NamedView& v : Views())
  {
    const double worst = WorstOf(v, 20000, engine);
    EXPECT_LE(worst, 1) << v.Name << " curvature " << v.TheView.GetParameters().curvature;
    if (v.Options.HorizontalFov >= v.TheView.GetProjection().MaxHorizontalFov - 1e-9)
    {
      std::cout << v.Name << ": curvature " << v.TheView.GetParameters().curvature
                << ", worst chord " << worst << " of the bound\n";
    }
    if (worst < least)
    {
      least = worst;
      loosest = v.Name;
    }
  }
  std::cout << "least used bound " << least << ": " << loosest << "\n";
}

// Once a view is known the figure is looked up; the first time it takes milliseconds.
TEST(Curvature, IsKept)
{
  for (const Projection& p : Projections())
  {
    ViewOptions o;
    o.HorizontalFov = std::max(p.MinHorizontalFov, 0.37 * p.MaxHorizontalFov);
    o.VerticalFov = std::max(p.MinVerticalFov, 0.41 * p.MaxVerticalFov);
    const auto start = std::chrono::steady_clock::now();
    const View view(p, o);
    const auto end = std::chrono::steady_clock::now();
    std::cout << p.Name << ": " << std::chrono::duration<double, std::milli>(end - start).count()
              << " ms\n";
    EXPECT_GT(view.GetParameters().curvature, 0) << p.Name;
    EXPECT_TRUE(std::isfinite(view.GetParameters().curvature)) << p.Name;
    EXPECT_EQ(View(p, o).GetParameters().curvature, view.GetParameters().curvature) << p.Name;
  }
}
