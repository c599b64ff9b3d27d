// SPDX-License-Identifier: BSD-3-Clause
#include "Promise.h"

#include "NearestFace.h"
#include "NearestPlace.h"
#include "RayCaster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace wfv
{
namespace test
{
namespace
{
// Whether a ray within so many pixels of the pixel's centre sees what was drawn. Of the 48 points
// that explain some step over thin corners of cells, so more are tried here.
bool IsSeenAround(const reference::RayCaster& caster, const Shot& shot,
  const reference::WorstPixel& pixel, double tolerance)
{
  constexpr int circles = 32;
  constexpr int points = 256;
  for (int k = 0; k < circles * points; ++k)
  {
    const double radius = tolerance * (k / points + 1) / circles;
    const double angle = 2 * WFV_PI * (k % points) / points;
    const vec2 ndc = reference::PixelToNdc(pixel.I + 0.5 + radius * std::cos(angle),
      pixel.J + 0.5 + radius * std::sin(angle), shot.Width, shot.Height);
    if (caster.Sees(ndc, pixel.Drawn))
    {
      return true;
    }
  }
  return false;
}

// The same by the cell's own picture, where that is to be had.
bool IsSeenWithin(const reference::RayCaster& caster, const Shot& shot,
  const reference::WorstPixel& pixel, double tolerance)
{
  const vec2 centre(pixel.I + 0.5, pixel.J + 0.5);
  const double limit = 2 * tolerance; // the search compares it with distances of first order
  return IsSeenAround(caster, shot, pixel, tolerance) ||
    reference::NearestPlace(caster, shot.Width, shot.Height, centre, pixel.Drawn, limit) <=
    tolerance + reference::SnapStep;
}

// Whether the face that was drawn is seen so near, or would be, were nothing before it.
bool IsThere(const reference::RayCaster& caster, const View& view, const Shot& shot,
  const reference::WorstPixel& pixel, double tolerance)
{
  if (pixel.Drawn < 0)
  {
    return false;
  }
  bool inside = false;
  if (!IsClear(view, pixel.I, pixel.J, shot.Width, shot.Height, tolerance, inside))
  {
    return true; // its place may be beyond the border of the map, where no ray is
  }
  const vec2 centre(pixel.I + 0.5, pixel.J + 0.5);
  const double most = tolerance + reference::SnapStep;
  return reference::NearestFace(caster, shot.Width, shot.Height, centre, pixel.Drawn, most) <= most;
}
}

void ExpectFacesThatAreThere(const reference::RayCaster& caster, const Shot& shot,
  const reference::Metrics& m, double tolerance, const std::string& scene)
{
  const View& view = caster.GetView();
  for (const reference::WorstPixel& pixel : m.Worst)
  {
    EXPECT_TRUE(IsThere(caster, view, shot, pixel, tolerance))
      << scene << "\n  " << Describe(shot) << "\n    "
      << DescribePixel(view, shot.Width, shot.Height, pixel);
  }
}

long MostOff(double share, long pixels)
{
  const double mean = share * double(pixels);
  return static_cast<long>(mean + MostDeviations * std::sqrt(mean));
}

long CountOff(const reference::RayCaster& caster, const Shot& shot, const reference::Metrics& m,
  double tolerance)
{
  return std::count_if(m.Worst.begin(), m.Worst.end(),
    [&](const auto& pixel) { return !IsSeenWithin(caster, shot, pixel, tolerance); });
}

void ExpectPromise(const reference::RayCaster& caster, const Shot& shot,
  const reference::Metrics& m, double tolerance, const std::string& scene, double share)
{
  const std::string details =
    scene + "\n  " + Describe(shot) + "\n" + Details(shot, caster.GetView(), m);
  const long off = CountOff(caster, shot, m, tolerance);
  ASSERT_LT(off, long(reference::Metrics::MaxWorst)) << details; // or not all are known
  EXPECT_LE(off, MostOff(share, long(shot.Width) * shot.Height)) << details;
  ExpectFacesThatAreThere(caster, shot, m, tolerance, scene);
}

void ExpectPromise(const Drawing& drawing, const Shot& shot, const reference::DrawnPicture& picture,
  double tolerance, const std::string& scene)
{
  ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
  const reference::RayCaster caster(drawing.GetMesh(), drawing.GetView(), drawing.GetPose());
  const reference::Metrics m = reference::Compare(picture, caster, tolerance);
  std::cout << Row(shot, scene, m) << std::endl;
  ExpectPromise(caster, shot, m, tolerance, scene);
}
}
}
