// SPDX-License-Identifier: BSD-3-Clause
// Views whose triangles are sorted in haste: the picture is that of sorting them one by one, and
// with chords, while the window asks for speed, it is within the tolerance and has no holes.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Poses.h"
#include "RayCaster.h"
#include "vtkWideFoVPass.h"

#include <vtkPolyData.h>

#include <algorithm>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr double Interactive = 15; // frames a second

// Pixels: under this every triangle is covered.
constexpr double AllCovered = 0.02;

// Pixels: how far a chord may be from its edge, and so what is shown.
constexpr double WithChords = 0.25;

// From the middle every triangle is small; from beside the surface some are as wide as the picture.
const vec3 Eyes[] = { vec3(0.02, -0.03, 0.01), vec3(0.55, -0.5, 0.6) };

Shot MakeShotFrom(const std::string& projection, const vec3& eye)
{
  const Projection& p = *FindProjection(projection);
  Shot shot = MakeShot(p.Name, FovsOf(p, { 120.0, 360.0 }).back(), PlainPoses().front());
  shot.Eye = eye;
  shot.Options.Radii = { { 1e-3, 4 } };
  return shot;
}

class Haste : public DrawingTest
{
protected:
  void SetUp() override
  {
    Picture->SetMesh(MakeGlobe(40));
    Picture->SetTechnique(vtkWideFoVPass::AUTO);
  }

  void TearDown() override
  {
    Picture->SetSortWhileMoving(true);
    Picture->SetUpdateRate(1e-4);
    Picture->SetTolerance(0.25);
  }
};
}

TEST_P(Haste, ShowsWhatSortingShows)
{
  Picture->SetTolerance(AllCovered);
  for (const vec3& eye : Eyes)
  {
    const Shot shot = MakeShotFrom(this->GetParam(), eye);
    Picture->SetSortWhileMoving(false);
    const reference::DrawnPicture hasty = Picture->Draw(shot);
    Picture->SetSortWhileMoving(true);
    const reference::DrawnPicture sorted = Picture->Draw(shot);
    EXPECT_GT(std::count_if(sorted.Cell.begin(), sorted.Cell.end(), [](auto c) { return c > 0; }),
      shot.Width * shot.Height / 4);
    EXPECT_EQ(hasty.Cell, sorted.Cell) << Describe(shot);
    EXPECT_EQ(hasty.Distance, sorted.Distance) << Describe(shot);
  }
}

TEST_P(Haste, ChordsLeaveNoHole)
{
  Picture->SetSortWhileMoving(false);
  Picture->SetUpdateRate(Interactive);
  for (const vec3& eye : Eyes)
  {
    const Shot shot = MakeShotFrom(this->GetParam(), eye);
    const reference::DrawnPicture drawn = Picture->Draw(shot);
    const HoleCount count = CountHoles(drawn, Picture->GetView());
    EXPECT_EQ(count.Holes + count.Outside, 0) << Describe(shot) << "\n" << count.First;
    const reference::RayCaster caster(Picture->GetMesh(), Picture->GetView(), Picture->GetPose());
    const reference::Metrics m = reference::Compare(drawn, caster, WithChords);
    EXPECT_LE(m.MaxPx, WithChords) << Details(shot, Picture->GetView(), m);
    const bool flat = this->GetParam() == "perspective";
    EXPECT_EQ(Picture->GetNumberOfPlainDraws() > 0, !flat) << "no chords: nothing was tested";
  }
}

INSTANTIATE_TEST_SUITE_P(All, Haste, ::testing::ValuesIn(ProjectionNames()), DrawingTest::NameOf);
