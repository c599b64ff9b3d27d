// SPDX-License-Identifier: BSD-3-Clause
// What a wrong distance amounts to in pixels, against shifts known beforehand.
#include "DepthShift.h"
#include "RayCaster.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace wfv;
using namespace wfv::reference;

namespace
{
constexpr int Width = 1024;
constexpr int Height = 512;
constexpr int I = 600;
constexpr int J = 255;

View WholeSphere()
{
  ViewOptions o;
  o.Radii = { { 0.1, 100 } };
  return View(*FindProjection("equirectangular"), o);
}

// A large triangle that leans away to the right; the greater `lean`, the more edge-on.
TriangleSoup Leaning(double lean)
{
  TriangleSoup soup;
  soup.Points = { { -20, -9, -10 + 20 * lean }, { 20, -9, -10 - 20 * lean }, { 0, 30, -10 } };
  soup.Triangles = { { { 0, 1, 2 } } };
  soup.CellIds = { 0 };
  return soup;
}

Hit HitAt(const RayCaster& caster, double x, double y)
{
  const ViewRay ray = caster.GetView().Ray(PixelToNdc(x, y, Width, Height));
  return caster.Cast(ray.Origin, ray.Direction);
}
}

// The distance seen some hundredths of a pixel to the right, along the slope: that shift.
TEST(DepthShift, IsTheShiftThatShowsTheDistance)
{
  for (double lean : { -2.0, 0.1, 0.8 })
  {
    const RayCaster caster(Leaning(lean), WholeSphere());
    const Hit here = HitAt(caster, I + 0.5, J + 0.5);
    ASSERT_EQ(here.Cell, 0);
    const double drawn = HitAt(caster, I + 0.52, J + 0.5).Distance;
    // the slope upwards adds a little, and the surface bends
    EXPECT_NEAR(DepthShift(caster, Width, Height, I, J, here, drawn), 0.02, 0.001) << lean;
    EXPECT_EQ(DepthShift(caster, Width, Height, I, J, here, here.Distance), 0) << lean;
  }
}

TEST(DepthShift, IsInfiniteWithoutATriangleOrANumber)
{
  const RayCaster caster(Leaning(1), WholeSphere());
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(DepthShift(caster, Width, Height, I, J, Hit(), 1), infinite);
  const Hit here = HitAt(caster, I + 0.5, J + 0.5);
  EXPECT_EQ(DepthShift(caster, Width, Height, I, J, here, std::nan("")), infinite);
}

// Rounding the ray's direction to float32 changes the distance by no more, and often by as much.
TEST(DepthRounding, IsWhatRoundingTheRayMakes)
{
  for (double lean : { -2.0, 0.1, 0.8 })
  {
    const RayCaster caster(Leaning(lean), WholeSphere());
    const TriangleSoup& soup = caster.GetTriangles();
    const vec3 p = soup.Points[0];
    const vec3 normal = glm::cross(soup.Points[1] - p, soup.Points[2] - p);
    double most = 0;
    for (int i = I - 40; i < I + 40; ++i)
    {
      const vec2 ndc = PixelToNdc(i + 0.5, J + 0.5, Width, Height);
      const Hit hit = caster.Cast(ndc);
      if (hit.Cell != 0)
      {
        continue;
      }
      const vec3 d = caster.GetView().Ray(ndc).Direction;
      const vec3 rounded = vec3{ float(d.x), float(d.y), float(d.z) };
      const double distance = glm::dot(normal, p) / glm::dot(normal, rounded);
      const double bound = DepthRounding(caster, Width, Height, i, J, hit);
      const double share = std::abs(distance / hit.Distance - 1) / bound;
      EXPECT_LE(share, 1 + 1e-6) << lean << " " << i; // first order
      most = std::max(most, share);
    }
    EXPECT_GT(most, 0.5) << lean;
  }
}
