// SPDX-License-Identifier: BSD-3-Clause
// What a view leaves out is not in its picture: the same to the bit with everything drawn.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Stereo.h"
#include "vtkWideFoVPass.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkStripper.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWideFoVCamera.h>
#include <vtkWideFoVPolyDataMapper.h>
#include <vtkWideFoVRenderer.h>

#include <cstring>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int Width = 192;
constexpr int Height = 96;
constexpr int Props = 40;
constexpr int Shots = 3; // a projection and technique

vtkSmartPointer<vtkPolyData> InStrips(vtkPolyData* mesh)
{
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(mesh);
  stripper->Update();
  return stripper->GetOutput();
}

// Meshes of several sizes, some of them near, and one round the eye that is cut in runs.
class Crowd
{
public:
  explicit Crowd(int samples)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(samples);
    this->Window->SetSize(Width, Height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetActiveCamera(this->Camera);
    this->Renderer->SetPass(this->Pass);
    this->Add(MakeRoom(40), vec3(0), 8, vec3(0.7, 0.7, 0.9));
    for (int i = 0; i < Props; ++i)
    {
      const vec3 at = 5.0 * vec3(this->Unit(), this->Unit(), this->Unit());
      const vec3 colour = 0.6 + 0.4 * vec3(this->Unit(), this->Unit(), this->Unit());
      // triangles of many pixels, and of a part of one, some of those in strips
      const auto globe = MakeGlobe(i % 4 ? 3 : 24);
      const auto mesh = i % 8 ? globe : InStrips(globe);
      this->Add(mesh, at, 0.1 + 0.3 * std::abs(this->Unit()), colour);
    }
  }

  double Unit() { return this->Distribution(this->Engine); }

  void Point(const Projection& p)
  {
    Shot shot;
    shot.Projection = p.Name;
    const double part = 0.15 + 0.85 * std::abs(this->Unit());
    shot.Options.HorizontalFov = std::max(p.MinHorizontalFov, part * p.MaxHorizontalFov);
    shot.Options.VerticalFov = std::max(p.MinVerticalFov, part * p.MaxVerticalFov);
    shot.Options.Tilt = 90 * this->Unit();
    shot.Options.Radii = { { 0.05 + 0.5 * std::abs(this->Unit()),
      6 + 6 * std::abs(this->Unit()) } };
    shot.Eye = 3.0 * vec3(this->Unit(), this->Unit(), this->Unit());
    shot.Direction = glm::normalize(vec3(this->Unit(), this->Unit(), this->Unit()));
    shot.Up = glm::normalize(vec3(this->Unit(), 1, this->Unit()));
    shot.Options.Stereo = this->Stereo; // placing the camera sets it
    this->Text = Describe(shot);
    PlaceCamera(this->Camera, shot);
  }

  // Both eyes in one picture.
  void SetStereo(const std::string& model)
  {
    this->Stereo.Model = FindStereoModel(model);
    this->Stereo.InterpupillaryDistance = 0.4;
    this->Window->SetStereoType(VTK_STEREO_RED_BLUE);
    this->Window->StereoRenderOn();
  }

  void SetStereoRender(bool both) { this->Window->SetStereoRender(both); }

  vtkSmartPointer<vtkUnsignedCharArray> Draw(bool culling)
  {
    this->Pass->SetCulling(culling);
    this->Window->Render();
    auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->Window->GetPixelData(0, 0, Width - 1, Height - 1, 0, pixels);
    return pixels;
  }

  vtkNew<vtkWideFoVPass> Pass;
  std::string Text;

private:
  void Add(vtkPolyData* mesh, const vec3& at, double scale, const vec3& colour)
  {
    vtkNew<vtkWideFoVPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(at.x, at.y, at.z);
    actor->SetScale(scale);
    actor->GetProperty()->SetColor(colour.x, colour.y, colour.z);
    this->Renderer->AddActor(actor);
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVCamera> Camera;
  StereoOptions Stereo;
  std::mt19937_64 Engine{ 17 };
  std::uniform_real_distribution<double> Distribution{ -1, 1 };
};
}

namespace
{
// What was left out of the pictures of these projections, all techniques.
struct LeftOut
{
  int Props = 0;
  int Clusters = 0;
};

LeftOut Compare(Crowd& crowd, const Projection& p, int shots = Shots)
{
  LeftOut left;
  for (const int technique : { vtkWideFoVPass::AUTO, vtkWideFoVPass::EXACT })
  {
    crowd.Pass->SetTechnique(technique);
    for (int i = 0; i < shots && p.Axis != Family::Planar; ++i)
    {
      crowd.Point(p);
      const auto whole = crowd.Draw(false);
      EXPECT_EQ(crowd.Pass->GetNumberOfCulledProps(), 0);
      EXPECT_EQ(crowd.Pass->GetNumberOfDrawnProps(), Props + 1);
      const auto culled = crowd.Draw(true);
      EXPECT_EQ(
        crowd.Pass->GetNumberOfCulledProps() + crowd.Pass->GetNumberOfDrawnProps(), Props + 1);
      left.Props += crowd.Pass->GetNumberOfCulledProps();
      left.Clusters += crowd.Pass->GetNumberOfCulledClusters();
      EXPECT_EQ(whole->GetNumberOfValues(), culled->GetNumberOfValues());
      EXPECT_EQ(std::memcmp(whole->GetPointer(0), culled->GetPointer(0),
                  static_cast<std::size_t>(whole->GetNumberOfValues())),
        0)
        << "technique " << technique << ", " << crowd.Text;
    }
  }
  return left;
}
}

TEST(Culling, ChangesNoPicture)
{
  Crowd crowd(0);
  LeftOut all;
  for (const Projection& p : Projections())
  {
    const LeftOut left = Compare(crowd, p);
    all.Props += left.Props;
    all.Clusters += left.Clusters;
  }
  std::cout << "props left out " << all.Props << ", clusters " << all.Clusters << std::endl;
  EXPECT_GT(all.Props, 100);
  EXPECT_GT(all.Clusters, 1000);
}

TEST(Culling, ChangesNoPictureOfTwoEyes)
{
  Crowd crowd(0);
  crowd.SetStereo("omnidirectional");
  LeftOut all;
  for (const char* name : { "equirectangular", "hammer", "azimuthal-equidistant", "mercator" })
  {
    const LeftOut left = Compare(crowd, *FindProjection(name));
    all.Props += left.Props;
    all.Clusters += left.Clusters;
  }
  std::cout << "props left out " << all.Props << ", clusters " << all.Clusters << "\n";
  EXPECT_GT(all.Props, 20);
  EXPECT_GT(all.Clusters, 50);
}

// A picture of curves takes its time.
TEST(Culling, ChangesNoPictureOfWarpedEyes)
{
  Crowd crowd(0);
  crowd.SetStereo("warped");
  const LeftOut left = Compare(crowd, *FindProjection("equirectangular"), 1);
  EXPECT_GT(left.Props + left.Clusters, 0);
}

// What is asked for one eye is known for the other; triangles are sorted for each, and neither is
// done again while nothing changes.
TEST(Culling, AsksOnceForBothEyes)
{
  Crowd crowd(0);
  for (const char* const model : { "omnidirectional", "warped" })
  {
    crowd.SetStereo(model);
    crowd.Pass->SetTechnique(vtkWideFoVPass::AUTO);
    const bool sorts = std::string(model) == "omnidirectional";
    for (int i = 0; i < (sorts ? Shots : 1); ++i)
    {
      crowd.Point(*FindProjection("equirectangular"));
      crowd.Draw(false); // all of them: what is drawn first prepares its mapper, which changes it
      crowd.Draw(true);
      EXPECT_EQ(crowd.Pass->GetNumberOfChosenProps(), 0) << "of the second eye, " << model;
      EXPECT_EQ(crowd.Pass->GetNumberOfSortedMeshes() > 0, sorts) << crowd.Text;
      crowd.Draw(true);
      EXPECT_EQ(crowd.Pass->GetNumberOfChosenProps(), 0) << model;
      EXPECT_EQ(crowd.Pass->GetNumberOfSortedMeshes(), 0) << model;
    }
    // the check can tell
    crowd.SetStereoRender(false);
    crowd.Draw(true);
    EXPECT_GT(crowd.Pass->GetNumberOfChosenProps(), 0);
  }
}

TEST(Culling, ChangesNoPictureOfManySamples)
{
  Crowd crowd(4);
  for (const char* name : { "equirectangular", "azimuthal-equidistant", "equi-angular-cubemap" })
  {
    Compare(crowd, *FindProjection(name));
  }
}
