// SPDX-License-Identifier: BSD-3-Clause
// Which cells are right where a ray lies in the plane of an edge: none too many, by an exact ray
// caster of another formula that is asked for the turned ray itself, and none too few, by rays
// turned to all sides.
#include "Metrics.h"
#include "RightAnswers.h"
#include "Witness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>

using namespace wfv;
using namespace wfv::reference;

namespace
{
const vec2 AllDistances(0, 1e30);

void Add(TriangleSoup& soup, const vec3& a, const vec3& b, const vec3& c)
{
  const vtkIdType first = vtkIdType(soup.Points.size());
  soup.Points.insert(soup.Points.end(), { a, b, c });
  soup.Triangles.push_back({ { first, first + 1, first + 2 } });
  soup.CellIds.push_back(vtkIdType(soup.CellIds.size()));
}

RationalVector Plus(const RationalVector& a, const RationalVector& b, const Rational& times)
{
  return { { a[0] + b[0] * times, a[1] + b[1] * times, a[2] + b[2] * times } };
}

// Where the ray meets the triangle, by Cramer's rule in its plane: in lengths of the direction, or
// nothing. Open: not on an edge.
std::optional<Rational> Meet(const TriangleSoup& soup, const vec3& origin, const RationalVector& d,
  std::size_t triangle, bool open)
{
  const auto& t = soup.Triangles[triangle];
  const RationalVector p = Exact(soup.Points[t[0]]);
  const RationalVector u = Minus(Exact(soup.Points[t[1]]), p);
  const RationalVector v = Minus(Exact(soup.Points[t[2]]), p);
  const RationalVector s = Minus(Exact(origin), p);
  const RationalVector across = Cross(d, v);
  const Rational determinant = Dot(u, across);
  if (determinant == 0)
  {
    return std::nullopt;
  }
  const Rational a = Dot(s, across) / determinant;
  const Rational b = Dot(d, Cross(s, u)) / determinant;
  const Rational distance = Dot(v, Cross(s, u)) / determinant;
  const bool inside = open ? a > 0 && b > 0 && a + b < 1 : a >= 0 && b >= 0 && a + b <= 1;
  return inside && distance > 0 ? std::make_optional(distance) : std::nullopt;
}

// Whether the cell is the nearest, or one of several as near; -1: nothing is met.
bool Sees(
  const TriangleSoup& soup, const vec3& origin, const RationalVector& d, vtkIdType cell, bool open)
{
  std::optional<Rational> own;
  if (cell >= 0)
  {
    own = Meet(soup, origin, d, std::size_t(cell), open);
    if (!own)
    {
      return false;
    }
  }
  for (std::size_t t = 0; t < soup.Triangles.size(); ++t)
  {
    // of what might hide it the closed triangle counts where the cell's own is open
    const std::optional<Rational> other = Meet(soup, origin, d, t, !open);
    if (vtkIdType(t) != cell && other && (!own || *other < *own))
    {
      return false;
    }
  }
  return true;
}

bool IsAnswer(const TriangleSoup& soup, const vec3& d, vtkIdType cell)
{
  return FindWitness(soup, { vec3(0), glm::normalize(d), AllDistances }, cell).has_value();
}

void ExpectAnswers(const TriangleSoup& soup, const vec3& d, const std::vector<vtkIdType>& answers)
{
  for (vtkIdType cell = -1; cell < vtkIdType(soup.Triangles.size()); ++cell)
  {
    const bool right = std::find(answers.begin(), answers.end(), cell) != answers.end();
    EXPECT_EQ(IsAnswer(soup, d, cell), right) << "cell " << cell;
  }
}

// A square before the eye, of two triangles, with another one behind it.
TriangleSoup Square()
{
  TriangleSoup soup;
  Add(soup, vec3(-1, -1, -2), vec3(1, -1, -2), vec3(1, 1, -2));
  Add(soup, vec3(-1, -1, -2), vec3(1, 1, -2), vec3(-1, 1, -2));
  Add(soup, vec3(-90, -90, -8), vec3(90, -90, -8), vec3(0, 90, -8));
  return soup;
}
}

TEST(RightAnswers, OfASharedEdge)
{
  const TriangleSoup soup = Square();
  ExpectAnswers(soup, vec3(0, 0, -1), { 0, 1 });
  ExpectAnswers(soup, vec3(0.5, 0, -2), { 0 });
  ExpectAnswers(soup, vec3(1, 0, -2), { 0, 2 });     // its rim
  ExpectAnswers(soup, vec3(1, 1, -2), { 0, 1, 2 });  // its corner
  ExpectAnswers(soup, vec3(1, -1, -2), { 0, 2 });    // that of one
  ExpectAnswers(soup, vec3(0, 1e-11, -2), { 1 });    // ten times as far from the edge as is one ray
  ExpectAnswers(soup, vec3(0, 1e-13, -2), { 0, 1 }); // a tenth
  ExpectAnswers(soup, vec3(0, 0, 1), { -1 });        // behind the eye
}

TEST(RightAnswers, OfATriangleSeenEdgeOn)
{
  TriangleSoup soup = Square();
  Add(soup, vec3(-1, 0, -1), vec3(1, 0, -1), vec3(0, 0, -1.5)); // in the plane y = 0
  ExpectAnswers(soup, vec3(0.3, 0, -2), { 0 });
  ExpectAnswers(soup, vec3(-0.3, 0, -2), { 1 });
}

// Thinner than anything that rays tell apart, at the ray, and farther from it than that.
TEST(RightAnswers, OfANeedle)
{
  for (const double thin : { 1e-9, 1e-14, 1e-30, 1e-300 })
  {
    TriangleSoup soup = Square();
    Add(soup, vec3(-0.3, 0, -1), vec3(0.3, 0, -1), vec3(0, thin, -1));
    ExpectAnswers(soup, vec3(0.01, 0, -1), { 0, 3 });
    ExpectAnswers(soup, vec3(0.01, -1e-10, -1), { 0 });
  }
}

// Each edge is decided by itself: what is behind may show where the one before it is not drawn,
// though beside the ray it is hidden or is not there.
TEST(RightAnswers, OfEdgesInOnePlane)
{
  const auto isAnswer = [](const TriangleSoup& soup, vtkIdType cell, double y = 0) {
    const vec3 d = glm::normalize(vec3(0.3, y, -2));
    return IsBehindEdges(soup, { vec3(0), d, AllDistances }, cell);
  };
  TriangleSoup soup;
  Add(soup, vec3(-1, 0, -2), vec3(1, 0, -2), vec3(0, -2, -2));
  Add(soup, vec3(-3, 0, -4), vec3(3, 0, -4), vec3(0, -1, -4));
  Add(soup, vec3(-90, -90, -8), vec3(90, -90, -8), vec3(0, 90, -8));
  ExpectAnswers(soup, vec3(0.3, 0, -2), { 0, 2 });
  EXPECT_TRUE(isAnswer(soup, 1));
  EXPECT_FALSE(isAnswer(soup, 1, -1e-10));                    // its edge is not at the ray
  Add(soup, vec3(1, 0, -2), vec3(-1, 0, -2), vec3(0, 2, -2)); // shares the edge of the nearest
  EXPECT_FALSE(isAnswer(soup, 1));
  EXPECT_FALSE(isAnswer(soup, 2));
}

// Where two triangles run through one another, one is before the other on either side.
TEST(RightAnswers, OfTwoThatCross)
{
  TriangleSoup soup;
  Add(soup, vec3(-3, -1, -2), vec3(3, -1, -2), vec3(0, 1, -2));
  Add(soup, vec3(-3, -1, -3.5), vec3(3, -1, -0.5), vec3(0, 1, -2)); // nearer to the right
  ExpectAnswers(soup, vec3(0, 0, -1), { 0, 1 });
  ExpectAnswers(soup, vec3(1e-13, 0, -1), { 0, 1 });
  ExpectAnswers(soup, vec3(1e-10, 0, -1), { 1 });
  ExpectAnswers(soup, vec3(-1e-13, 0, -1), { 0, 1 });
  ExpectAnswers(soup, vec3(-1e-10, 0, -1), { 0 });
}

TEST(RightAnswers, BetweenClipSpheres)
{
  const TriangleSoup soup = Square();
  const vec3 d = glm::normalize(vec3(0, 0, -1));
  EXPECT_FALSE(FindWitness(soup, { vec3(0), d, vec2(3, 9) }, 0));
  EXPECT_TRUE(FindWitness(soup, { vec3(0), d, vec2(3, 9) }, 2));
  EXPECT_TRUE(FindWitness(soup, { vec3(0), d, vec2(3, 7) }, -1));
  EXPECT_FALSE(FindWitness(soup, { vec3(0), d, vec2(3, 9) }, -1));
}

namespace
{
// Triangles whose coordinates have few bits: many edges and corners lie on one ray.
TriangleSoup FewBits(std::mt19937& engine, int count)
{
  std::uniform_int_distribution<int> whole(-2, 2);
  TriangleSoup soup;
  for (int i = 0; i < count; ++i)
  {
    std::array<vec3, 3> p;
    for (vec3& v : p)
    {
      v = vec3(whole(engine), whole(engine), whole(engine));
    }
    Add(soup, p[0], p[1], p[2]);
  }
  return soup;
}

// Rays turned to all sides, by less than AnswerAngle.
std::vector<RationalVector> Turned(const vec3& d, std::mt19937& engine)
{
  std::uniform_real_distribution<double> unit(-0.25, 0.25);
  std::vector<RationalVector> rays;
  for (int i = 0; i < 40; ++i)
  {
    const vec3 by = vec3(unit(engine), unit(engine), unit(engine)) * AnswerAngle;
    rays.push_back(Plus(Exact(d), Exact(by), 1));
  }
  return rays;
}
}

TEST(RightAnswers, AreSeenByTheirRaysAndNoOthersAre)
{
  std::mt19937 engine(3);
  std::uniform_int_distribution<int> whole(-2, 2);
  int several = 0;
  for (int i = 0; i < 150; ++i)
  {
    const TriangleSoup soup = FewBits(engine, 8);
    const vec3 o = i % 2 ? vec3(0) : vec3(whole(engine), whole(engine), whole(engine));
    const vec3 target(whole(engine), whole(engine), whole(engine));
    const vec3 d = glm::normalize(target == vec3(0) ? vec3(0, 0, 1) : target);
    const std::vector<RationalVector> turned = Turned(d, engine);
    int answers = 0;
    for (vtkIdType cell = -1; cell < vtkIdType(soup.Triangles.size()); ++cell)
    {
      const auto witness = FindWitness(soup, { o, d, AllDistances }, cell);
      answers += witness.has_value();
      if (witness)
      {
        const RationalVector by = Minus(*witness, Exact(d));
        ASSERT_LE(Dot(by, by), Rational(AnswerAngle) * Rational(AnswerAngle));
        ASSERT_TRUE(Sees(soup, o, *witness, cell, false)) << i << " cell " << cell;
        continue;
      }
      for (const RationalVector& ray : turned)
      {
        ASSERT_FALSE(Sees(soup, o, ray, cell, true)) << i << " cell " << cell;
      }
    }
    ASSERT_GE(answers, 1) << i;
    several += answers > 1;
  }
  EXPECT_GT(several, 30);
}

// What a picture shows on the other side of a tie is no error, and what is behind is one.
TEST(RightAnswers, CountInTheMetric)
{
  ViewOptions o;
  o.Radii = { { 0.1, 100 } };
  const View view(*FindProjection("equirectangular"), o);
  const RayCaster caster(Square(), view);
  const HitPicture truth = caster.Render(65, 33); // the middle looks along -z
  DrawnPicture drawn;
  drawn.Width = truth.Width;
  drawn.Height = truth.Height;
  for (const Hit& hit : truth.Hits)
  {
    drawn.Cell.push_back(float(hit.Cell + 1));
    drawn.Distance.push_back(float(hit.Distance));
  }
  const std::size_t middle = std::size_t(16) * 65 + 32;
  ASSERT_EQ(truth.Hits[middle].Cell, 0);
  drawn.Cell[middle] = 2;
  // the 48 points see the other side as well; no point does of a radius below the ray's rounding
  const Metrics tie = Compare(drawn, caster, truth, 1e-30);
  EXPECT_EQ(tie.Mismatched, 1);
  EXPECT_EQ(tie.Ties, 1);
  EXPECT_EQ(tie.UnexplainedPixels, 0);
  EXPECT_EQ(tie.MaxPx, 0);
  drawn.Cell[middle] = 3;
  EXPECT_EQ(Compare(drawn, caster, truth, 0.02).UnexplainedPixels, 1);
  drawn.Cell[middle] = 0;
  EXPECT_EQ(Compare(drawn, caster, truth, 0.02).UnexplainedPixels, 1);
}
