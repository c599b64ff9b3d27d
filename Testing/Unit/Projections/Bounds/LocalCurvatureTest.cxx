// SPDX-License-Identifier: BSD-3-Clause
// The table of bends bounds how far chords are from their edges, place by place.
#include "Projections/Bounds/LocalCurvature.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int EdgesOfView = 20000; // a view

// Radians: no edge of the test is shorter than so many times its longest.
constexpr double Shortest = 0.1;

// True where the map is torn between two directions of its own frame, or has no places.
bool IsDiscontinuous(const Projection& p, const vec3& a, const vec3& b)
{
  const auto face = [](const vec3& d) {
    const vec3 s = glm::abs(d);
    return glm::trunc(d / std::max({ s.x, s.y, s.z }));
  };
  return (p.Axis == Family::Meridian && (a.x < 0) != (b.x < 0) && (a.z > 0 || b.z > 0)) ||
    (p.Axis == Family::Faces && face(a) != face(b));
}

struct Worst
{
  double Ratio = 0;   // of a distance to its bound
  double Stretch = 0; // of the distance of two places over their angle, to its bound
  int Bounded = 0;
  int All = 0;
};

void Add(Worst& worst, const View& view, const LocalCurvature& curvature, int level, const vec3& a,
  const vec3& b)
{
  const Projection& p = view.GetProjection();
  const WfvView& v = view.GetParameters();
  const LocalCurvature::Cell& at = curvature.At(a, level);
  worst.All += level == 0;
  if (!std::isfinite(at[0]) || !std::isfinite(at[1]))
  {
    return;
  }
  worst.Bounded += level == 0;
  const double angle = std::acos(std::min(1.0, glm::dot(a, b)));
  const vec2 moved = glm::abs(p.Project(b, v) - p.Project(a, v));
  worst.Stretch = std::max(worst.Stretch, std::max(moved.x, moved.y) / (angle * at[2]));
  for (const double t : { 0.25, 0.5, 0.75 })
  {
    const vec3 d = (a * std::sin((1 - t) * angle) + b * std::sin(t * angle)) / std::sin(angle);
    const vec2 chord = p.Project(a, v) * (1 - t) + p.Project(b, v) * t;
    const vec2 off = glm::abs(p.Project(d, v) - chord);
    for (int i = 0; i < 2; ++i)
    {
      worst.Ratio = std::max(worst.Ratio, off[i] / (1e-12 + at[i] * angle * angle / 8));
    }
  }
}

Worst Measure(const View& view, std::mt19937_64& engine)
{
  const LocalCurvature curvature(view.GetProjection(), view.GetParameters());
  std::uniform_real_distribution<double> unit(-1, 1);
  Worst worst;
  for (int i = 0; i < EdgesOfView; ++i)
  {
    const WfvRay ray =
      view.GetProjection().Unproject(vec2(unit(engine), unit(engine)), view.GetParameters());
    const vec3 other(unit(engine), unit(engine), unit(engine));
    const vec3& a = ray.direction;
    const vec3 t = glm::normalize(other - a * glm::dot(other, a));
    const double share = 0.5 * (1 + Shortest) + 0.5 * (1 - Shortest) * unit(engine);
    const int level = i % LocalCurvature::Levels;
    const double angle = LocalCurvature::LongestEdge * (1 << level) * share;
    const vec3 b = a * std::cos(angle) + t * std::sin(angle);
    if (ray.inside && !IsDiscontinuous(view.GetProjection(), a, b))
    {
      Add(worst, view, curvature, level, a, b);
    }
  }
  return worst;
}
}

TEST(LocalCurvature, BoundsEveryChord)
{
  std::mt19937_64 engine(12);
  for (const Projection& p : Projections())
  {
    if (p.Axis == Family::Planar)
    {
      continue;
    }
    for (const double part : { 0.3, 1.0 })
    {
      ViewOptions o;
      o.HorizontalFov = std::max(p.MinHorizontalFov, part * p.MaxHorizontalFov);
      o.VerticalFov = std::max(p.MinVerticalFov, part * p.MaxVerticalFov);
      const Worst worst = Measure(View(p, o), engine);
      std::cout << p.Name << " " << o.HorizontalFov << ": worst chord " << worst.Ratio
                << " of the bound, stretch " << worst.Stretch << ", bounded "
                << double(worst.Bounded) / worst.All << std::endl;
      EXPECT_LE(worst.Ratio, 1) << p.Name << " " << o.HorizontalFov;
      EXPECT_LE(worst.Stretch, 1) << p.Name << " " << o.HorizontalFov;
      // what is not bounded is drawn with more effort than it needs: poles and antipodes alone
      EXPECT_GT(worst.Bounded, 0.8 * worst.All) << p.Name << " " << o.HorizontalFov;
    }
  }
}
