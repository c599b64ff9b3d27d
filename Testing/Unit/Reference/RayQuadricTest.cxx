// SPDX-License-Identifier: BSD-3-Clause
// The crossings of rays with balls, sticks and hulls, against the distance from their axis
// at points along the ray.
#include "RayQuadric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace wfv;
using namespace wfv::reference;

namespace
{
// How far the point lies outside the body: below 0 inside. Of a hull, the least over many
// balls between its ends.
double Outside(const Body& b, const vec3& x)
{
  if (b.Kind == Body::Shape::Ball)
  {
    return glm::length(x - b.P) - b.R;
  }
  const vec3 axis = glm::normalize(b.Q - b.P);
  const double z = glm::dot(x - b.P, axis);
  if (b.Kind == Body::Shape::Stick)
  {
    const double side = glm::length(x - b.P - axis * z) - b.R;
    return std::max({ side, -z, z - glm::length(b.Q - b.P) });
  }
  constexpr int Balls = 4000;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= Balls; i++)
  {
    const double v = double(i) / Balls;
    const vec3 centre = b.P * (1 - v) + b.Q * v;
    least = std::min(least, glm::length(x - centre) - (b.R * (1 - v) + b.S * v));
  }
  return least;
}

// The balls of a hull are so near each other that their union misses it by less.
constexpr double Sampling = 1e-6;

vec3 RandomPoint(std::mt19937& random)
{
  std::uniform_real_distribution<double> u(-1, 1);
  return vec3(u(random), u(random), u(random));
}
}

class RayQuadric : public ::testing::TestWithParam<Body::Shape>
{
};

TEST_P(RayQuadric, CrossesWhereTheSurfaceIs)
{
  constexpr unsigned Seed = 7;
  std::mt19937 random(Seed);
  std::uniform_real_distribution<double> radius(0.05, 0.6);
  int hits = 0;
  for (int k = 0; k < 400; k++)
  {
    Body b;
    b.Kind = this->GetParam();
    b.P = RandomPoint(random);
    b.Q = RandomPoint(random);
    b.R = radius(random);
    b.S = radius(random);
    const vec3 o = RandomPoint(random) * 2.0;
    const vec3 d = glm::normalize(b.P + RandomPoint(random) * 0.7 - o);
    const Crossings c = Cross(b, o, d);
    double least = 1;
    for (double t = -4; t <= 4; t += 0.05)
    {
      least = std::min(least, Outside(b, o + d * t));
    }
    ASSERT_TRUE(c.Hit() || least > -Sampling) << "missed, number " << k;
    if (c.Hit())
    {
      hits++;
      EXPECT_NEAR(Outside(b, o + d * c.Entry), 0, Sampling) << k;
      EXPECT_NEAR(Outside(b, o + d * c.Exit), 0, Sampling) << k;
      EXPECT_LE(glm::dot(d, c.EntryNormal), 0) << k;
      EXPECT_GE(glm::dot(d, c.ExitNormal), 0) << k;
      // the normal is the direction in which one leaves the body soonest
      constexpr double Step = 1e-3;
      EXPECT_NEAR(Outside(b, o + d * c.Entry + c.EntryNormal * Step), Step, 2 * Sampling) << k;
    }
  }
  EXPECT_GT(hits, 50);
}

INSTANTIATE_TEST_SUITE_P(
  All, RayQuadric, ::testing::Values(Body::Shape::Ball, Body::Shape::Stick, Body::Shape::Hull));
