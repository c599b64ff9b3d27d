// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeCheck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace wfv
{
namespace test
{
namespace
{
// Of a level: what a picture may be off by in the mean.
constexpr double MeanError = 1.0 / 255;

// Of pixels: those that may be off by more than ten of 255 levels. A sample more or fewer at the
// end of a ray, which float32 decides.
constexpr double OffShare = 0.002;

}

Shot ShotOf(const char* projection, bool inside)
{
  Shot shot;
  shot.Projection = projection;
  const bool wide = FindProjection(projection)->MaxHorizontalFov > 180;
  shot.Options.HorizontalFov = wide ? 360 : 150;
  shot.Options.VerticalFov =
    std::min(wide ? 180.0 : 100.0, FindProjection(projection)->MaxVerticalFov);
  shot.Width = 256;
  shot.Height = 128;
  if (FindProjection(projection)->Axis == Family::Azimuthal)
  {
    shot.Options.HorizontalFov = std::min(360.0, FindProjection(projection)->MaxHorizontalFov);
    shot.Options.VerticalFov = shot.Options.HorizontalFov;
    shot.Width = shot.Height = 160;
  }
  shot.Options.Radii = { { 0.01, 100 } };
  shot.Eye = inside ? vec3(1.3, 2.1, -0.7) : vec3(3, -2, 17);
  shot.Direction = vec3(0.2, 0.1, -1);
  return shot;
}

std::string PictureName(const std::string& name)
{
  const char* const folder = std::getenv("WIDEFOV_PICTURES");
  return folder ? std::string(folder) + "/" + name + ".png" : "";
}

VolumeError Check(VolumeScene& scene, const Shot& shot, const std::string& name)
{
  scene.Draw(shot, PictureName(name + "-" + shot.Projection));
  const VolumeError e = scene.Compare();
  char row[200];
  std::snprintf(row, sizeof row,
    "%-28s %-22s mean %.3f/255 max %5.1f/255 off %.5f seen %.3f contrast %.3f", name.c_str(),
    shot.Projection.c_str(), 255 * e.Mean, 255 * e.Max, e.Share, e.Seen, e.Contrast);
  std::cout << row << std::endl;
  EXPECT_LT(e.Mean, MeanError) << row;
  EXPECT_LE(e.Share, OffShare) << row;
  EXPECT_GT(e.Seen, 0.005) << row;
  return e;
}
}
}
