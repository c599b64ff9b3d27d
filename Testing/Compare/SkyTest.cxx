// SPDX-License-Identifier: BSD-3-Clause
// Skies: each pixel against the texture looked up, in double, along the pixel's ray.
#include "Poses.h"
#include "SkyScene.h"
#include "Stereo/Stereo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Of 255: what rounding, and the 8 bits of OpenGL's weights, make of texels that differ by 40.
constexpr double Levels = 2;

// The same of mean texels, which are of other places than the one looked up.
constexpr double MeanLevels = 4;

// A shot in no direction in particular, with a tilt.
Shot ObliqueShot(const std::string& projection)
{
  NamedPose pose;
  pose.Eye = vec3(0.3, 0.2, -0.1);
  pose = Turned(pose, 33, 21, "oblique");
  Shot shot = MakeShot(projection, WidestDrawn(*FindProjection(projection)), pose);
  shot.Width = 256;
  shot.Height = 128;
  shot.Options.Tilt = 17;
  shot.Options.Radii = { { 0.1, 50 } };
  return shot;
}

StereoOptions Eyes(const char* model, Eye eye)
{
  StereoOptions s;
  s.Model = FindStereoModel(model);
  s.Eye = eye;
  s.InterpupillaryDistance = 0.2;
  return s;
}

SkyImage Panorama(int width, int height)
{
  return SkyImage(width, height, [](vec2 place) { return SmoothColor(SphereDirection(place)); });
}
}

class Sky : public ::testing::TestWithParam<std::string>
{
protected:
  // Asserts one picture, of one eye.
  void Check(const Shot& shot, const SkyLookup& lookup, double levels, const std::string& name)
  {
    const SkyPicture picture = Window->Draw(shot);
    Window->Keep(name + "-" + this->GetParam());
    const SkyTally t = CheckFar(*Window, picture, lookup);
    EXPECT_LE(t.Worst, levels) << name << " at " << t.Where << ": " << Describe(shot);
    EXPECT_GT(t.Inside, picture.Width * picture.Height / 8) << name;
    EXPECT_LT(t.Uncertain, picture.Width) << name;
    EXPECT_EQ(t.Near, 0) << name;
  }

  // Of so many times as many pixels a side: the mean of a pixel's texels is that of its middle.
  static Shot Larger(Shot shot, int times)
  {
    shot.Width *= times;
    shot.Height *= times;
    return shot;
  }

  // Mono, and both eyes of each model that the projection has; through a lens where it takes one.
  std::vector<Shot> Shots()
  {
    std::vector<Shot> shots{ ObliqueShot(this->GetParam()) };
    if (FindProjection(this->GetParam())->HasLens)
    {
      shots.front().Options.HorizontalFov = 200;
      shots.front().Options.Lens = { { 0.7, 0.02, -0.05, 0, 0 } };
    }
    const bool planar = FindProjection(this->GetParam())->Axis == Family::Planar;
    for (const char* model : { "omnidirectional", "warped" })
    {
      for (Eye eye : { Eye::Left, Eye::Right })
      {
        shots.push_back(shots.front());
        shots.back().Options.Stereo = Eyes(model, eye);
      }
    }
    shots.resize(planar ? 1 : shots.size());
    return shots;
  }

  static void SetUpTestSuite() { Window.reset(new SkyWindow); }
  static void TearDownTestSuite() { Window.reset(); }

  static inline std::unique_ptr<SkyWindow> Window;
};

TEST_P(Sky, Sphere)
{
  // of few texels, which differ much
  const SkyImage image(24, 12, [](vec2 place) {
    const vec3 d = SphereDirection(place);
    const int n = static_cast<int>(24 * place.x) + 7 * static_cast<int>(12 * place.y);
    return 0.6 * SmoothColor(d) + SkyColor(n % 5 * 8, n % 3 * 14, n % 7 * 6);
  });
  Window->Sky->SetProjectionToSphere();
  Window->Sky->SetTexture(SphereTexture(image, false));
  int i = 0;
  for (const Shot& shot : this->Shots())
  {
    this->Check(
      shot, [&image](const ViewRay& ray) { return image.At(SpherePlace(ray.Direction)); }, Levels,
      "sphere" + std::to_string(i++));
  }
}

// Of many more texels than pixels: no line at the texture's seam, nothing at its poles.
TEST_P(Sky, MeanTexels)
{
  const SkyImage image = Panorama(2048, 1024);
  Window->Sky->SetProjectionToSphere();
  Window->Sky->SetTexture(SphereTexture(image, true));
  this->Check(
    Larger(ObliqueShot(this->GetParam()), 2),
    [](const ViewRay& ray) { return SmoothColor(ray.Direction); }, MeanLevels, "means");
}

TEST_P(Sky, StereoSphere)
{
  const SkyImage image(24, 24, [](vec2 place) {
    const bool left = place.y > 0.5;
    const vec3 d = SphereDirection(vec2(place.x, 2 * place.y - (left ? 1 : 0)));
    return left ? SmoothColor(d) : SkyColor(255) - SmoothColor(d);
  });
  Window->Sky->SetProjectionToStereoSphere();
  Window->Sky->SetTexture(SphereTexture(image, false));
  int i = 0;
  for (const Shot& shot : this->Shots())
  {
    const double low = shot.Options.Stereo.Eye == Eye::Right ? 0 : 0.5;
    this->Check(
      shot,
      [&image, low](const ViewRay& ray) {
        const vec2 place = SpherePlace(ray.Direction);
        return image.At(vec2(place.x, low + 0.5 * place.y), low, low + 0.5);
      },
      Levels, "halves" + std::to_string(i++));
  }
}

TEST_P(Sky, Cube)
{
  for (bool mipmap : { false, true })
  {
    Window->Sky->SetProjectionToCube();
    Window->Sky->SetTexture(CubeTexture(mipmap ? 512 : 128, mipmap));
    int i = 0;
    for (const Shot& shot : this->Shots())
    {
      this->Check(
        Larger(shot, mipmap ? 2 : 1), [](const ViewRay& ray) { return SmoothColor(ray.Direction); },
        MeanLevels, (mipmap ? "means-of-cube" : "cube") + std::to_string(i++));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Sky,
  ::testing::Values("equirectangular", "hammer", "sinusoidal", "azimuthal-equidistant",
    "stereographic", "equi-angular-cubemap", "panini", "perspective"),
  [](const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });
