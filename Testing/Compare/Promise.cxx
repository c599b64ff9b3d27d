// SPDX-License-Identifier: BSD-3-Clause
#include "Promise.h"

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
// The triangles of one cell alone.
reference::TriangleSoup OnlyCell(const reference::TriangleSoup& all, vtkIdType cell)
{
  reference::TriangleSoup own;
  own.Points = all.Points;
  for (std::size_t i = 0; i < all.Triangles.size(); ++i)
  {
    if (all.CellIds[i] == cell)
    {
      own.Triangles.push_back(all.Triangles[i]);
      own.CellIds.push_back(cell);
    }
  }
  return own;
}

// Whether what was drawn is seen no farther from the pixel's centre than so many pixels. Of the 48
// points that explain some step over thin cells: finer circles, or the cell's own picture, tell.
bool IsSeenWithin(const reference::RayCaster& caster, const Shot& shot,
  const reference::WorstPixel& pixel, double tolerance)
{
  const vec2 centre(pixel.I + 0.5, pixel.J + 0.5);
  const double limit = 2 * tolerance; // the search compares it with distances of first order
  return std::isfinite(
           reference::NearestAgreement(caster, shot.Width, shot.Height, pixel, tolerance)) ||
    reference::NearestPlace(caster, shot.Width, shot.Height, centre, pixel.Drawn, limit) <=
    tolerance;
}

// Whether the face that was drawn is seen so near, or would be, were nothing before it.
bool IsThere(const reference::RayCaster& caster, const View& view, const Shot& shot,
  const reference::WorstPixel& pixel, double tolerance)
{
  if (pixel.Drawn < 0)
  {
    return false;
  }
  const reference::RayCaster alone(OnlyCell(caster.GetTriangles(), pixel.Drawn), view);
  const vec2 ndc = reference::PixelToNdc(pixel.I + 0.5, pixel.J + 0.5, shot.Width, shot.Height);
  return alone.Cast(ndc).Cell == pixel.Drawn || IsSeenWithin(alone, shot, pixel, tolerance);
}
}

void ExpectFacesThatAreThere(const Drawing& drawing, const Shot& shot, const reference::Metrics& m,
  double tolerance, const std::string& scene)
{
  const View& view = drawing.GetView();
  const reference::RayCaster caster(drawing.GetMesh(), view, drawing.GetPose());
  for (const reference::WorstPixel& pixel : m.Worst)
  {
    EXPECT_TRUE(IsThere(caster, view, shot, pixel, tolerance))
      << scene << "\n  " << Describe(shot) << "\n    "
      << DescribePixel(view, shot.Width, shot.Height, pixel);
  }
}

void ExpectPromise(const Drawing& drawing, const Shot& shot, const reference::DrawnPicture& picture,
  double tolerance, const std::string& scene)
{
  ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
  const View& view = drawing.GetView();
  const reference::RayCaster caster(drawing.GetMesh(), view, drawing.GetPose());
  const reference::Metrics m = reference::Compare(picture, caster, tolerance);
  std::cout << Row(shot, scene, m) << std::endl;
  const long off = std::count_if(m.Worst.begin(), m.Worst.end(),
    [&](const auto& pixel) { return !IsSeenWithin(caster, shot, pixel, tolerance); });
  ASSERT_LE(m.UnexplainedPixels, long(reference::Metrics::MaxWorst)) << Details(shot, view, m);
  EXPECT_LE(off, HiddenShare * shot.Width * shot.Height)
    << scene << "\n  " << Describe(shot) << "\n"
    << Details(shot, view, m);
  ExpectFacesThatAreThere(drawing, shot, m, tolerance, scene);
}
}
}
