// SPDX-License-Identifier: BSD-3-Clause
// Direction maps made from views whose formulas are known, with seams, tears and holes.
#include "Projections/DirectionMap.h"
#include "SampledMap.h"
#include "SampledView.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Radians: float32 in the tables.
constexpr double MapRounding = 2e-7;

// Pixels: what the search counts as found (WFV_SEARCH_REST), and some.
constexpr double Found = 0.02;

// Of 4,000: in the outer half of a pixel on a border, which the search leaves again.
constexpr int MostLost = 2;

struct MapCase
{
  const char* Projection;
  double Fov;
  int Width;
  int Height;
};

// The whole sphere with a seam; a disc with nothing round it, which sees behind; a break
// between rows of faces; a window.
const MapCase Cases[] = { { "equirectangular", 360, 128, 64 },
  { "azimuthal-equidistant", 300, 96, 96 }, { "equi-angular-cubemap", 360, 120, 80 },
  { "perspective", 100, 64, 48 }, { "hammer", 360, 128, 64 } };

View FormulaOf(const MapCase& c)
{
  ViewOptions o;
  const Projection& p = *FindProjection(c.Projection);
  o.HorizontalFov = c.Fov;
  o.VerticalFov = p.Axis == Family::Azimuthal || p.Axis == Family::Planar ? c.Fov : c.Fov / 2;
  o.Aspect = double(c.Width) / c.Height;
  return View(p, o);
}

View SampledOf(const std::shared_ptr<const DirectionMap>& map)
{
  ViewOptions o;
  o.Map = map;
  return View(SampledProjection(), o);
}

vec2 NdcOf(const DirectionMap& map, double x, double y)
{
  return vec2(2 * (x + 0.5) / map.GetWidth() - 1, 2 * (y + 0.5) / map.GetHeight() - 1);
}
}

TEST(DirectionMap, RaysOfPixelsAreTheFiles)
{
  for (const MapCase& c : Cases)
  {
    const View formula = FormulaOf(c);
    const auto map = reference::SampleView(formula, c.Width, c.Height);
    const View sampled = SampledOf(map);
    for (int y = 0; y < c.Height; y++)
    {
      for (int x = 0; x < c.Width; x++)
      {
        const ViewRay a = formula.Ray(NdcOf(*map, x, y));
        const ViewRay b = sampled.Ray(NdcOf(*map, x, y));
        ASSERT_EQ(a.Inside, b.Inside) << c.Projection << " " << x << " " << y;
        if (a.Inside)
        {
          ASSERT_LT(glm::length(a.Direction - b.Direction), MapRounding) << c.Projection;
        }
      }
    }
    EXPECT_FALSE(sampled.Ray(vec2(1.01, 0)).Inside);
    EXPECT_NEAR(glm::length(sampled.Ray(vec2(0, std::nan(""))).Direction), 1, MapRounding);
  }
}

TEST(DirectionMap, ForwardFindsTheRayAgain)
{
  for (const MapCase& c : Cases)
  {
    const View formula = FormulaOf(c);
    const auto map = reference::SampleView(formula, c.Width, c.Height);
    const View sampled = SampledOf(map);
    int lost = 0;
    for (int i = 0; i < 4000; i++)
    {
      const vec2 at =
        NdcOf(*map, std::fmod(i * 7.31, c.Width - 1.0), std::fmod(i * 3.77, c.Height - 1.0));
      const ViewRay ray = sampled.Ray(at);
      if (!ray.Inside)
      {
        continue;
      }
      const NdcPoint found = sampled.Forward(ray.Direction * 10.0);
      const ViewRay again = sampled.Ray(vec2(found.Ndc.x, found.Ndc.y));
      const vec3 right = sampled.Ray(at + vec2(2.0 / c.Width, 0)).Direction - ray.Direction;
      const vec3 up = sampled.Ray(at + vec2(0, 2.0 / c.Height)).Direction - ray.Direction;
      const double pixel = std::max(glm::length(right), glm::length(up));
      // the same direction, wherever it is found: some are shown twice
      lost +=
        !found.Inside || glm::length(again.Direction - ray.Direction) > Found * pixel + MapRounding;
    }
    EXPECT_LE(lost, MostLost) << c.Projection;
  }
}

TEST(DirectionMap, CapsBoundAllThatIsSeenOfThem)
{
  for (const MapCase& c : Cases)
  {
    const auto map = reference::SampleView(FormulaOf(c), c.Width, c.Height);
    const View sampled = SampledOf(map);
    for (const vec3& centre : RandomDirections(200))
    {
      for (double angle : { 1e-4, 0.01, 0.04, 0.1, 0.3 })
      {
        const Boxes boxes = CapBoxes(centre, angle, sampled.GetParameters());
        for (int i = 0; i < 16 * c.Width * c.Height; i += 13)
        {
          const double x = 0.25 * (i % (4 * c.Width)) - 0.375;
          const double y = 0.25 * (i / (4 * c.Width)) - 0.375;
          const vec2 ndc = NdcOf(*map, x, y);
          const ViewRay ray = sampled.Ray(ndc);
          if (ray.Inside && glm::length(ray.Direction - centre) < angle * 0.99)
          {
            ASSERT_TRUE(boxes.Hold(ndc))
              << c.Projection << " " << Text(centre) << " " << angle << " " << Text(ndc);
          }
        }
      }
    }
  }
}

namespace
{
// Of enough pixels for pieces.
MapCase Finer(const MapCase& c)
{
  return { c.Projection, c.Fov, 6 * c.Width, 6 * c.Height };
}

// Caps that one piece shows each: all at 3,000 random places and of several sizes.
template <typename Check>
int ForPieces(const View& sampled, const Check& check)
{
  int pieces = 0;
  for (const vec3& centre : RandomDirections(3000))
  {
    for (const double angle : { 1e-3, 0.01, 0.03, 0.1 })
    {
      if (const auto piece = PieceOf(centre, angle, sampled.GetParameters()))
      {
        check(*piece, centre, angle);
        pieces++;
      }
    }
  }
  return pieces;
}
}

// No two places in the rectangle of a piece see one direction: each is found again from the middle.
TEST(DirectionMap, PiecesShowADirectionOnce)
{
  for (const MapCase& small : Cases)
  {
    const MapCase c = Finer(small);
    const View sampled = SampledOf(reference::SampleView(FormulaOf(c), c.Width, c.Height));
    const WfvView& view = sampled.GetParameters();
    const int pieces = ForPieces(sampled, [&](const Piece& piece, const vec3&, double) {
      const vec4& r = piece.Rectangle;
      for (int i = 0; i < 9; i++)
      {
        const vec2 ndc(
          r.x + (r.z - r.x) * (i % 3 + 0.02) / 2.04, r.y + (r.w - r.y) * (i / 3 + 0.02) / 2.04);
        const ViewRay ray = sampled.Ray(ndc);
        ASSERT_TRUE(ray.Inside) << c.Projection << " " << Text(ndc);
        const vec3 found = PlaceIn(r, ray.Direction, view);
        const vec2 place(0.5 * (ndc.x + 1) * c.Width - 0.5, 0.5 * (ndc.y + 1) * c.Height - 0.5);
        ASSERT_LT(glm::length(vec2(found.x, found.y) - place), Found)
          << c.Projection << " " << Text(ndc);
      }
    });
    EXPECT_GT(pieces, 500) << c.Projection;
  }
}

// Edges of triangles within a cap lie as near to their chords as the curvature of its piece says,
// at every place between their ends; some lie a tenth as far beside.
TEST(DirectionMap, EdgesLieBesideTheirChordsAsFarAsPiecesSay)
{
  double worst = 0;
  for (const MapCase& small : Cases)
  {
    const MapCase c = Finer(small);
    const View sampled = SampledOf(reference::SampleView(FormulaOf(c), c.Width, c.Height));
    const WfvView& view = sampled.GetParameters();
    ForPieces(sampled, [&](const Piece& piece, const vec3& centre, double angle) {
      const vec3 side = 0.9 * angle * glm::normalize(glm::cross(centre, vec3(0.3, 0.5, -0.8)));
      const vec3 other = glm::cross(centre, side);
      for (const vec3& from : { centre + side, centre - other, centre + 0.6 * (side + other) })
      {
        const vec3 to = centre - 0.5 * side + 0.7 * other;
        const auto at = [&](double t) {
          return vec2(PlaceIn(piece.Rectangle, glm::normalize(from + t * (to - from)), view));
        };
        const vec2 p = at(0);
        const vec2 way = at(1) - p;
        const double chord = glm::length(way);
        const double beside = BesideChord(chord, piece.Curvature);
        for (int i = 1; i < 8; i++)
        {
          const double off = std::abs(Cross(at(i / 8.) - p, way)) / chord;
          ASSERT_LE(off, beside + Found) << c.Projection << " " << Text(centre) << " " << angle;
          worst = std::max(worst, off / beside);
        }
      }
    });
  }
  EXPECT_GT(worst, 0.1);
}

TEST(DirectionMap, RefusesWhatIsNoMap)
{
  std::vector<float> good;
  for (int i = 0; i < 6; i++)
  {
    good.insert(good.end(), { 0.f, 0.6f, -0.8f });
  }
  EXPECT_EQ(DirectionMap::Check(3, 2, good), "");
  EXPECT_NE(DirectionMap::Check(2, 2, good), "");
  EXPECT_NE(DirectionMap::Check(6, 1, good), "");
  EXPECT_NE(DirectionMap::Check(3, 2, std::vector<float>(18, 0.f)), "");
  std::vector<float> bad = good;
  bad[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(DirectionMap::Check(3, 2, bad).find("column 1 of row 1 has a direction that is not"),
    std::string::npos);
  bad[4] = 0.7f;
  EXPECT_NE(DirectionMap::Check(3, 2, bad).find("length"), std::string::npos);
}

TEST(DirectionMap, WithoutAMapNothingIsSeen)
{
  const View view(SampledProjection(), ViewOptions());
  EXPECT_FALSE(view.Ray(vec2(0, 0)).Inside);
  EXPECT_FALSE(view.Forward(vec3(0, 0, -5)).Inside);
}
