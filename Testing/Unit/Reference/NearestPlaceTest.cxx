// SPDX-License-Identifier: BSD-3-Clause
// The search for the nearest place where a cell is seen, or is at all, against places known
// beforehand.
#include "Metrics.h"
#include "NearestFace.h"
#include "NearestPlace.h"
#include "PlacedTriangles.h"
#include "RayCaster.h"

#include <gtest/gtest.h>

using namespace wfv;
using namespace wfv::reference;
using namespace wfv::test;

namespace
{
constexpr int Width = PlacedWidth;
constexpr int Height = PlacedHeight;
const vec2 Centre(600.5, 256.5); // of pixel (600, 256), next to the equator

// Pixels: the ray is cast so far inside of an edge, and the frame is true to first order.
constexpr double PlaceSlack = 2 * ApartFromEdge;

class Picture : public PlacedTriangles
{
public:
  // A needle up and down: its left side is on the meridian so many pixels right of Centre.
  void AddNeedle(double distance, double beside, double thickness)
  {
    const vec2 top = Centre + vec2(beside, -20);
    this->Add(distance, { { top, top + vec2(thickness, 0), Centre + vec2(beside, 20) } });
  }

  double Nearest(vtkIdType cell) const
  {
    const RayCaster caster(this->Soup, WholeSphere());
    return NearestPlace(caster, Width, Height, Centre, cell, SearchLimit);
  }

  double NearestAtAll(vtkIdType cell) const
  {
    const RayCaster caster(this->Soup, WholeSphere());
    return NearestFace(caster, Width, Height, Centre, cell, SearchLimit);
  }
};
}

TEST(NearestPlace, FindsANeedleAHundredthOfAPixelWide)
{
  Picture picture;
  picture.AddNeedle(10, 0.3, 0.01);
  EXPECT_NEAR(picture.Nearest(0), 0.3, PlaceSlack);
  // on the other side its slanting edge is nearest, half as thick at this height
  Picture left;
  left.AddNeedle(10, -0.3, 0.01);
  EXPECT_NEAR(left.Nearest(0), 0.295, PlaceSlack);
}

TEST(NearestPlace, IsZeroWhereTheCellIsSeen)
{
  Picture picture;
  picture.Add(10, { { Centre + vec2(-3, 3), Centre + vec2(3, 3), Centre + vec2(0, -5) } });
  EXPECT_LE(picture.Nearest(0), PlaceSlack);
}

TEST(NearestPlace, IsInfiniteWhereTheCellIsHidden)
{
  Picture picture;
  picture.AddNeedle(10, 0.3, 0.01);
  picture.Add(5, { { Centre + vec2(-90, 60), Centre + vec2(90, 60), Centre + vec2(0, -90) } });
  EXPECT_EQ(picture.Nearest(0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(picture.Nearest(7), std::numeric_limits<double>::infinity()) << "no such cell";
}

TEST(NearestPlace, GoesRoundWhatHidesTheCell)
{
  // the wall's upper edge runs level, 5 pixels above; its corners are far apart, so the
  // great circle between them would rise without the corner in the middle
  Picture picture;
  picture.AddNeedle(10, 0.3, 0.01);
  for (int i = -20; i < 20; ++i)
  {
    const vec2 a = Centre + vec2(i, -5);
    picture.Add(5, { { a, a + vec2(1, 0), a + vec2(0, 30) } });
    picture.Add(5, { { a + vec2(1, 0), a + vec2(1, 30), a + vec2(0, 30) } });
  }
  EXPECT_NEAR(picture.Nearest(0), std::hypot(0.3, 5), PlaceSlack);
}

TEST(NearestPlace, LooksBesideWhatIntersectsTheCell)
{
  // as large as the cell and nearer at one corner, farther at the next: they intersect from
  // the top to where the base of both is equally far, at 0.45 and 0.55 of its corners
  const std::array<vec2, 3> places{ { Centre + vec2(-6, 4), Centre + vec2(10, 4),
    Centre + vec2(2, -30) } };
  Picture picture;
  picture.Add(10, places);
  picture.Add(10, places);
  picture.Soup.Points[3] *= 0.9;
  picture.Soup.Points[4] *= 1.1;
  constexpr double OnBase = -6 + 0.55 * 16; // and 4 of 34 pixels up, towards 2
  EXPECT_NEAR(picture.Nearest(0), OnBase + (2 - OnBase) * 4 / 34, 0.01);
}

TEST(NearestPlace, FindsTheNearestBackground)
{
  Picture picture;
  picture.Add(10, { { Centre + vec2(0.5, 40), Centre + vec2(0.5, -40), Centre + vec2(-60, 0) } });
  EXPECT_NEAR(picture.Nearest(-1), 0.5, PlaceSlack);
}

// At a pole a row of pixels is one direction: what is a pixel aside there is near.
TEST(NearestPlace, IsAtHomeBesideThePole)
{
  const vec2 centre(300.5, 0.5);
  Picture picture;
  picture.Add(10, { { centre + vec2(2, 0), centre + vec2(2, 30), centre + vec2(20, 30) } });
  const RayCaster caster(picture.Soup, WholeSphere());
  EXPECT_NEAR(NearestPlace(caster, Width, Height, centre, 0, SearchLimit), 2, 0.02);
}

// What the 48 points step over is unexplained all the same, and its distance is known.
TEST(NearestPlace, LeavesTheFortyEightPointsAlone)
{
  Picture scene;
  scene.AddNeedle(10, 0.3, 0.01);
  const RayCaster caster(scene.Soup, WholeSphere());
  const HitPicture reference = caster.Render(Width, Height);
  DrawnPicture drawn;
  drawn.Width = Width;
  drawn.Height = Height;
  drawn.Cell.assign(std::size_t(Width) * Height, 0);
  drawn.Distance.assign(drawn.Cell.size(), std::numeric_limits<float>::infinity());
  const std::size_t n = std::size_t(Centre.y) * Width + std::size_t(Centre.x);
  ASSERT_EQ(reference.Hits[n].Cell, -1);
  drawn.Cell[n] = 1;
  const Metrics m = Compare(drawn, caster, reference, 1);
  EXPECT_EQ(m.UnexplainedPixels, 1);
  EXPECT_NEAR(m.MaxPx, 0.3, PlaceSlack);
}

TEST(NearestFace, LooksBehindWhatHidesTheCell)
{
  Picture picture;
  picture.AddNeedle(10, 0.3, 0.01);
  picture.Add(5, { { Centre + vec2(-90, 60), Centre + vec2(90, 60), Centre + vec2(0, -90) } });
  EXPECT_NEAR(picture.NearestAtAll(0), 0.3, PlaceSlack);
  EXPECT_EQ(picture.NearestAtAll(1), 0);
  EXPECT_EQ(picture.NearestAtAll(7), std::numeric_limits<double>::infinity()) << "no such cell";
}

TEST(NearestFace, IsThatOfItsEdgesWhereItIsEdgeOn)
{
  for (const double stretched : { 2.0, 1.0 }) // without area, where both corners are one
  {
    Picture picture;
    picture.AddNeedle(10, 0.3, 0);
    picture.Soup.Points[1] *= stretched;
    EXPECT_EQ(picture.Nearest(0), std::numeric_limits<double>::infinity());
    EXPECT_NEAR(picture.NearestAtAll(0), 0.3, PlaceSlack);
  }
}

TEST(NearestFace, FollowsEdgesThatBend)
{
  // along the great circle ahead, whose place above the equator is known a quarter of the way round
  Picture picture;
  picture.Soup.Points = { vec3(-1, 0, -1), vec3(1, 0.5, -1), vec3(3, 0, -3) };
  picture.Soup.Triangles = { { { 0, 1, 2 } } };
  picture.Soup.CellIds = { 0 };
  const vec3 middle = glm::normalize(vec3(0, 0.25, -1));
  const vec3 ndc = WholeSphere().Forward(middle).Ndc;
  const vec2 place(0.5 * (ndc.x + 1) * Width, 0.5 * (1 - ndc.y) * Height);
  const RayCaster caster(picture.Soup, WholeSphere());
  EXPECT_LE(NearestFace(caster, Width, Height, place, 0, SearchLimit), PlaceSlack);
  EXPECT_GT(NearestFace(caster, Width, Height, place - vec2(0, 3), 0, SearchLimit), 1);
}

TEST(NearestFace, IsInfiniteBeyondTheClipSpheres)
{
  Picture picture;
  picture.AddNeedle(1000, 0.3, 0.01);
  EXPECT_EQ(picture.NearestAtAll(0), std::numeric_limits<double>::infinity());
}
