// SPDX-License-Identifier: BSD-3-Clause
// Props that both eyes see alike, among one that they do not, against the ray caster of each eye.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Poses.h"
#include "Stereo.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels: as near as what is drawn for each eye.
constexpr double FarTolerance = 0.02;

// Relative: what the eyes' circle adds to a distance, half its share of it squared, is nothing.
constexpr double FarDepthTolerance = 1e-5;

// Triangles with outlines of their own: balls, one before the other.
vtkSmartPointer<vtkPolyData> MakeBalls(const std::vector<Placement>& places)
{
  vtkNew<vtkAppendPolyData> balls;
  for (const Placement& place : places)
  {
    balls->AddInputData(MakeGlobe(24, place));
  }
  balls->Update();
  return balls->GetOutput();
}

// One near, two far; no farther than depths of 24 bits tell front and back of the near one apart.
std::vector<vtkSmartPointer<vtkPolyData>> MakeProps()
{
  return { MakeBalls({ { { 0.9, -0.6, -3 }, 0.8 } }),
    MakeBalls({ { { -40, 20, -400 }, 30 }, { { -70, 30, -500 }, 50 }, { { 50, 10, -450 }, 60 } }),
    MakeBalls({ { { 20, -50, -600 }, 70 }, { { -90, -30, -550 }, 40 } }) };
}
}

class CompareFar : public DrawingTest
{
protected:
  void SetUp() override
  {
    this->Props = MakeProps();
    vtkNew<vtkAppendPolyData> all;
    vtkIdType cells = 0;
    int index = 0;
    for (const auto& mesh : this->Props)
    {
      all->AddInputData(mesh);
      this->FirstCells.push_back(cells);
      cells += mesh->GetNumberOfCells();
      vtkNew<vtkWideFoVPolyDataMapper> mapper;
      mapper->SetInputData(mesh);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      index == 0 ? Picture->SetActor(actor) : Picture->AddActor(actor, index);
      index++;
    }
    all->Update();
    this->All = all->GetOutput();
    Picture->SetPassTechnique(vtkWideFoVPass::AUTO);
  }

  reference::DrawnPicture Draw(const Shot& shot) const
  {
    Picture->Draw(shot);
    return reference::ToDrawnPicture(Picture->GetData(), this->FirstCells);
  }

  std::vector<vtkSmartPointer<vtkPolyData>> Props;
  std::vector<vtkIdType> FirstCells;
  vtkSmartPointer<vtkPolyData> All;
};

// With eyes as far apart as what is far lets them be, which is the largest parallax.
TEST_P(CompareFar, ShowsWhatEachEyeSees)
{
  const Projection& p = *FindProjection(this->GetParam());
  NamedPose pose;
  Shot shot = MakeShot(p.Name, p.MaxHorizontalFov, pose);
  shot.Options.Radii = { { 0.5, 800 } };
  StereoOptions& stereo = shot.Options.Stereo;
  stereo.Model = FindStereoModel("omnidirectional");
  stereo.Eye = Eye::Left;
  double& apart = stereo.InterpupillaryDistance;
  const auto countFar = [&] {
    this->Draw(shot);
    return Picture->GetNumberOfFarProps();
  };
  for (apart = 0.5; countFar() < 2;)
  {
    apart /= 1.1;
    ASSERT_GT(apart, 1e-5) << "nothing is ever far";
  }
  for (const Eye eye : { Eye::Left, Eye::Right })
  {
    stereo.Eye = eye;
    const reference::DrawnPicture picture = this->Draw(shot);
    EXPECT_EQ(Picture->GetNumberOfFarProps(), 2);
    const reference::RayCaster caster(this->All, Picture->GetView(), Picture->GetPose());
    const reference::Metrics m = reference::Compare(picture, caster, FarTolerance);
    std::cout << Row(shot, "eyes apart " + std::to_string(apart), m) << std::endl;
    EXPECT_EQ(m.UnexplainedPixels, 0) << Describe(shot) << "\n"
                                      << Details(shot, Picture->GetView(), m);
    // where a surface runs away from the eye, a distance is as right as the place
    EXPECT_TRUE(m.MaxDepthRel <= FarDepthTolerance || m.DepthPx <= FarTolerance)
      << m.MaxDepthRel << ", " << m.DepthPx << " px\n  " << Describe(shot);
  }
}

INSTANTIATE_TEST_SUITE_P(All, CompareFar, ::testing::ValuesIn(WideNames()), DrawingTest::NameOf);
