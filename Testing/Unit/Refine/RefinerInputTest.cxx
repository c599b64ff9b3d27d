// SPDX-License-Identifier: BSD-3-Clause
// Triangles that are hard to refine, and closed meshes: the work ends with a bounded number of
// pieces, and leaves no gap.
#include "Refine/RefinedView.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <string>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pieces of one triangle at the most. A triangle that fills 1024 x 512 pixels and whose edges are
// split as in the middle of a picture takes some 3,000; one beside a pole or round the circle of
// the eyes a hundred times as many, where the map stretches without end.
constexpr std::size_t MostPieces = 2000000;

struct Named
{
  std::string Name;
  Triangle Corners;
};

const double None = std::numeric_limits<double>::quiet_NaN();
const double Infinite = std::numeric_limits<double>::infinity();

// The corners of a triangle that is nowhere near an axis.
const vec3 Corners[] = { vec3(1, 0.2, -0.3), vec3(-0.4, 1, 0.2), vec3(0.3, -0.8, 1.1) };

// Triangles of this size.
void AddBadTriangles(double size, std::vector<Named>& all)
{
  const vec3& p = Corners[0];
  const vec3& q = Corners[1];
  const vec3& r = Corners[2];
  const vec3 middle = (p + q + r) / 3.0;
  const vec3 normal = glm::normalize(glm::cross(q - p, r - p));
  const vec3 away = size * (1e-6 * normal - middle);
  all.push_back({ "1e-6 of its size from the eye, size " + std::to_string(size),
    { size * p + away, size * q + away, size * r + away } });
  all.push_back({ "round the vertical axis, size " + std::to_string(size),
    { size * vec3(1, 0.1, 0), size * vec3(-1, 0.1, 1), size * vec3(-1, 0.1, -1) } });
  all.push_back({ "in the half plane behind, size " + std::to_string(size),
    { size * vec3(0, 1, 1), size * vec3(0, -1, 1), size * vec3(0, 0, 3) } });
}

std::vector<Named> BadTriangles()
{
  const vec3& p = Corners[0];
  const vec3& q = Corners[1];
  const vec3& r = Corners[2];
  const vec3 middle = (p + q + r) / 3.0;
  std::vector<Named> all{ { "a corner that is no number", { p, q, vec3(None, 0, 0) } },
    { "an infinite corner", { p, q, vec3(0, Infinite, 0) } },
    { "nothing but infinite corners", { vec3(Infinite), vec3(-Infinite), vec3(None) } },
    { "three corners at one place", { p, p, p } }, { "two corners at one place", { p, q, q } },
    { "three corners at the eye", { vec3(0), vec3(0), vec3(0) } },
    { "corners on a line", { p, p + q, p + 2.0 * q } },
    { "corners on a line through the eye", { p, -p, 3.0 * p } },
    { "the eye on a corner", { vec3(0), q, r } },
    { "the eye on a corner, large", { vec3(0), 1e6 * q, 1e6 * r } },
    { "the eye on an edge", { p, -2.0 * p, r } },
    { "the eye on an edge, large", { 1e6 * p, -2e6 * p, 1e6 * r } },
    { "the eye in a triangle", { p - middle, q - middle, r - middle } },
    { "the eye in the plane, beside",
      { p - middle + 3.0 * (q - p), q - middle + 3.0 * (q - p), r - middle + 3.0 * (q - p) } },
    { "huge numbers", { 1e150 * p, 1e150 * q, 1e150 * r } },
    { "tiny numbers", { 1e-150 * p, 1e-150 * q, 1e-150 * r } },
    { "from 1e-3 to 1e9", { 1e-3 * p, 1e9 * q, 1e9 * r } },
    { "from 1e-3 to 1e9, a needle", { 1e-3 * p, 1e9 * p, 1e9 * (p + 1e-6 * q) } } };
  for (const double rounding : { 0.0, 1e-17 })
  {
    all.push_back({ "round a pole, in the plane of the seam",
      { vec3(rounding, 0, -0.4), vec3(-rounding, 0, 0.6), vec3(0, 1, 0.6) } });
  }
  for (const double size : { 1e-3, 1.0, 1e3, 1e9 })
  {
    AddBadTriangles(size, all);
  }
  return all;
}

bool IsSound(const Pieces& pieces)
{
  const bool weights =
    std::all_of(pieces.Vertices.begin(), pieces.Vertices.end(), [](const PieceVertex& vertex) {
      double sum = 0;
      for (const double w : vertex.Weights)
      {
        sum += w >= 0 && w <= 1 ? w : None;
      }
      return std::abs(sum - 1) < 1e-9;
    });
  return weights && pieces.Indices.size() == 3 * pieces.Numbers.size() &&
    pieces.Sources.size() == pieces.Vertices.size() &&
    std::all_of(pieces.Indices.begin(), pieces.Indices.end(),
      [&](unsigned int index) { return index < pieces.Vertices.size(); });
}

// A ball round a place, 12 parts^2 triangles. parts is a power of two, so that faces share corners
// to the last bit.
std::vector<Triangle> MakeBall(const vec3& centre, double radius, int parts)
{
  std::vector<Triangle> all;
  const auto at = [&](const vec3& cube) { return centre + radius * glm::normalize(cube); };
  for (int face = 0; face < 6; face++)
  {
    const auto corner = [face, parts](int i, int j) {
      const double side = face % 2 ? 1 : -1;
      vec3 c(0);
      c[face / 2] = side;
      c[(face / 2 + 1) % 3] = 2.0 * i / parts - 1;
      c[(face / 2 + 2) % 3] = side * (2.0 * j / parts - 1);
      return c;
    };
    for (int i = 0; i < parts; i++)
    {
      for (int j = 0; j < parts; j++)
      {
        const vec3 a = at(corner(i, j));
        const vec3 b = at(corner(i + 1, j));
        const vec3 c = at(corner(i + 1, j + 1));
        const vec3 d = at(corner(i, j + 1));
        all.push_back({ a, b, c });
        all.push_back({ a, c, d });
      }
    }
  }
  return all;
}

using Ends = std::array<double, 6>;

// How many more pieces have an edge in one direction than in the other.
std::map<Ends, int> CountOpenEdges(const RefinedView& v, const std::vector<Triangle>& mesh)
{
  std::map<Ends, int> edges;
  for (const Triangle& t : mesh)
  {
    const Pieces pieces = v.Refine(t);
    for (std::size_t i = 0; i < pieces.Indices.size(); i++)
    {
      const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
      const vec3 a = PlaceOf(t, pieces.Vertices[pieces.Indices[i]]);
      const vec3 b = PlaceOf(t, pieces.Vertices[pieces.Indices[next]]);
      edges[Ends{ a.x, a.y, a.z, b.x, b.y, b.z }]++;
      edges[Ends{ b.x, b.y, b.z, a.x, a.y, a.z }]--;
    }
  }
  return edges;
}

// Edges without an opposite that can be seen.
long CountGaps(const RefinedView& v, const std::vector<Triangle>& mesh, std::string& where)
{
  long gaps = 0;
  for (const auto& [e, count] : CountOpenEdges(v, mesh))
  {
    const vec3 a(e[0], e[1], e[2]);
    const vec3 b(e[3], e[4], e[5]);
    const vec3 middle = 0.5 * (a + b);
    const bool torn = std::min({ v.PixelsFromTear(a), v.PixelsFromTear(b),
                        v.PixelsFromTear(middle) }) <= v.GetTornPixels();
    if (count > 0 && !torn && v.IsSeen(middle))
    {
      gaps++;
      where = wfv::test::Text(a) + " to " + wfv::test::Text(b);
    }
  }
  return gaps;
}

// All but every second eye, a right one, which sees the mirror image of the left one before.
std::vector<std::unique_ptr<RefinedView>> ViewsOf(const Projection& p)
{
  std::vector<std::unique_ptr<RefinedView>> views = MonoViews(p);
  std::vector<std::unique_ptr<RefinedView>> eyes = StereoViews(p);
  for (std::size_t i = 0; i < eyes.size(); i += 2)
  {
    views.push_back(std::move(eyes[i]));
  }
  return views;
}
}

class RefinedInput : public testing::TestWithParam<std::string>
{
};

TEST_P(RefinedInput, EndsWithABoundedNumberOfPieces)
{
  const Projection& p = *FindProjection(this->GetParam());
  std::size_t most = 0;
  std::string which;
  for (const auto& view : ViewsOf(p))
  {
    for (const Named& bad : BadTriangles())
    {
      const Pieces pieces = view->Refine(bad.Corners);
      EXPECT_TRUE(IsSound(pieces)) << bad.Name << ", " << view->GetName();
      EXPECT_LE(pieces.Numbers.size(), MostPieces) << bad.Name << ", " << view->GetName();
      if (pieces.Numbers.size() > most)
      {
        most = pieces.Numbers.size();
        which = bad.Name + ", " + view->GetName();
      }
    }
  }
  std::cout << "at the most " << most << " pieces: " << which << std::endl;
}

TEST_P(RefinedInput, ClosedMeshesStayClosed)
{
  const Projection& p = *FindProjection(this->GetParam());
  const std::vector<Triangle> meshes[] = { MakeBall(vec3(0.3, 0.2, -0.1), 3, 1),
    MakeBall(vec3(0.3, 0.2, -0.1), 3, 8), MakeBall(vec3(0.3, 0.1, 1.5), 1, 4),
    MakeBall(vec3(0), 2, 2) };
  for (const auto& view : ViewsOf(p))
  {
    for (const std::vector<Triangle>& mesh : meshes)
    {
      std::string where;
      EXPECT_EQ(CountGaps(*view, mesh, where), 0)
        << mesh.size() << " triangles, " << view->GetName() << "\n  " << where;
    }
  }
}

namespace
{
// A seam, a rim, the borders of faces: each takes minutes.
const std::vector<std::string> Few{ "equirectangular", "azimuthal-equidistant",
  "equi-angular-cubemap" };

std::vector<std::string> AllButFew()
{
  std::vector<std::string> names;
  for (const Projection& p : Projections())
  {
    if (std::find(Few.begin(), Few.end(), p.Name) == Few.end())
    {
      names.push_back(p.Name);
    }
  }
  return names;
}
}

INSTANTIATE_TEST_SUITE_P(All, RefinedInput, testing::ValuesIn(Few),
  [](const auto& info) { return NameOfProjection(info.param); });
INSTANTIATE_TEST_SUITE_P(Other, RefinedInput, testing::ValuesIn(AllButFew()),
  [](const auto& info) { return NameOfProjection(info.param); });
