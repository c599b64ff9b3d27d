// SPDX-License-Identifier: BSD-3-Clause
// The hierarchy of boxes against asking every triangle: the same triangles wherever a limit
// does not leave them out, by one ray or by several together, none that a ray truly meets is lost,
// and boxes without a volume,
// of denormal or of endless size are met as others are.
#include "RayTriangle.h"
#include "TriangleTree.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

using namespace wfv;
using namespace wfv::reference;

namespace
{
class Meshes
{
public:
  void Add(const vec3& a, const vec3& b, const vec3& c)
  {
    const vtkIdType first = vtkIdType(this->Soup.Points.size());
    this->Soup.Points.insert(this->Soup.Points.end(), { a, b, c });
    this->Soup.Triangles.push_back({ { first, first + 1, first + 2 } });
    this->Soup.CellIds.push_back(vtkIdType(this->Soup.CellIds.size()));
  }

  vec3 Place(double size)
  {
    std::uniform_real_distribution<double> unit(-size, size);
    return vec3(unit(this->Engine), unit(this->Engine), unit(this->Engine));
  }

  // All sizes, needles, slivers and flat ones along the axes, points and lines.
  void AddOfAllShapes(int count, double scale)
  {
    for (int i = 0; i < count; ++i)
    {
      const vec3 a = this->Place(10 * scale);
      const vec3 side = this->Place(scale * std::pow(10, this->Place(3).x - 1));
      vec3 other = this->Place(scale * std::pow(10, this->Place(3).x - 1));
      other[i % 3] *= i % 2; // every second one is flat along an axis where `flat` is too
      vec3 flat = side;
      flat[i % 3] *= i % 2;
      const vec3 shapes[][2] = { { flat, other }, { side, side * 1e-13 }, { side, side * 0.5 },
        { vec3(0), vec3(0) }, { side, side + other * 1e-14 } };
      const auto& shape = shapes[i % 5];
      this->Add(a, a + shape[0], a + shape[1]);
    }
  }

  TriangleSoup Soup;

private:
  std::mt19937 Engine{ 1 };
};

// What a visit without a limit is told.
struct Found
{
  std::set<std::size_t>& Triangles;
  double operator()(std::size_t triangle)
  {
    EXPECT_TRUE(this->Triangles.insert(triangle).second) << "twice";
    return Box::Infinity;
  }
};

std::set<std::size_t> Visited(const TriangleTree& tree, const vec3& o, const vec3& d)
{
  std::set<std::size_t> found;
  tree.Visit(o, d, Found{ found });
  return found;
}

// A direction and others beside it, nearer and farther.
std::vector<vec3> Beside(const vec3& d, int n)
{
  const double spread = std::pow(10.0, -4.0 * (n % 4));
  const vec3 side = spread * vec3(d.y + 0.1, d.z - 0.2, d.x + 0.3);
  return { d, d + side, d - 0.7 * side, d + 0.5 * vec3(side.z, -side.y, side.x) };
}

std::set<std::size_t> OneByOne(const TriangleSoup& soup, const vec3& o, const vec3& d)
{
  std::set<std::size_t> found;
  const BoxRay ray(o, d);
  for (std::size_t n = 0; n < soup.Triangles.size(); ++n)
  {
    if (ray.Enter(Box::OfTriangle(soup, n)) < Box::Infinity)
    {
      found.insert(n);
    }
  }
  return found;
}

RayTriangleHit HitOf(const TriangleSoup& soup, std::size_t n, const vec3& o, const vec3& d)
{
  const auto& t = soup.Triangles[n];
  return IntersectTriangle(o, d, { { soup.Points[t[0]], soup.Points[t[1]], soup.Points[t[2]] } });
}

// Directions along the axes too, and those a rounding away from them.
std::vector<vec3> Directions()
{
  std::vector<vec3> all = test::RandomDirections(300);
  for (const double offset : { 0.0, 1e-310, 1e-300, 1e-16, 1e-9 })
  {
    const std::vector<vec3> special = test::SpecialDirections(offset);
    all.insert(all.end(), special.begin(), special.end());
  }
  return all;
}

void ExpectAllVisitedTogether(const TriangleTree& tree, const TriangleSoup& soup, const vec3& o,
  const std::vector<vec3>& directions)
{
  const auto parts = tree.Ahead(BoxRays(o, directions));
  for (const vec3& d : directions)
  {
    std::set<std::size_t> found;
    tree.Visit(parts, o, d, Found{ found });
    ASSERT_EQ(found, OneByOne(soup, o, d)) << test::Text(o) << " " << test::Text(d);
  }
}

void ExpectAllVisited(const TriangleSoup& soup, const std::vector<vec3>& origins)
{
  const TriangleTree tree(soup);
  std::size_t visited = 0;
  int number = 0;
  for (const vec3& o : origins)
  {
    for (const vec3& d : Directions())
    {
      const std::set<std::size_t> found = Visited(tree, o, d);
      ASSERT_EQ(found, OneByOne(soup, o, d)) << test::Text(o) << " " << test::Text(d);
      visited += found.size();
      ExpectAllVisitedTogether(tree, soup, o, Beside(d, number++));
    }
  }
  EXPECT_GT(visited, 100u);
}
}

TEST(TriangleTree, VisitsWhatEveryBoxAlone)
{
  for (const double scale : { 1e-40, 1.0, 1e8 })
  {
    Meshes meshes;
    meshes.AddOfAllShapes(2000, scale);
    ExpectAllVisited(meshes.Soup,
      { vec3(0), vec3(-0.0, 0.0, -0.0), vec3(0.3, -0.2, 0.7) * scale, meshes.Soup.Points[5],
        0.5 * (meshes.Soup.Points[9] + meshes.Soup.Points[10]) });
  }
}

TEST(TriangleTree, ManyAtOnePlace)
{
  Meshes meshes;
  for (int i = 0; i < 500; ++i) // no cut tells these apart
  {
    meshes.Add(vec3(-1, -1, -3), vec3(1, -1, -3), vec3(0, 1, -3));
  }
  for (int i = 0; i < 500; ++i) // every cut leaves nearly all of these on one side
  {
    const double size = std::pow(2.0, -i);
    meshes.Add(vec3(size, 0, -1), vec3(2 * size, 0, -1), vec3(size, size, -1));
  }
  ExpectAllVisited(meshes.Soup, { vec3(0), vec3(0.1, 0.2, -2), vec3(1e-100, 0, 1) });
}

TEST(TriangleTree, EndlessAndNoNumbers)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double endless = Box::Infinity;
  Meshes meshes;
  meshes.AddOfAllShapes(200, 1);
  meshes.Add(vec3(none, 0, 0), vec3(1, none, 0), vec3(0, 1, none));
  meshes.Add(vec3(none), vec3(none), vec3(none));
  meshes.Add(vec3(-endless, 1, -2), vec3(endless, 1, -2), vec3(0, -endless, -2));
  meshes.Add(vec3(1e308, 1e308, -1e308), vec3(-1e308), vec3(1e308));
  ExpectAllVisited(meshes.Soup, { vec3(0), vec3(0.3, -0.2, 0.7) });
}

// Rays aimed at places of the triangles, in rational numbers: those of which the doubles of
// the ray are exact. The triangle must be among those visited.
TEST(TriangleTree, LosesNoTriangleThatIsMet)
{
  std::mt19937 engine(2);
  std::uniform_int_distribution<int> whole(-1024, 1024);
  const auto place = [&] { return vec3(whole(engine), whole(engine), whole(engine)) / 64.0; };
  Meshes meshes;
  for (int i = 0; i < 3000; ++i)
  {
    const vec3 a = place();
    meshes.Add(a, a + place() / 1024.0, a + place() / 1024.0);
  }
  const TriangleTree tree(meshes.Soup);
  for (std::size_t n = 0; n < meshes.Soup.Triangles.size(); ++n)
  {
    const vec3 o = place();
    const vec3* const p = &meshes.Soup.Points[3 * n];
    for (const vec3& target :
      { p[0], p[1], (p[0] + p[1]) * 0.5, p[0] * 0.5 + (p[1] + p[2]) * 0.25 })
    {
      // not of unit length: exact
      ASSERT_EQ(Visited(tree, o, (target - o) / 64.0).count(n), 1u) << n;
    }
  }
}

// A limit on the distance leaves out nothing that is hit nearer.
TEST(TriangleTree, NearestIsThatOfAll)
{
  Meshes meshes;
  meshes.AddOfAllShapes(3000, 1);
  const TriangleSoup& soup = meshes.Soup;
  const TriangleTree tree(soup);
  int hits = 0;
  std::size_t asked = 0;
  for (const vec3& d : Directions())
  {
    const vec3 o = soup.Points[asked % soup.Points.size()];
    double nearest = Box::Infinity;
    const auto ask = [&](std::size_t n) {
      const RayTriangleHit hit = HitOf(soup, n, o, d);
      nearest = hit.Found ? std::min(nearest, hit.Distance) : nearest;
      ++asked;
      return nearest;
    };
    tree.Visit(o, d, ask);
    const double alone = std::exchange(nearest, Box::Infinity);
    tree.Visit(tree.Ahead(BoxRays(o, Beside(d, int(asked % 4)))), o, d, ask);
    ASSERT_EQ(nearest, alone) << test::Text(d);
    double expected = Box::Infinity;
    for (const std::size_t n : OneByOne(soup, o, d))
    {
      const RayTriangleHit hit = HitOf(soup, n, o, d);
      expected = hit.Found ? std::min(expected, hit.Distance) : expected;
    }
    ASSERT_EQ(nearest, expected) << test::Text(d);
    hits += nearest < Box::Infinity;
  }
  EXPECT_GT(hits, 100);
}
