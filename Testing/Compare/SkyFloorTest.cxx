// SPDX-License-Identifier: BSD-3-Clause
// Skyboxes that are a floor: each pixel against the tile and the distance that its ray meets, in
// double.
#include "SkyScene.h"
#include "Stereo/Stereo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Height of the eye above the floor.
constexpr double Height = 1.5;

// Of 255: near the horizon a tile is few pixels, and a place a tenth of a texel off.
constexpr double TileLevels = 6;

// Of the range of depth, 200 units, most of it beside the horizon.
constexpr double FloorDepth = 2e-4;

// Sine of the elevation under which VTK lets the floor fade out.
constexpr double Fades = 0.02;

// Where a ray meets the floor: distance, or below 0.
double Meet(const ViewRay& ray)
{
  return (-Height - ray.Origin.y) / ray.Direction.y;
}

// The ray of a pixel that sees the floor: where rays are curves the one at the depth at which the
// curve meets it.
ViewRay FloorRay(SkyWindow& window, const View& view, const vec2& ndc)
{
  double low = -1;
  double high = 1;
  const bool curved = view.GetStereoModel() && !view.GetStereoModel()->Traits.StraightRays;
  for (int i = 0; curved && i < 60; i++)
  {
    const double middle = 0.5 * (low + high);
    const double away = Meet(window.InWorld(view.RayAt(vec3(ndc, middle))));
    const double depth = away > 0 ? 2 * wfvDepthOf(away, view.GetParameters()) - 1 : 1;
    (std::min(depth, 1.0) > middle ? low : high) = middle;
  }
  return window.InWorld(view.RayAt(vec3(ndc, high)));
}

void SetFloor(SkyWindow& window, const SkyImage& tiles, bool mipmap)
{
  window.Sky->SetProjectionToFloor();
  window.Sky->SetFloorPlane(0, 1, 0, static_cast<float>(Height));
  window.Sky->SetFloorRight(1, 0, 0);
  window.Sky->SetTexture(SphereTexture(tiles, mipmap));
}

// Colours and depths of one eye's picture.
void CheckFloor(SkyWindow& window, const SkyImage& tiles, const Shot& shot)
{
  const SkyPicture picture = window.Draw(shot);
  window.Keep("floor-" + shot.Options.Stereo.Model->Name + "-" + shot.Projection);
  const View view = window.GetView();
  SkyTally t;
  double worstDepth = 0;
  picture.ForEach([&](int x, int y) {
    const ViewRay ray = FloorRay(window, view, picture.NdcOf(x, y));
    const double away = Meet(ray);
    if (!ray.Inside || !(away > 0) || std::abs(ray.Direction.y) < Fades)
    {
      t.Outside += picture.At(x, y) == NoSky;
      return;
    }
    t.Inside++;
    const vec3 hit = ray.Origin + away * ray.Direction;
    t.Look(picture, x, y, tiles.Tiled(vec2(hit.x, -hit.z)));
    const double depth = std::min(wfvDepthOf(away, view.GetParameters()), 1.0);
    worstDepth = std::max(worstDepth, std::abs(depth - picture.DepthAt(x, y)));
  });
  EXPECT_LE(t.Worst, TileLevels) << Describe(shot) << " at " << t.Where;
  EXPECT_GT(t.Inside, 3000) << Describe(shot);
  EXPECT_GT(t.Outside, 4000) << Describe(shot);
  EXPECT_LE(worstDepth, FloorDepth) << Describe(shot);
}
}

TEST(SkyFloor, IsAtItsDistanceForEachEye)
{
  SkyWindow window;
  const SkyImage tiles(8, 8, [](vec2 place) {
    const vec2 a = 2 * WFV_PI * place;
    return SkyColor(128) + 100.0 * SkyColor(std::cos(a.x), std::sin(a.y), std::cos(a.x + a.y));
  });
  SetFloor(window, tiles, false);
  for (const char* projection : { "equirectangular", "azimuthal-equidistant" })
  {
    for (const char* model : { "mono", "omnidirectional", "warped" })
    {
      Shot shot = WideSkyShot(projection);
      shot.Options.Stereo.Model = FindStereoModel(model);
      shot.Options.Stereo.Eye = Eye::Right;
      shot.Options.Stereo.InterpupillaryDistance = 0.8;
      CheckFloor(window, tiles, shot);
    }
  }
}

// Far away a pixel shows many tiles: their mean, no noise.
TEST(SkyFloor, ShowsTheMeanOfFarTiles)
{
  SkyWindow window;
  const SkyImage tiles(
    64, 64, [](vec2 place) { return SkyColor((place.x > 0.5) == (place.y > 0.5) ? 228 : 28); });
  SetFloor(window, tiles, true);
  for (const char* projection : { "equirectangular", "hammer", "equi-angular-cubemap" })
  {
    const SkyPicture picture = window.Draw(WideSkyShot(projection));
    window.Keep(std::string("far-floor-") + projection);
    const View view = window.GetView();
    SkyTally t;
    picture.ForEach([&](int x, int y) {
      const ViewRay ray = window.InWorld(view.Ray(picture.NdcOf(x, y)));
      if (ray.Inside && ray.Direction.y < -Fades && ray.Direction.y > -0.05)
      {
        t.Inside++;
        t.Look(picture, x, y, SkyColor(128));
      }
    });
    EXPECT_LE(t.Worst, 10) << projection << " at " << t.Where;
    EXPECT_GT(t.Inside, 200) << projection;
  }
}
