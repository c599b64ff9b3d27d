// SPDX-License-Identifier: BSD-3-Clause
#include "CullCrowd.h"

#include "Drawing.h"

#include <vtkActor.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace wfv
{
namespace test
{
LeftOut& LeftOut::operator+=(const LeftOut& other)
{
  this->Props += other.Props;
  this->Clusters += other.Clusters;
  return *this;
}

CullCrowd::CullCrowd(unsigned int seed, int width, int height, int samples)
  : Engine(seed)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(samples);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetActiveCamera(this->Camera);
  this->Renderer->SetPass(this->Pass);
}

double CullCrowd::Unit()
{
  return this->Distribution(this->Engine);
}

vec3 CullCrowd::Place()
{
  const double x = this->Unit();
  const double y = this->Unit();
  return vec3(x, y, this->Unit());
}

void CullCrowd::Point(const Projection& p)
{
  Shot shot;
  shot.Projection = p.Name;
  const double part = 0.15 + 0.85 * std::abs(this->Unit());
  shot.Options.HorizontalFov = std::max(p.MinHorizontalFov, part * p.MaxHorizontalFov);
  shot.Options.VerticalFov = std::max(p.MinVerticalFov, part * p.MaxVerticalFov);
  shot.Options.Tilt = 90 * this->Unit();
  const double nearest = 0.05 + 0.5 * std::abs(this->Unit());
  shot.Options.Radii = { { nearest, 5 + 7 * std::abs(this->Unit()) } };
  shot.Eye = 3.0 * this->Place();
  shot.Direction = glm::normalize(this->Place());
  shot.Up = glm::normalize(vec3(this->Unit(), 1, 0) + vec3(0, 0, this->Unit()));
  shot.Options.Stereo = this->Stereo; // placing the camera sets it
  this->Text = Describe(shot);
  PlaceCamera(this->Camera, shot);
}

void CullCrowd::SetStereo(const std::string& model)
{
  this->Stereo.Model = FindStereoModel(model);
  this->Stereo.InterpupillaryDistance = 0.4;
  this->Window->SetStereoType(VTK_STEREO_RED_BLUE);
  this->Window->StereoRenderOn();
}

vtkSmartPointer<vtkUnsignedCharArray> CullCrowd::Draw(bool culling)
{
  this->Pass->SetCulling(culling);
  this->Window->Render();
  const int* const size = this->Window->GetSize();
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  return pixels;
}

LeftOut CullCrowd::Compare(const Projection& p, int technique, int shots)
{
  LeftOut left;
  this->Pass->SetTechnique(technique);
  for (int i = 0; i < shots && p.Axis != Family::Planar; ++i)
  {
    this->Point(p);
    const auto whole = this->Draw(false);
    EXPECT_EQ(this->Pass->GetNumberOfCulledProps(), 0);
    EXPECT_EQ(this->Pass->GetNumberOfDrawnProps(), this->Props);
    const auto culled = this->Draw(true);
    EXPECT_EQ(
      this->Pass->GetNumberOfCulledProps() + this->Pass->GetNumberOfDrawnProps(), this->Props);
    left.Props += this->Pass->GetNumberOfCulledProps();
    left.Clusters += this->Pass->GetNumberOfCulledClusters();
    EXPECT_EQ(whole->GetNumberOfValues(), culled->GetNumberOfValues());
    EXPECT_EQ(std::memcmp(whole->GetPointer(0), culled->GetPointer(0),
                static_cast<std::size_t>(whole->GetNumberOfValues())),
      0)
      << "technique " << technique << ", " << this->Text;
  }
  return left;
}

void CullCrowd::Add(vtkActor* actor)
{
  this->Renderer->AddActor(actor);
  ++this->Props;
}
}
}
