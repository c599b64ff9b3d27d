// SPDX-License-Identifier: BSD-3-Clause
// The perspective that the techniques draw is the perspective: a round map, framed.
#include "Projections/Projection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace wfv;

namespace
{
// Radians: what the tilt, the angle from the axis and the way back may add to a direction.
constexpr double FrameRounding = 8 * std::numeric_limits<double>::epsilon();

// NDC a radian, at most: how fast the perspective's picture grows there.
double Growth(const View& view, const vec3& direction)
{
  const WfvView& v = view.GetParameters();
  const double z = wfvTilt(direction, v).z;
  return std::max(v.scale.x, v.scale.y) / (z * z);
}

std::vector<ViewOptions> Frames()
{
  std::vector<ViewOptions> all;
  for (const vec2& fov :
    { vec2(0.01, 0.005), vec2(60, 40), vec2(40, 60), vec2(120, 90), vec2(150, 150), vec2(159, 1) })
  {
    for (double tilt : { 0.0, 30.0 })
    {
      ViewOptions o;
      o.HorizontalFov = fov.x;
      o.VerticalFov = fov.y;
      o.Tilt = tilt;
      all.push_back(o);
    }
  }
  return all;
}
}

TEST(Framed, HasTheRaysAndPlacesOfThePerspective)
{
  for (const ViewOptions& o : Frames())
  {
    ASSERT_TRUE(FitsFrame(o)) << o.HorizontalFov;
    const View stock(*FindProjection("perspective"), o);
    const View framed(FramedPerspective(), o);
    for (int j = -8; j <= 8; ++j)
    {
      for (int i = -8; i <= 8; ++i)
      {
        const vec2 ndc(i / 8.0, j / 8.0);
        const ViewRay a = stock.Ray(ndc);
        const ViewRay b = framed.Ray(ndc);
        EXPECT_TRUE(b.Inside);
        EXPECT_LE(glm::distance(a.Direction, b.Direction), FrameRounding);
        const NdcPoint p = framed.Forward(3.0 * a.Direction);
        EXPECT_LE(glm::distance(vec2(p.Ndc), ndc), FrameRounding * Growth(stock, a.Direction));
        EXPECT_EQ(p.Ndc.z, framed.Forward(3.0 * b.Direction).Ndc.z);
      }
    }
  }
}

TEST(Framed, ShowsNothingBesideOrBehind)
{
  const View view(FramedPerspective(), Frames()[2]);
  EXPECT_TRUE(view.Forward(vec3(0, 0, -3)).Inside);
  for (const vec3& p : { vec3(0, 0, 3), vec3(3, 0, 0), vec3(0.1, -3, 0.1), vec3(3, 0, -3) })
  {
    EXPECT_FALSE(view.Forward(p).Inside) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(Framed, EndsAt80DegreesAndAtAnAxisAside)
{
  ViewOptions o;
  o.HorizontalFov = 160.1;
  o.VerticalFov = 1;
  EXPECT_FALSE(FitsFrame(o));
  o.HorizontalFov = o.VerticalFov = 152; // its corners are at 80.005 degrees
  EXPECT_FALSE(FitsFrame(o));
  o.HorizontalFov = o.VerticalFov = 151;
  EXPECT_TRUE(FitsFrame(o));
  o.Center = vec2(0.1, 0);
  EXPECT_FALSE(FitsFrame(o));
}
