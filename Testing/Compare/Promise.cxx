// SPDX-License-Identifier: BSD-3-Clause
#include "Promise.h"

#include "RayCaster.h"

#include <gtest/gtest.h>

#include <algorithm>
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

// Whether the face that was drawn would be seen so near, were nothing before it.
bool IsHiddenThere(const reference::RayCaster& caster, const View& view, const Shot& shot,
  const reference::WorstPixel& pixel, double tolerance)
{
  if (pixel.Drawn < 0)
  {
    return false;
  }
  const reference::RayCaster alone(OnlyCell(caster.GetTriangles(), pixel.Drawn), view);
  const vec2 ndc =
    reference::PixelToNdc(pixel.I + 0.5, pixel.J + 0.5, shot.Width, shot.Height);
  return alone.Cast(ndc).Cell == pixel.Drawn ||
    reference::IsExplained(alone, shot.Width, shot.Height, pixel, tolerance);
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
  EXPECT_LE(m.UnexplainedPixels, HiddenShare * shot.Width * shot.Height)
    << scene << "\n  " << Describe(shot) << "\n"
    << Details(shot, view, m);
  for (const reference::WorstPixel& pixel : m.Worst)
  {
    EXPECT_TRUE(IsHiddenThere(caster, view, shot, pixel, tolerance))
      << scene << "\n  " << Describe(shot) << "\n    "
      << DescribePixel(view, shot.Width, shot.Height, pixel);
  }
}
}
}
