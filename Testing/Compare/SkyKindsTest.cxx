// SPDX-License-Identifier: BSD-3-Clause
// Skies and what is before them: props, tiles, samples, techniques, maps without a formula,
// gradients.
#include "Overheard.h"
#include "Projections/DirectionMap.h"
#include "SkyScene.h"
#include "Stereo/Stereo.h"

#include <vtkTexture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr double Levels = 3; // of 255: as SkyTest.cxx, mixed once more

SkyColor Far(const ViewRay& ray)
{
  return SmoothColor(ray.Direction);
}

// What is seen there of two balls of radius 1 before the sky, the first opaque, the second half; no
// answer beside an outline.
bool FindMix(const ViewRay& ray, const vec3& opaque, const vec3& clear, SkyColor& color)
{
  const SkyColor yellow(255, 255, 0);
  color = Far(ray);
  for (const vec3 ball : { opaque, clear })
  {
    const double angle = std::acos(glm::dot(ray.Direction, glm::normalize(ball)));
    const double off = angle - std::asin(1 / glm::length(ball));
    if (std::abs(off) < 0.04) // balls have flat faces
    {
      return false;
    }
    if (off < 0)
    {
      color = ball == opaque ? yellow : 0.5 * (yellow + color);
    }
  }
  return true;
}

// The picture in one of two by two tiles: levels that it is off the whole.
int CompareTile(SkyWindow& window, const Shot& shot, const SkyPicture& whole, int column, int row)
{
  window.Window->SetTileScale(2, 2);
  window.Window->SetTileViewport(0.5 * column, 0.5 * row, 0.5 * column + 0.5, 0.5 * row + 0.5);
  Shot part = shot;
  part.Width /= 2;
  part.Height /= 2;
  const SkyPicture tile = window.Draw(part);
  SkyTally t;
  tile.ForEach([&](int x, int y) {
    t.Look(tile, x, y, whole.At(column * tile.Width + x, row * tile.Height + y));
  });
  return static_cast<int>(t.Worst);
}

// Share of the pixel that is inside the map.
double InsideShare(const View& view, const SkyPicture& picture, int x, int y)
{
  double share = 0;
  for (int i = 0; i < 64; i++)
  {
    const vec2 pixels = (vec2(i % 8, i / 8) - 3.5) / 8.0;
    const vec2 ndc = picture.NdcOf(x, y) + 2.0 * pixels / vec2(picture.Width, picture.Height);
    share += view.Ray(ndc).Inside / 64.0;
  }
  return share;
}

// Directions in the left half.
std::shared_ptr<const DirectionMap> HalfMap(int width, int height)
{
  std::vector<float> directions;
  for (int i = 0; i < width * height; i++)
  {
    const vec2 at((i % width) / (0.5 * width), (i / width) / double(height));
    const vec3 d = wfvMeridianDirection(WFV_PI * vec2(0.8 * (at.x - 1), 0.8 * (at.y - 0.5)));
    for (int k = 0; k < 3; k++)
    {
      directions.push_back(at.x < 1 ? static_cast<float>(d[k]) : 0.f);
    }
  }
  return std::make_shared<const DirectionMap>(width, height, directions);
}

const SkyColor Horizon(204, 153, 102);
const SkyColor Zenith(0, 51, 204);

// One picture of a gradient.
SkyTally CheckGradient(SkyWindow& window, const Shot& shot, const vec3& up)
{
  window.Renderer->SetEnvironmentUp(up.x, up.y, up.z);
  const SkyPicture picture = window.Draw(shot);
  window.Keep("gradient-" + shot.Options.Stereo.Model->Name + "-" + shot.Projection);
  const View view = window.GetView();
  SkyTally t;
  picture.ForEach([&](int x, int y) {
    const vec3 ndc(picture.NdcOf(x, y), 1);
    const ViewRay ray = window.InWorld(view.RayAt(ndc));
    if (IsCertain(view, ndc))
    {
      const double height = std::asin(glm::dot(up, ray.Direction)) / (0.5 * WFV_PI);
      t.Look(
        picture, x, y, Horizon + (ray.Inside ? std::max(0.0, height) : 0) * (Zenith - Horizon));
    }
  });
  return t;
}
}

TEST(SkyTexture, WithoutOneTheBackgroundIsSeen)
{
  const Overheard vtk;
  SkyWindow window;
  const SkyPicture picture = window.Draw(WideSkyShot("equirectangular"));
  picture.ForEach([&](int x, int y) { ASSERT_EQ(picture.At(x, y), NoSky) << x << ", " << y; });
  window.Draw(WideSkyShot("hammer"));
  EXPECT_EQ(vtk.Count("vtkSkybox without a texture"), 1) << vtk.All();
}

// Whichever is added first, and with depth peeling.
TEST(SkyOrder, OpaqueHidesItAndTranslucentBlends)
{
  const vec3 opaque(2, 0, -3);
  const vec3 clear(-2, 0, 3);
  for (const int way : { 0, 1, 2, 3 })
  {
    SkyWindow window;
    window.Sky->SetProjectionToSphere();
    window.Sky->SetTexture(SmoothSky());
    window.Renderer->SetUseDepthPeeling(way & 1);
    window.Window->SetAlphaBitPlanes(1);
    if (way & 2)
    {
      window.Renderer->RemoveActor(window.Sky);
    }
    window.Renderer->AddActor(YellowBall(opaque, 1, 1));
    window.Renderer->AddActor(YellowBall(clear, 1, 0.5));
    window.Renderer->AddActor(window.Sky); // a second time it stays where it is
    const SkyPicture picture = window.Draw(WideSkyShot("equirectangular"));
    window.Keep("order" + std::to_string(way));
    const View view = window.GetView();
    SkyTally t;
    picture.ForEach([&](int x, int y) {
      const ViewRay ray = window.InWorld(view.Ray(picture.NdcOf(x, y)));
      SkyColor wanted;
      if (FindMix(ray, opaque, clear, wanted))
      {
        t.Near += wanted != Far(ray);
        t.Look(picture, x, y, wanted);
      }
    });
    EXPECT_LE(t.Worst, Levels) << t.Where << ", way " << way;
    EXPECT_GT(t.Near, 600);
  }
}

TEST(SkyTechniques, AllAndTilesAreAlike)
{
  SkyWindow window;
  window.Sky->SetProjectionToSphere();
  window.Sky->SetTexture(SmoothSky());
  const Shot shot = WideSkyShot("hammer");
  const SkyPicture whole = window.Draw(shot);
  for (int technique = vtkWideFoVPass::AUTO; technique <= vtkWideFoVPass::VERTEX; technique++)
  {
    window.Pass()->SetTechnique(technique);
    EXPECT_EQ(window.Draw(shot).Colors, whole.Colors) << technique;
  }
  window.Pass()->SetTechniqueToAuto();
  for (int i = 0; i < 4; i++)
  {
    EXPECT_LE(CompareTile(window, shot, whole, i & 1, i >> 1), 1) << "tile " << i;
  }
}

// Of the pixels beside a map's border as much is sky as samples are inside the map.
TEST(SkySamples, CoverTheBorderOfTheMap)
{
  SkyWindow window;
  window.Window->SetMultiSamples(4);
  window.Renderer->SetBackground(0, 0, 0);
  window.Sky->SetProjectionToSphere();
  const SkyImage white(4, 2, [](vec2) { return SkyColor(255); });
  window.Sky->SetTexture(SphereTexture(white, false));
  for (const char* projection : { "hammer", "azimuthal-equidistant", "sinusoidal" })
  {
    const SkyPicture picture = window.Draw(WideSkyShot(projection));
    window.Keep(std::string("samples-") + projection);
    const View view = window.GetView();
    int mixed = 0;
    double worst = 0;
    double sum = 0;
    picture.ForEach([&](int x, int y) {
      const double share = InsideShare(view, picture, x, y);
      const double off = picture.At(x, y).x / 255 - share;
      mixed += share > 0.01 && share < 0.99;
      worst = std::max(worst, std::abs(off));
      sum += off;
    });
    EXPECT_GT(mixed, 200) << projection;
    EXPECT_LE(worst, 0.5) << projection; // samples are 4
    EXPECT_LE(std::abs(sum) / mixed, 0.02) << projection;
  }
}

TEST(SkyDirectionMap, IsSeenWhereTheMapHasDirections)
{
  SkyWindow window;
  window.Sky->SetProjectionToSphere();
  window.Sky->SetTexture(SmoothSky());
  Shot shot;
  shot.Projection = "direction-map";
  shot.Width = 128;
  shot.Height = 64;
  shot.Options.Map = HalfMap(shot.Width, shot.Height);
  const SkyPicture picture = window.Draw(shot);
  window.Keep("direction-map");
  const SkyTally t = CheckFar(window, picture, Far);
  EXPECT_LE(t.Worst, Levels) << t.Where;
  EXPECT_GT(std::min(t.Inside, t.Outside), 3000);
}

// It turns with the world, not with the view.
TEST(SkyGradient, IsByElevation)
{
  const Overheard vtk;
  SkyWindow window;
  window.Renderer->RemoveActor(window.Sky);
  EXPECT_FALSE(window.Renderer->GetGradientByDirection());
  window.Renderer->GradientByDirectionOn();
  window.Renderer->GradientBackgroundOn();
  window.Renderer->SetBackground(Horizon.x / 255, Horizon.y / 255, Horizon.z / 255);
  window.Renderer->SetBackground2(Zenith.x / 255, Zenith.y / 255, Zenith.z / 255);
  vec3 up(0, 1, 0);
  for (const char* projection : { "equirectangular", "mollweide", "azimuthal-equidistant" })
  {
    for (const char* model : { "mono", "omnidirectional", "warped" })
    {
      Shot shot = WideSkyShot(projection);
      shot.Options.Stereo.Model = FindStereoModel(model);
      shot.Options.Stereo.Eye = Eye::Left;
      const SkyTally t = CheckGradient(window, shot, up);
      EXPECT_LE(t.Worst, 1) << Describe(shot) << " at " << t.Where;
    }
    up = glm::normalize(vec3(0.3, 0.2, 1));
  }
  EXPECT_EQ(vtk.All(), "");
}
