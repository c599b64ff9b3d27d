// SPDX-License-Identifier: BSD-3-Clause
// The ray caster's decision in double against the same in rational numbers, which are exact:
// rays beside and along edges, through vertices and in the planes of triangles.
#include "Rational.h"
#include "RayTriangle.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace wfv;
using namespace wfv::reference;

namespace
{
using Vector = RationalVector;
using Triangle = std::array<vec3, 3>;

// What is true of a ray and a triangle.
struct Truth
{
  Vector Edges;    // edge functions
  bool Meets;      // the closed triangle, ahead, not edge-on
  bool Beside;     // some edge has it outside
  double Distance; // of the place in the plane, along the direction
};

Truth TruthOf(const vec3& origin, const vec3& direction, const Triangle& v)
{
  const Vector d = Exact(direction);
  const Vector o = Exact(origin);
  const Vector w[] = { Minus(Exact(v[0]), o), Minus(Exact(v[1]), o), Minus(Exact(v[2]), o) };
  Truth t;
  t.Edges = { { Dot(d, Cross(w[1], w[2])), Dot(d, Cross(w[2], w[0])), Dot(d, Cross(w[0], w[1])) } };
  const Vector n = Cross(Minus(w[1], w[0]), Minus(w[2], w[0]));
  const Rational along = Dot(n, d);
  const bool up = t.Edges[0] >= 0 && t.Edges[1] >= 0 && t.Edges[2] >= 0;
  const bool down = t.Edges[0] <= 0 && t.Edges[1] <= 0 && t.Edges[2] <= 0;
  t.Beside = !up && !down;
  const Rational distance = along == 0 ? Rational(0) : Rational(Dot(n, w[0]) / along);
  t.Meets = !t.Beside && distance > 0;
  t.Distance = double(Rational(distance * Dot(d, d)));
  return t;
}

struct Tally
{
  int Hits = 0;
  int OnEdge = 0; // some edge function is 0
  int EdgeOn = 0; // not hit, being rounding alone
  int Taken = 0;  // though beside, within rounding
};

// Times the rounding of the edge functions as a share of their sum, and the size of the triangle
// along the ray: how far a distance may be off. Two shares meet, the hit's and their sum's.
constexpr double DistanceShare = 2;

void ExpectTrue(const vec3& o, const vec3& d, const Triangle& v, Tally& tally)
{
  const Truth truth = TruthOf(o, d, v);
  const RayTriangleHit hit = IntersectTriangle(o, d, v);
  const vec3 w[] = { v[0] - o, v[1] - o, v[2] - o };
  bool decided = false; // by an edge function that is more than rounding
  double sum = 0;
  double bound = 0;
  for (int i = 0; i < 3; ++i)
  {
    const EdgeFunction e = EvaluateEdge(d, w[(i + 1) % 3], w[(i + 2) % 3]);
    const Rational error = abs(Rational(e.Value) - truth.Edges[i]);
    ASSERT_LE(error, Rational(e.Bound)) << test::Text(o) << test::Text(d);
    decided = decided || std::abs(e.Value) > e.Bound;
    sum += e.Value;
    bound += e.Bound;
    tally.OnEdge += truth.Edges[i] == 0;
    // what is taken though it passes beside passes within rounding
    const bool against = truth.Beside && hit.Found && std::abs(e.Value) > e.Bound &&
      (e.Value > 0) != (truth.Edges[i] > 0);
    ASSERT_FALSE(against);
  }
  ASSERT_TRUE(hit.Found || !truth.Meets || !decided) << test::Text(o) << test::Text(d);
  if (hit.Found && truth.Meets)
  {
    const double farthest = std::max({ glm::length(w[0]), glm::length(w[1]), glm::length(w[2]) });
    const double share = DistanceShare * bound / std::abs(sum);
    ASSERT_NEAR(hit.Distance, truth.Distance, share * farthest * glm::length(d));
  }
  tally.Hits += hit.Found;
  tally.EdgeOn += !hit.Found && truth.Meets;
  tally.Taken += hit.Found && truth.Beside;
}
}

// Coordinates of few bits, so that many rays lie exactly in planes and through corners.
TEST(Rational, RaysInPlanes)
{
  for (const double scale : { std::ldexp(1.0, -140), 1.0, std::ldexp(1.0, 26) })
  {
    std::mt19937 engine(1);
    std::uniform_int_distribution<int> whole(-3, 3);
    const auto place = [&] { return vec3(whole(engine), whole(engine), whole(engine)); };
    Tally tally;
    for (int i = 0; i < 20000; ++i)
    {
      const Triangle v{ { place() * scale, place() * scale, place() * scale } };
      const vec3 d = place();
      const vec3 o = i % 2 ? vec3(0) : place() * scale;
      ExpectTrue(o, i % 3 || d == vec3(0) ? d : glm::normalize(d), v, tally);
      ASSERT_FALSE(HasFatalFailure());
    }
    EXPECT_GT(tally.Hits, 500);
    EXPECT_GT(tally.OnEdge, 3000);
  }
}

// Needles and slivers, far from the origin or round the eye, and rays at their edges, rounded.
TEST(Rational, RaysAtEdges)
{
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto place = [&] { return vec3(unit(engine), unit(engine), unit(engine)); };
  Tally tally;
  for (int i = 0; i < 20000; ++i)
  {
    const vec3 o = i % 4 ? vec3(0) : 1e5 * place();
    const vec3 a = o + place();
    const vec3 b = a + place() * std::pow(10, 4 * unit(engine) - 4);
    const double thin = std::pow(10, 6 * unit(engine) - 6);
    const Triangle v{ { a, b, a + (b - a) * unit(engine) + thin * place() } };
    const double t = unit(engine);
    const vec3 target = i % 3 == 0 ? v[1] : v[0] * (1 - t) + v[2] * t;
    ExpectTrue(o, glm::normalize(target - o), v, tally);
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_GT(tally.Hits, 5000);
  EXPECT_GT(tally.Taken, 100); // rounding is met, or the check says nothing
}
