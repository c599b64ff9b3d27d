// SPDX-License-Identifier: BSD-3-Clause
// Meshes that the technique `auto` draws in several ways side by side: some triangles projected as
// they are, some cut before, some ray-tested. Closed ones round the eye: no pixel of the domain is
// background, and what is seen is what `auto` promises.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Poses.h"
#include "Promise.h"
#include "Stereo/Stereo.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVPolyDataMapper.h"
#include "vtkWideFoVRenderer.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <vector>
#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels: the default, and one at which triangles of many pixels are projected.
const double Tolerances[] = { 0.25, 1 };

struct NamedMesh
{
  const char* Name;
  vtkSmartPointer<vtkPolyData> Mesh;
};

// widening: of the tube.
std::vector<NamedMesh> MakeMeshes(double widening = 1)
{
  Placement tube;
  tube.Scale = widening;
  return { { "fine sphere", MakeGlobe(64) }, { "sphere", MakeGlobe(24) }, { "room", MakeRoom(40) },
    { "tube", MakeTube(400, tube) }, { "hills", MakeHills(96) } };
}

// Rays that begin 0.1 from a place 0.33 from the tube's axis leave it, with a radius of 0.4,
// through its wall: from there the ray caster sees the background too. So for them it is 0.5.
constexpr double FarEyes = 0.2; // scene units
constexpr double WideTube = 1.25;

// From the middle, where rows of cells meet poles and seams, from off it, and from beside the mesh,
// where triangles are of all sizes.
std::vector<NamedPose> MixedPoses()
{
  std::vector<NamedPose> poses = PlainPoses();
  NamedPose aside;
  aside.Eye = vec3(0.31, 0.05, -0.12);
  poses.push_back(Turned(aside, 101.9, 12.7, "beside it, turned"));
  return poses;
}

void CheckClosed(const Drawing& drawing, const Shot& shot, const reference::DrawnPicture& picture,
  const std::string& scene)
{
  const HoleCount count = CountHoles(picture, drawing.GetView());
  EXPECT_EQ(count.Holes, 0) << scene << "\n  " << Describe(shot) << "\n" << count.First;
  EXPECT_EQ(count.Outside, 0) << scene << "\n  " << Describe(shot) << "\n" << count.First;
}
}

class Mixed : public DrawingTest
{
protected:
  void SetUp() override { Picture->SetTechnique(vtkWideFoVPass::AUTO); }
  void TearDown() override { Picture->SetTolerance(0.25); }

  // calls(shot, name): of every mesh from every pose at every tolerance.
  template <typename Calls>
  void InAllShots(double fov, const Calls& calls, double widening = 1)
  {
    for (const NamedMesh& mesh : MakeMeshes(widening))
    {
      Picture->SetMesh(mesh.Mesh);
      for (const NamedPose& pose : MixedPoses())
      {
        for (const double tolerance : Tolerances)
        {
          Picture->SetTolerance(tolerance);
          const Shot shot = MakeShot(this->GetParam(), fov, pose);
          calls(shot, tolerance,
            std::string(mesh.Name) + ", " + pose.Name + ", " + std::to_string(tolerance));
        }
      }
    }
  }

  bool IsPlanar() const { return FindProjection(this->GetParam())->Axis == Family::Planar; }
};

TEST_P(Mixed, IsClosedAndAsPromised)
{
  int mixed = 0;
  const double fov = WidestDrawn(*FindProjection(this->GetParam()));
  this->InAllShots(fov, [&](const Shot& shot, double tolerance, const std::string& scene) {
    const reference::DrawnPicture picture = Picture->Draw(shot);
    mixed += Picture->WasMixed();
    CheckClosed(*Picture, shot, picture, scene);
    ExpectPromise(*Picture, shot, picture, tolerance, scene);
  });
  EXPECT_TRUE(mixed > 10 || this->IsPlanar()) << mixed << " pictures had several kinds";
}

// As near to the rim, the poles and the seam as a narrow view shows them.
TEST_P(Mixed, IsClosedInNarrowViews)
{
  const Projection& p = *FindProjection(this->GetParam());
  const double fov = std::max(60.0, p.MinHorizontalFov);
  this->InAllShots(fov, [&](const Shot& shot, double tolerance, const std::string& scene) {
    (void)tolerance;
    CheckClosed(*Picture, shot, Picture->Draw(shot), scene);
  });
}

// The same for an eye whose rays begin on a circle; of a cylinder's map and of a curved seam's
// small and large beside the mesh as well, which takes three times as long.
TEST_P(Mixed, IsClosedForAnEye)
{
  if (this->IsPlanar())
  {
    GTEST_SKIP() << "omnidirectional is for wide projections";
  }
  int mixed = 0;
  const bool all = this->GetParam() == "equirectangular" || this->GetParam() == "hammer";
  const std::vector<double> distances{ 0.02, 0.004, FarEyes };
  for (const double distance : all ? distances : std::vector<double>{ 0.02 })
  {
    const double fov = FindProjection(this->GetParam())->MaxHorizontalFov;
    const auto check = [&](Shot shot, double tolerance, const std::string& scene) {
      shot.Options.Stereo.Model = FindStereoModel("omnidirectional");
      shot.Options.Stereo.Eye = Eye::Left;
      shot.Options.Stereo.InterpupillaryDistance = distance;
      const reference::DrawnPicture picture = Picture->Draw(shot);
      const std::string name = scene + ", eyes apart " + std::to_string(distance);
      mixed += Picture->WasMixed();
      CheckClosed(*Picture, shot, picture, name);
      if (tolerance < 1)
      {
        ExpectPromise(*Picture, shot, picture, tolerance, name);
      }
    };
    this->InAllShots(fov, check, distance < FarEyes ? 1 : WideTube);
  }
  EXPECT_GT(mixed, 3);
}

// What was drawn before in another way leaves nothing behind.
TEST_P(Mixed, ForgetsHowItWasDrawnBefore)
{
  const double fov = WidestDrawn(*FindProjection(this->GetParam()));
  const Shot shot = MakeShot(this->GetParam(), 0.5 * fov, MixedPoses().back());
  Drawing fresh;
  fresh.SetTechnique(vtkWideFoVPass::AUTO);
  for (const NamedMesh& mesh : MakeMeshes())
  {
    Picture->SetMesh(mesh.Mesh);
    fresh.SetMesh(mesh.Mesh);
    Picture->SetTolerance(1);
    Picture->Draw(shot);
    Picture->SetTolerance(0.01);
    fresh.SetTolerance(0.01);
    const reference::DrawnPicture again = Picture->Draw(shot);
    EXPECT_FALSE(Picture->WasMixed());
    const reference::DrawnPicture first = fresh.Draw(shot);
    EXPECT_EQ(again.Cell, first.Cell) << mesh.Name << "\n  " << Describe(shot);
    EXPECT_EQ(again.Distance, first.Distance) << mesh.Name << "\n  " << Describe(shot);
  }
}

namespace
{
// White meshes without light, of several samples a pixel.
class Bright
{
public:
  Bright()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(8);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetActiveCamera(this->Camera);
    this->Renderer->SetPass(this->Pass);
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(this->Actor);
  }

  // Pixels of the domain that are not all white, but for those at its border.
  long CountDark(vtkPolyData* mesh, const Shot& shot, double tolerance)
  {
    this->Mapper->SetInputData(mesh);
    this->Pass->SetTolerance(tolerance);
    this->Window->SetSize(shot.Width, shot.Height);
    PlaceCamera(this->Camera, shot);
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, shot.Width - 1, shot.Height - 1, 0, pixels);
    const View view(this->Camera->GetView(double(shot.Width) / shot.Height));
    long dark = 0;
    for (int k = 0; k < shot.Width * shot.Height; ++k)
    {
      bool inside = false;
      const int row = shot.Height - 1 - k / shot.Width;
      if (reference::IsClear(view, k % shot.Width, row, shot.Width, shot.Height, 1, inside) &&
        inside)
      {
        dark += pixels->GetValue(3 * k) != 255;
      }
    }
    return dark;
  }

private:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVCamera> Camera;
  vtkNew<vtkWideFoVPass> Pass;
  vtkNew<vtkWideFoVPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
};
}

// No background shines through where two ways of drawing meet.
TEST_P(Mixed, IsClosedAtEverySample)
{
  Bright bright;
  const double fov = WidestDrawn(*FindProjection(this->GetParam()));
  this->InAllShots(fov, [&](const Shot& shot, double tolerance, const std::string& scene) {
    EXPECT_EQ(bright.CountDark(Picture->GetMesh(), shot, tolerance), 0)
      << scene << "\n  " << Describe(shot);
  });
  // the check can tell: without a cell that is seen
  const Shot shot = MakeShot(this->GetParam(), fov, PlainPoses().front());
  vtkNew<vtkPolyData> open;
  open->DeepCopy(MakeGlobe(24));
  Picture->SetMesh(open);
  const reference::DrawnPicture whole = Picture->Draw(shot);
  const std::size_t seen = std::size_t(shot.Width) * (shot.Height / 3) + shot.Width / 3;
  open->GetPolys()->ReplaceCellAtId(static_cast<vtkIdType>(whole.Cell[seen]) - 1, { 0, 0, 0 });
  open->Modified();
  EXPECT_GT(bright.CountDark(open, shot, 0.25), 0);
}

INSTANTIATE_TEST_SUITE_P(All, Mixed, ::testing::ValuesIn(ProjectionNames()), DrawingTest::NameOf);
