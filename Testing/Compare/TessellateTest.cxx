// SPDX-License-Identifier: BSD-3-Clause
// The technique tessellate on coarse meshes against the ray caster: no pixel farther from
// the truth than the tolerance that was asked for.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Poses.h"
#include "vtkWideFoVPass.h"

#ifdef WIDEFOV_SCENES
#include "Scenes/Scenes.h"
#endif

#include <vtkPolyData.h>

#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
const double ChordTolerances[] = { 0.05, 0.25, 1 }; // pixels

struct Mesh
{
  const char* Name;
  vtkSmartPointer<vtkPolyData> Data;
};

std::vector<Mesh> CoarseMeshes()
{
  return { { "room of 12", MakeRoom(1) }, { "room of 16 cells a side", MakeRoom(16) },
    { "globe of 32", MakeGlobe(2) } };
}

void CheckShot(Drawing& drawing, Shot shot, const std::string& scene, double tolerance)
{
  drawing.SetTolerance(tolerance);
  const reference::DrawnPicture picture = drawing.Draw(shot);
  ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
  EXPECT_EQ(drawing.GetNumberOfTessellateDraws(), 1);
  const reference::RayCaster caster(drawing.GetMesh(), drawing.GetView(), drawing.GetPose());
  const reference::Metrics m = reference::Compare(picture, caster, tolerance);
  char text[40];
  std::snprintf(text, sizeof text, ", t %g", tolerance);
  std::cout << Row(shot, scene + text, m) << std::endl;
  EXPECT_LE(m.MaxPx, tolerance) << scene << text << "\n  " << Describe(shot) << "\n"
                                << Details(shot, drawing.GetView(), m);
}
}

class Tessellate : public DrawingTest
{
protected:
  void SetUp() override
  {
    if (FindProjection(this->GetParam())->Axis == Family::Planar)
    {
      GTEST_SKIP() << "the stock mapper draws it";
    }
    Picture->SetTechnique(vtkWideFoVPass::TESSELLATE);
  }
};

TEST_P(Tessellate, KeepsTheTolerance)
{
  for (const Mesh& mesh : CoarseMeshes())
  {
    Picture->SetMesh(mesh.Data);
    for (const NamedPose& pose : PlainPoses())
    {
      for (double tolerance : ChordTolerances)
      {
        const double fov = FindProjection(this->GetParam())->MaxHorizontalFov;
        Shot shot = MakeShot(this->GetParam(), fov, pose);
        CheckShot(*Picture, shot, std::string(mesh.Name) + ", " + pose.Name, tolerance);
      }
    }
  }
}

TEST_P(Tessellate, KeepsTheToleranceInALargePicture)
{
  Picture->SetMesh(MakeRoom(1));
  for (double tolerance : { 0.25, 1.0 })
  {
    Shot shot = MakeShot(this->GetParam(), 360, PlainPoses()[1]);
    shot.Width *= 4;
    shot.Height *= 4;
    CheckShot(*Picture, shot, "room of 12", tolerance);
  }
}

#ifdef WIDEFOV_SCENES
TEST_P(Tessellate, KeepsTheToleranceInACornellBox)
{
  const widefov::Scene scene = widefov::MakeScene("cornell");
  ASSERT_EQ(scene.Props.size(), 1u);
  Picture->SetMesh(scene.Props[0].Surface);
  const widefov::Vector3 eye = widefov::SceneEye(scene);
  for (double tolerance : ChordTolerances)
  {
    Shot shot = MakeShot(this->GetParam(), 360, PlainPoses()[1]);
    shot.Eye = vec3(eye[0], eye[1], eye[2]);
    shot.Options.Radii = { { 0.01, scene.Props[0].Surface->GetLength() } };
    CheckShot(*Picture, shot, "cornell", tolerance);
  }
}
#endif

// The check can tell: chords at a tolerance of 1 pixel do not keep 0.05.
TEST_P(Tessellate, CoarserIsNotFiner)
{
  Picture->SetTechnique(vtkWideFoVPass::PRECLIP);
  Picture->SetMesh(MakeGlobe(20));
  Picture->SetTolerance(1);
  const Shot shot = MakeShot(this->GetParam(), 360, PlainPoses()[1]);
  const reference::DrawnPicture picture = Picture->Draw(shot);
  const reference::RayCaster caster(Picture->GetMesh(), Picture->GetView(), Picture->GetPose());
  EXPECT_GT(reference::Compare(picture, caster, 0.05).MaxPx, 0.1);
}

INSTANTIATE_TEST_SUITE_P(
  All, Tessellate, ::testing::ValuesIn(ProjectionNames()), DrawingTest::NameOf);
