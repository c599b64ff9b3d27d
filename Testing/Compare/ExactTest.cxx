// SPDX-License-Identifier: BSD-3-Clause
// The technique `exact` against the ray caster, from meshes of a dozen triangles to fine
// ones: nothing unexplained at b = 0.02 pixels, and the same of `auto` at that tolerance.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Poses.h"
#include "vtkWideFoVPass.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels: float32 in the shaders, double in the ray caster.
constexpr double ExactTolerance = 0.02;

// Relative error of the distance along the pixel's ray.
constexpr double ExactDepthTolerance = 1e-5;

const std::vector<double> ExactFovs{ 60, 180, 270, 360 };
}

class CompareExact : public DrawingTest
{
protected:
  void SetUp() override
  {
    Picture->SetTechnique(vtkWideFoVPass::EXACT);
    Picture->SetTolerance(ExactTolerance);
  }

  // Asserts one shot and prints its row.
  static void Check(const Shot& shot, const std::string& scene)
  {
    const reference::DrawnPicture picture = Picture->Draw(shot);
    ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
    const reference::RayCaster caster(Picture->GetMesh(), Picture->GetView(), Picture->GetPose());
    const reference::Metrics m = reference::Compare(picture, caster, ExactTolerance);
    std::cout << Row(shot, scene, m) << std::endl;
    EXPECT_EQ(m.UnexplainedPixels, 0) << scene << "\n  " << Describe(shot) << "\n"
                                      << Details(shot, Picture->GetView(), m);
    EXPECT_LE(m.MaxDepthRel, ExactDepthTolerance) << scene << "\n  " << Describe(shot);
  }

  void CheckAll(const std::vector<NamedPose>& poses, const std::string& mesh)
  {
    const Projection& p = *FindProjection(this->GetParam());
    for (double fov : FovsOf(p, ExactFovs))
    {
      for (const NamedPose& pose : poses)
      {
        Check(MakeShot(p.Name, fov, pose), mesh + ", " + pose.Name);
      }
    }
  }

  double Widest() const
  {
    return std::min(
      360.0, std::floor(FindProjection(this->GetParam())->MaxHorizontalFov / 60) * 60);
  }

  // At the largest field of view only.
  void CheckWidest(const std::vector<NamedPose>& poses, const std::string& mesh)
  {
    for (const NamedPose& pose : poses)
    {
      Check(MakeShot(this->GetParam(), this->Widest(), pose), mesh + ", " + pose.Name);
    }
  }

  // The density of a picture 8192 wide all round: a strip along the equator, which meets
  // the seam, and one from pole to pole; for round maps a large square.
  void CheckLarge(const std::string& mesh)
  {
    constexpr int Density = 8192;
    constexpr int Strip = 256;
    const Projection& p = *FindProjection(this->GetParam());
    const bool round = p.Axis == Family::Azimuthal || p.Axis == Family::Faces;
    for (const NamedPose& pose : PlainPoses())
    {
      Shot shot = MakeShot(this->GetParam(), this->Widest(), pose);
      const double degrees = 360.0 / Density;
      shot.Width = round ? 2048 : int(shot.Options.HorizontalFov / degrees);
      shot.Height = round ? 2048 : Strip;
      shot.Options.VerticalFov = round ? shot.Options.VerticalFov : degrees * Strip;
      Check(shot, mesh + ", along the equator, " + pose.Name);
      if (!round)
      {
        shot.Options.HorizontalFov = degrees * Strip;
        shot.Options.VerticalFov = std::min({ 180.0, this->Widest(), p.MaxVerticalFov });
        shot.Width = Strip;
        shot.Height = int(shot.Options.VerticalFov / degrees);
        Check(shot, mesh + ", from pole to pole, " + pose.Name);
      }
    }
  }
};

TEST_P(CompareExact, RoomOfTwelve)
{
  Picture->SetMesh(MakeRoom(1));
  this->CheckAll(PlainPoses(), "room of 12");
  this->CheckWidest(WallPoses(2), "room of 12");
}

TEST_P(CompareExact, GlobeOfEight)
{
  Picture->SetMesh(MakeGlobe(1));
  this->CheckAll(PlainPoses(), "globe of 8");
}

TEST_P(CompareExact, Large)
{
  Picture->SetMesh(MakeRoom(1));
  this->CheckLarge("room of 12");
  Picture->SetMesh(MakeGlobe(40));
  this->CheckLarge("globe of 40");
}

TEST_P(CompareExact, GlobeSwept)
{
  Picture->SetMesh(MakeGlobe(20));
  this->CheckWidest(SweptPoses(20), "globe of 20");
}

TEST_P(CompareExact, FineGlobe)
{
  Picture->SetMesh(MakeGlobe(160));
  this->CheckWidest(SweptPoses(160), "globe of 160");
}

TEST_P(CompareExact, FineRoomFromItsWall)
{
  Picture->SetMesh(MakeRoom(160));
  this->CheckWidest(WallPoses(160), "room of 160");
}

TEST_P(CompareExact, Auto)
{
  Picture->SetTechnique(vtkWideFoVPass::AUTO);
  Picture->SetMesh(MakeRoom(1));
  this->CheckAll(PlainPoses(), "room of 12, auto");
  Picture->SetMesh(MakeGlobe(160));
  this->CheckWidest(SweptPoses(160), "globe of 160, auto");
}

INSTANTIATE_TEST_SUITE_P(
  All, CompareExact, ::testing::ValuesIn(ProjectionNames()), DrawingTest::NameOf);
