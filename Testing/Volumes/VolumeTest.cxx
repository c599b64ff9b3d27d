// SPDX-License-Identifier: BSD-3-Clause
// Volumes against the march in double along the view's rays: every mode, inside and outside.
#include "VolumeCheck.h"

#include "Stereo/Stereo.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace wfv;
using namespace wfv::test;
using reference::Blend;

namespace
{
// The name of a mode in pictures and tables.
const char* NameOf(Blend mode)
{
  const char* const names[] = { "composite", "maximum", "minimum", "average", "additive",
    "isosurface", "slice" };
  return names[static_cast<int>(mode)];
}

void SetMode(VolumeScene& scene, Blend mode)
{
  scene.SetBlend(mode);
  const bool thin = mode == Blend::Additive;
  scene.SetFunctions(scene.March.Range[0], scene.March.Range[1], thin ? 0.05 : 0.2);
  if (mode == Blend::Isosurface)
  {
    scene.SetIsovalues({ 130, 200 });
  }
  if (mode == Blend::Slice)
  {
    scene.SetFunctions(scene.March.Range[0], scene.March.Range[1], 0.9);
    scene.SetCut({ vec3(1, 0, -2), vec3(0.3, 0.2, 1) });
  }
}
}

class Volumes : public testing::TestWithParam<const char*>
{
};

TEST_P(Volumes, EveryModeIsTheMarchInDouble)
{
  VolumeScene scene(Wavelet());
  scene.SetBall({ vec3(2, -1, 3), 2.5 });
  for (const Blend mode : { Blend::Composite, Blend::Maximum, Blend::Minimum, Blend::Average,
         Blend::Additive, Blend::Isosurface, Blend::Slice })
  {
    SetMode(scene, mode);
    for (bool inside : { false, true })
    {
      Check(scene, ShotOf(this->GetParam(), inside),
        std::string(NameOf(mode)) + (inside ? "-inside" : "-outside"));
    }
  }
}

TEST_P(Volumes, ShadedClippedAndCropped)
{
  for (bool inside : { false, true })
  {
    VolumeScene scene(Wavelet());
    const std::string where = inside ? "-inside" : "-outside";
    const Shot shot = ShotOf(this->GetParam(), inside);
    scene.SetFunctions(100, 260, 0.4);
    scene.SetBall({ vec3(2, -1, 3), 2.5 });
    scene.Shade();
    Check(scene, shot, "shaded" + where);
    scene.AddClip({ vec3(0, 0, 0.5), vec3(0.4, 0.1, -1) });
    scene.AddClip({ vec3(-4, 0, 0), vec3(1, 0.5, 0) });
    Check(scene, shot, "clipped" + where);
    scene.Crop({ { -7.3, 8.1, -4.2, 6.3, -9.4, 5.2 } });
    Check(scene, shot, "cropped" + where);
    scene.SetGradientOpacity();
    Check(scene, shot, "gradients" + where);
  }
}

// Air in an office, from the middle of the room: the flow of VTK's own data.
TEST_P(Volumes, MeasuredData)
{
  const vtkSmartPointer<vtkImageData> office = Office();
  if (!office)
  {
    GTEST_SKIP() << "no office.binary.vtk";
  }
  VolumeScene scene(office);
  const vec3 low = scene.March.Data.Origin;
  const vec3 high = scene.March.Data.GetHigh();
  scene.SetFunctions(scene.March.Range[0], scene.March.Range[1], 0.9);
  scene.SetBall({ 0.4 * low + 0.6 * high, 0.1 * (high.x - low.x) });
  for (bool inside : { false, true })
  {
    Shot shot = ShotOf(this->GetParam(), inside);
    shot.Eye = inside ? 0.55 * low + 0.45 * high : high + 0.8 * (high - low);
    shot.Direction = 0.5 * (low + high) - shot.Eye;
    scene.SetBlend(Blend::Composite);
    Check(scene, shot, inside ? "office-inside" : "office-outside");
    scene.SetBlend(Blend::Maximum);
    Check(scene, shot, inside ? "office-maximum-inside" : "office-maximum-outside");
  }
}

// Depth in other mappings, a tilt, tiles of the picture.
TEST_P(Volumes, EveryDepthMapping)
{
  VolumeScene scene(Wavelet());
  scene.SetBall({ vec3(2, -1, 3), 2.5 });
  for (const DepthMapping mapping : { DepthMapping::Logarithmic, DepthMapping::Reversed })
  {
    scene.Camera->SetDepthMapping(static_cast<int>(mapping));
    Check(scene, ShotOf(this->GetParam(), true), "mapping-" + std::to_string(int(mapping)));
  }
}

namespace
{
void CheckBothEyes(VolumeScene& scene, Shot shot, const StereoOptions& stereo)
{
  const std::string model = stereo.Model->Name;
  shot.Options.Stereo = stereo;
  if (!stereo.Model->Check(stereo, *FindProjection(shot.Projection)).empty())
  {
    return; // not of this model
  }
  for (bool inside : { false, true })
  {
    shot.Eye = ShotOf(shot.Projection.c_str(), inside).Eye;
    for (const Eye eye : { Eye::Left, Eye::Right })
    {
      shot.Options.Stereo.Eye = eye;
      Check(scene, shot,
        model + (eye == Eye::Left ? "-left" : "-right") + (inside ? "-inside" : "-outside"));
    }
  }
}
}

// Each eye's own rays.
TEST_P(Volumes, BothEyesOfAnOmnidirectionalPair)
{
  VolumeScene scene(Wavelet());
  scene.SetBall({ vec3(2, -1, 3), 2.5 });
  StereoOptions stereo;
  stereo.Model = FindStereoModel("omnidirectional");
  stereo.InterpupillaryDistance = 1.6;
  CheckBothEyes(scene, ShotOf(this->GetParam(), true), stereo);
}

// Along curves; bodies have no parallax with this model, so there is no ball.
TEST_P(Volumes, BothEyesOfAWarpedVolume)
{
  VolumeScene scene(Wavelet());
  Shot shot = ShotOf(this->GetParam(), true);
  shot.Options.Radii = { { 0.5, 60 } };
  StereoOptions stereo;
  stereo.Model = FindStereoModel("warped");
  CheckBothEyes(scene, shot, stereo);
}

INSTANTIATE_TEST_SUITE_P(All, Volumes,
  testing::Values("equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap"),
  [](const auto& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });
