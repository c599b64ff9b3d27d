// SPDX-License-Identifier: BSD-3-Clause
// Direction maps against the ray caster: seams, tears between faces, holes round a disc.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Poses.h"
#include "SampledShot.h"
#include "vtkWideFoVPass.h"

#include <vtkPolyData.h>

#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels, and relative error of the distance: as of the technique exact.
constexpr double SampledTolerance = 0.02;
constexpr double SampledDepthTolerance = 1e-5;
}

class CompareSampled : public DrawingTest
{
protected:
  void Check(const Shot& shot, const std::string& scene)
  {
    const reference::DrawnPicture picture = Picture->Draw(shot);
    ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
    const reference::RayCaster caster(Picture->GetMesh(), Picture->GetView(), Picture->GetPose());
    const reference::Metrics m = reference::Compare(picture, caster, SampledTolerance);
    std::cout << this->GetParam() << ": " << Row(shot, scene, m) << std::endl;
    EXPECT_EQ(m.UnexplainedPixels, 0) << scene << Details(shot, Picture->GetView(), m);
    EXPECT_LE(m.MaxDepthRel, SampledDepthTolerance) << scene;
  }
};

TEST_P(CompareSampled, RoomAndGlobe)
{
  Shot shot;
  shot.Width = 192;
  shot.Height = FindProjection(this->GetParam())->Axis == Family::Azimuthal ? 192 : 96;
  UseMapOf(this->GetParam(), shot);
  Picture->SetTechnique(vtkWideFoVPass::AUTO);
  Picture->SetTolerance(SampledTolerance);
  Picture->SetMesh(MakeRoom(1));
  for (const NamedPose& pose : PlainPoses())
  {
    shot.Eye = pose.Eye;
    shot.Direction = pose.Direction;
    shot.Up = pose.Up;
    this->Check(shot, "room of 12, " + pose.Name);
  }
  Picture->SetMesh(MakeGlobe(20));
  this->Check(shot, "globe of 20");
}

INSTANTIATE_TEST_SUITE_P(All, CompareSampled,
  ::testing::Values("equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap"),
  DrawingTest::NameOf);
