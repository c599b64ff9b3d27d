// SPDX-License-Identifier: BSD-3-Clause
// Round maps that lie where a camera's calibration has found them.
#include "Views.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels, and radians: what is left of double.
constexpr double MeasuredRounding = 1e-9;

// Pixels of a measured picture, and where its axis is and how large a radian.
MeasuredPicture Aside()
{
  return { vec2(1280, 960), vec2(655.7, 402.1), vec2(433.5, 421) };
}

std::vector<Projection> RoundOnes()
{
  std::vector<Projection> round;
  for (const Projection& p : Projections())
  {
    if (p.Axis == Family::Azimuthal)
    {
      round.push_back(p);
    }
  }
  return round;
}

ViewOptions MeasuredOptions(const Projection& p, double aspect)
{
  ViewOptions o;
  o.HorizontalFov = std::min(200.0, p.MaxHorizontalFov);
  o.VerticalFov = std::min(180.0, p.MaxVerticalFov);
  o.Aspect = aspect;
  o.Measured = Aside();
  return o;
}

// Of a place in a picture of that size, y down.
vec2 NdcOf(const vec2& pixel, const vec2& size)
{
  return vec2(2 * pixel.x / size.x - 1, 1 - 2 * pixel.y / size.y);
}
}

// The pixel of a direction is the axis plus the focal lengths times the radius; rays go back.
TEST(Measured, PixelsAreAxisAndFocalLengths)
{
  for (const Projection& p : RoundOnes())
  {
    const MeasuredPicture m = Aside();
    const View view(p, MeasuredOptions(p, m.Size.x / m.Size.y));
    for (double theta = 0.05; theta < view.GetParameters().maxAngle; theta += 0.1)
    {
      const double radius = RadiusAt(p, MeasuredOptions(p, 1), theta);
      for (double turn = 0; turn < 6; turn += 0.7)
      {
        const vec2 pixel = m.Axis + m.Focal * radius * vec2(std::cos(turn), -std::sin(turn));
        const vec3 d = wfvAzimuthalDirection(vec2(turn, theta));
        const NdcPoint at = view.Forward(5.0 * d);
        const vec2 expected = NdcOf(pixel, m.Size);
        ASSERT_NEAR(at.Ndc.x, expected.x, MeasuredRounding * radius) << p.Name << " " << theta;
        ASSERT_NEAR(at.Ndc.y, expected.y, MeasuredRounding * radius) << p.Name << " " << theta;
        const bool window = std::abs(expected.x) <= 1 && std::abs(expected.y) <= 1;
        ASSERT_EQ(at.Inside, window) << p.Name << " " << theta;
        const ViewRay ray = view.Ray(vec2(at.Ndc.x, at.Ndc.y));
        ASSERT_TRUE(ray.Inside) << p.Name;
        const double slack = p.FlatRim ? 1e-6 : MeasuredRounding;
        ASSERT_LT(glm::length(ray.Direction - d), slack) << p.Name << " " << theta;
      }
    }
  }
}

// A window of another shape shows the measured picture as large as it fits, in its middle.
TEST(Measured, OtherWindowsShowItInTheMiddle)
{
  for (const Projection& p : RoundOnes())
  {
    const View same(p, MeasuredOptions(p, 4.0 / 3));
    const View wide(p, MeasuredOptions(p, 8.0 / 3));
    const View high(p, MeasuredOptions(p, 2.0 / 3));
    for (const vec3& d : RandomDirections(50))
    {
      const vec3 a = same.Forward(5.0 * d).Ndc;
      const vec3 b = wide.Forward(5.0 * d).Ndc;
      const vec3 c = high.Forward(5.0 * d).Ndc;
      const double size = std::max(1.0, glm::length(a));
      ASSERT_NEAR(b.x, 0.5 * a.x, MeasuredRounding * size) << p.Name;
      ASSERT_NEAR(b.y, a.y, MeasuredRounding * size) << p.Name;
      ASSERT_NEAR(c.x, a.x, MeasuredRounding * size) << p.Name;
      ASSERT_NEAR(c.y, 0.5 * a.y, MeasuredRounding * size) << p.Name;
    }
  }
}

// What no lens has is refused, and so is a place in a map that is not round.
TEST(Measured, AbsurdNumbersAreRefused)
{
  const Projection& fisheye = *FindProjection("azimuthal-equidistant");
  const auto refuses = [&](const MeasuredPicture& m) {
    ViewOptions o;
    o.Measured = m;
    return CheckOptions(fisheye, o);
  };
  const double nan = std::nan("");
  const vec2 size(1280, 960);
  EXPECT_EQ(refuses(Aside()), "");
  for (const MeasuredPicture& m :
    { MeasuredPicture{ vec2(-5, 960), size / 2.0, vec2(400) },
      MeasuredPicture{ vec2(1280, 0), size / 2.0, vec2(400) },
      MeasuredPicture{ vec2(nan, 960), size / 2.0, vec2(400) },
      MeasuredPicture{ vec2(1e9, 960), size / 2.0, vec2(400) },
      MeasuredPicture{ size, size / 2.0, vec2(0, 400) },
      MeasuredPicture{ size, size / 2.0, vec2(400, -400) },
      MeasuredPicture{ size, size / 2.0, vec2(400, nan) },
      MeasuredPicture{ size, size / 2.0, vec2(1e9) }, MeasuredPicture{ size, vec2(1e9), vec2(400) },
      MeasuredPicture{ size, vec2(nan, 0), vec2(400) } })
  {
    EXPECT_NE(refuses(m), "") << Text(m.Size) << " " << Text(m.Axis) << " " << Text(m.Focal);
  }
  ViewOptions o;
  o.Measured = Aside();
  EXPECT_NE(CheckOptions(*FindProjection("hammer"), o), "");
}

// A lens of OpenCV: the radius is t (1 + k1 t^2 + ..) of the angle, or of its tangent.
TEST(Measured, RadiiAreOpenCVs)
{
  const double k[4] = { -0.021, 0.0043, -0.0061, 0.0009 };
  ViewOptions o;
  o.HorizontalFov = 150;
  o.Lens = { { 1, 0, k[0], 0, k[1], 0, k[2], 0, k[3] } };
  for (double theta = 0; theta < 1.3; theta += 0.05)
  {
    for (const char* name : { "azimuthal-equidistant", "brown-conrady" })
    {
      const double t = name[0] == 'a' ? theta : std::tan(theta);
      const double s = t * t;
      const double expected = t * (1 + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3]))));
      if (theta < 0.7 || name[0] == 'a')
      {
        EXPECT_NEAR(RadiusAt(*FindProjection(name), o, theta), expected, 1e-12) << name;
      }
    }
  }
}
