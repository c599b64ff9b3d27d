// SPDX-License-Identifier: BSD-3-Clause
// What is said to lie between the samples of a picture does, and most of what does is said to.
#include "Views.h"
#include "vtkWideFoVSampleGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
double DistanceToSide(const vec2& s, const vec2& a, const vec2& b)
{
  const double length2 = glm::dot(b - a, b - a);
  const double t = length2 > 0 ? std::clamp(glm::dot(s - a, b - a) / length2, 0.0, 1.0) : 0;
  return glm::length(s - a - t * (b - a));
}

// 0 inside.
double Distance(const vec2& s, const vec2 c[3])
{
  const double a = Cross(c[1] - c[0], s - c[0]);
  const double b = Cross(c[2] - c[1], s - c[1]);
  const double d = Cross(c[0] - c[2], s - c[2]);
  if ((a >= 0 && b >= 0 && d >= 0) || (a <= 0 && b <= 0 && d <= 0))
  {
    return 0;
  }
  return std::min({ DistanceToSide(s, c[0], c[1]), DistanceToSide(s, c[1], c[2]),
    DistanceToSide(s, c[2], c[0]) });
}

// From the nearest pixel centre to the triangle, by looking at all there are round it.
double NearestCentre(const vec2 c[3])
{
  double nearest = std::numeric_limits<double>::max();
  for (int x = -1; x < 13; ++x)
  {
    for (int y = -1; y < 13; ++y)
    {
      nearest = std::min(nearest, Distance(vec2(x + 0.5, y + 0.5), c));
    }
  }
  return nearest;
}
}

TEST(SampleGrid, NothingBetweenSamplesHoldsOne)
{
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const SampleGrid grid;
  int between = 0;
  int found = 0;
  for (int i = 0; i < 30000; ++i)
  {
    const double size = 3 * unit(engine) * unit(engine);
    const vec2 at = 8.0 * vec2(unit(engine), unit(engine));
    vec2 c[3];
    for (vec2& corner : c)
    {
      corner = at + size * vec2(unit(engine), unit(engine));
    }
    if (i % 10 == 0)
    {
      c[2] = 0.5 * (c[0] + c[1]); // no area
    }
    const double grow = 0.1 * unit(engine);
    const double nearest = NearestCentre(c);
    const bool misses = grid.Misses(c, grow);
    ASSERT_FALSE(misses && nearest <= grow) << "triangle " << i << ", " << nearest << " px";
    between += nearest > grow;
    found += misses;
  }
  // beyond sharp corners a little more is looked at than is as near as that
  EXPECT_GT(found, 0.95 * between);
  EXPECT_GT(between, 10000);
}

TEST(SampleGrid, SaysNothingOfWhatItCannotKnow)
{
  const SampleGrid grid;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const vec2 broken[3] = { vec2(0.9, 0.9), vec2(nan, 0.9), vec2(0.9, 1.0) };
  EXPECT_FALSE(grid.Misses(broken, 0.01));
  const vec2 small[3] = { vec2(0.9, 0.9), vec2(1.0, 0.9), vec2(0.9, 1.0) };
  EXPECT_TRUE(grid.Misses(small, 0.01));
  EXPECT_FALSE(grid.Misses(small, nan));
  EXPECT_FALSE(grid.Misses(small, std::numeric_limits<double>::infinity()));
}

TEST(SampleGrid, CountsFromTheCornerOfTheViewport)
{
  SampleGrid grid;
  grid.SetPlace(vec2(512, 256), vec2(512, 256), vec2(1024, 512));
  EXPECT_EQ(grid.At(vec2(-1, -1)), vec2(0, 0));
  EXPECT_EQ(grid.At(vec2(1, 1)), vec2(1024, 512));
}

// All samples so near a way, each once, and no other.
TEST(SampleGrid, VisitsWhatIsNearAWay)
{
  constexpr int Width = 13;
  constexpr int Height = 11;
  SampleGrid grid;
  grid.SetPlace(vec2(1), vec2(0), vec2(Width, Height));
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> unit(0, 1);
  long visited = 0;
  for (int trial = 0; trial < 20000; ++trial)
  {
    const vec2 a(14 * unit(engine) - 0.5, 12 * unit(engine) - 0.5);
    const double length = trial % 7 == 0 ? 0 : 6 * unit(engine);
    const double angle = 7 * unit(engine);
    const vec2 b = a + length * vec2(std::cos(angle), std::sin(angle));
    const double near = SampleGrid::NearestRow * 0.999 * unit(engine);
    std::map<unsigned int, double> found;
    grid.ForEachNear(a, b, near, [&](unsigned int sample, double distance) {
      EXPECT_TRUE(found.emplace(sample, distance).second) << "twice";
    });
    for (unsigned int n = 0; n < Width * Height; ++n)
    {
      const vec2 centre(n % Width + 0.5, n / Width + 0.5);
      ASSERT_EQ(grid.SampleAt(n), centre);
      const double distance = DistanceToSide(centre, a, b);
      const auto it = found.find(n);
      ASSERT_EQ(it != found.end(), distance <= near)
        << a.x << " " << a.y << ", " << b.x << " " << b.y;
      if (it != found.end())
      {
        EXPECT_NEAR(it->second, distance, 1e-12);
      }
    }
    visited += long(found.size());
  }
  EXPECT_GT(visited, 10000);
}
