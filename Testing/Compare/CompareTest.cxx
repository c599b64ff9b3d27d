// SPDX-License-Identifier: BSD-3-Clause
// `cell` and `distance` of the pre-clip on finely tessellated scenes, against the ray
// caster: nothing seen from farther away than a pixel.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Poses.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels: what the contract asks of the pre-clip where no edge exceeds one degree.
constexpr double FineMeshTolerance = 1;

// Relative. Attributes, and with them the distance, are interpolated along chords: an edge
// of one degree seen at an angle t from the perpendicular errs by at most
// (1 + 2 tan^2 t) (1 degree)^2 / 8, which is 4e-5 face on, where the globe is seen, 2e-4 in
// the corners of the room, and 2e-3 where a wall is seen from its own surface, at 81 degrees.
constexpr double GlobeDepth = 5e-5;
constexpr double RoomDepth = 2e-4;
constexpr double WallDepth = 2e-3;

// Pixels: the pass's own tolerance. A chord so far beside its edge shows the surface from
// so far aside, and where the surface runs away from the eye its distance differs by the
// tangent of that slope; the eye is 0.09 off the middle of the globe at the most, and a
// wall of the room is seen under 55 degrees in its corners.
constexpr double ChordTolerance = 0.25;
constexpr double GlobeSlope = 0.09;
constexpr double RoomSlope = 1.5;

double AllowedDepth(const Shot& shot, double chords)
{
  const double pixel = WFV_PI / 180 * shot.Options.HorizontalFov / shot.Width;
  const double slope = chords == GlobeDepth ? GlobeSlope : RoomSlope;
  return chords + ChordTolerance * pixel * slope;
}

// Cells a right angle: edges stay under one degree from the poses off the middle too.
constexpr int GlobeCells = 160;
constexpr int RoomCells = 160;

const std::vector<double> Fovs{ 60, 120, 180, 270, 360 };

// The widest field of view whose pixels are hardly wider than the cells, so that the points
// round a pixel tell them apart: maps that reach infinity squeeze their middle, those that
// are flat at the antipode or the rim the cells there.
double WidestFov(const Projection& p)
{
  constexpr double Reasonable = 240;
  const bool squeezes = p.MaxHorizontalFov < 360 || p.Name == "azimuthal-equal-area";
  return squeezes ? std::min(WidestDrawn(p), Reasonable) : WidestDrawn(p);
}

// Pixels that none of the 48 points of the tolerance explains, nor those of a finer one down to
// a 64th of it: what is explained within a smaller tolerance is so within this.
long UnexplainedAtAnyFiner(
  const reference::Caster& caster, const Shot& shot, const reference::Metrics& m)
{
  return std::count_if(m.Worst.begin(), m.Worst.end(), [&](const reference::WorstPixel& pixel) {
    return !std::isfinite(
      reference::NearestAgreement(caster, shot.Width, shot.Height, pixel, FineMeshTolerance));
  });
}

// Asserts one shot and prints its row.
void Check(Drawing& drawing, const Shot& shot, const std::string& scene, double depthTolerance)
{
  const reference::DrawnPicture picture = drawing.Draw(shot);
  ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
  const reference::RayCaster caster(drawing.GetMesh(), drawing.GetView(), drawing.GetPose());
  const reference::Metrics m = reference::Compare(picture, caster, FineMeshTolerance);
  std::cout << Row(shot, scene, m) << std::endl;
  ASSERT_LE(m.UnexplainedPixels, long(reference::Metrics::MaxWorst));
  EXPECT_EQ(UnexplainedAtAnyFiner(caster, shot, m), 0) << scene << "\n  " << Describe(shot) << "\n"
                                                       << Details(shot, drawing.GetView(), m);
  EXPECT_LE(m.MaxPx, FineMeshTolerance) << scene << "\n  " << Describe(shot) << "\n"
                                        << Details(shot, drawing.GetView(), m);
  EXPECT_LE(m.MaxDepthRel, AllowedDepth(shot, depthTolerance)) << scene << "\n  " << Describe(shot);
}
}

class CompareFine : public DrawingTest
{
protected:
  void CheckAll(const std::vector<NamedPose>& poses, const std::string& mesh, double depth)
  {
    const Projection& p = *FindProjection(this->GetParam());
    std::vector<double> fovs = FovsOf(p, Fovs);
    if (fovs.size() <= 1)
    {
      fovs.assign(1, WidestFov(p));
    }
    for (const double fov : fovs)
    {
      for (const NamedPose& pose : poses)
      {
        Check(*Picture, MakeShot(p.Name, fov, pose), mesh + ", " + pose.Name, depth);
      }
    }
  }

  // At the largest field of view only.
  void CheckWidest(const std::vector<NamedPose>& poses, const std::string& mesh, double depth)
  {
    const Projection& p = *FindProjection(this->GetParam());
    const double fov = WidestFov(p);
    for (const NamedPose& pose : poses)
    {
      Check(*Picture, MakeShot(p.Name, fov, pose), mesh + ", " + pose.Name, depth);
    }
  }
};

TEST_P(CompareFine, Globe)
{
  Picture->SetMesh(MakeGlobe(GlobeCells));
  this->CheckAll(PlainPoses(), "globe", GlobeDepth);
}

TEST_P(CompareFine, GlobeSwept)
{
  const Projection& p = *FindProjection(this->GetParam());
  const std::vector<NamedPose> poses = SweptPoses(GlobeCells);
  Picture->SetMesh(MakeGlobe(GlobeCells));
  // at vertices exactly, and for their families' first ones beside them too
  const bool all = FovsOf(p, Fovs).size() > 1;
  this->CheckWidest({ poses.begin(), all ? poses.end() : poses.begin() + 3 }, "globe", GlobeDepth);
}

TEST_P(CompareFine, Room)
{
  Picture->SetMesh(MakeRoom(RoomCells));
  this->CheckAll(PlainPoses(), "room", RoomDepth);
}

TEST_P(CompareFine, RoomFromItsWall)
{
  Picture->SetMesh(MakeRoom(RoomCells));
  this->CheckWidest(WallPoses(RoomCells), "room", WallDepth);
}

// The poses are what the contract speaks of: no edge of a degree or more.
TEST(CompareMeshes, EdgesAreUnderOneDegree)
{
  constexpr double Near = 0.02;
  for (const NamedPose& pose : PlainPoses())
  {
    reference::Pose toEye = reference::IdentityPose();
    toEye[3] = -pose.Eye.x;
    toEye[7] = -pose.Eye.y;
    toEye[11] = -pose.Eye.z;
    for (const auto& mesh : { MakeGlobe(GlobeCells), MakeRoom(RoomCells) })
    {
      const double longest = LongestEdge(reference::Triangulate(mesh, toEye), Near);
      EXPECT_LT(longest, 1) << pose.Name;
      EXPECT_GT(longest, 0.5) << pose.Name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, CompareFine, ::testing::ValuesIn(ProjectionNames()), DrawingTest::NameOf);
