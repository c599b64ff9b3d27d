// SPDX-License-Identifier: BSD-3-Clause
// `ray` answers for every NDC, `forward` for every point: never with NaN.
#include "Views.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// How far from 1 the length of a direction may be.
constexpr double UnitLength = 1e-12;

// NDC nothing could be drawn at, among plain ones.
std::vector<double> Extremes()
{
  return { 0, -0.0, 0.5, 1, std::nextafter(1.0, 2.0), 1.5, 10, 1e6, 1e30, 1e150, 1e300,
    std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min(), Infinity,
    std::numeric_limits<double>::quiet_NaN() };
}

::testing::AssertionResult IsSane(const NamedView& v, const vec2& ndc)
{
  const ViewRay ray = v.TheView.Ray(ndc);
  const double length = glm::length(ray.Direction);
  if (!(std::abs(length - 1) <= UnitLength))
  {
    return ::testing::AssertionFailure()
      << v.Name << " ndc " << Text(ndc) << " direction " << Text(ray.Direction);
  }
  if (ray.Inside && !(std::isfinite(ndc.x) && std::isfinite(ndc.y)))
  {
    return ::testing::AssertionFailure() << v.Name << " says inside at ndc " << Text(ndc);
  }
  return ::testing::AssertionSuccess();
}
}

TEST(NeverNan, RayAtExtremes)
{
  for (const NamedView& v : AllViews())
  {
    for (double x : Extremes())
    {
      for (double y : Extremes())
      {
        EXPECT_TRUE(IsSane(v, vec2(x, y)));
        EXPECT_TRUE(IsSane(v, vec2(-x, y)));
        EXPECT_TRUE(IsSane(v, vec2(x, -y)));
        EXPECT_TRUE(IsSane(v, vec2(-x, -y)));
      }
    }
  }
}

TEST(NeverNan, OutsideTheDomainIsSaid)
{
  for (const Projection& p : Projections())
  {
    if (p.Axis == Family::Planar)
    {
      continue; // its plane has no border
    }
    ViewOptions o;
    o.HorizontalFov = p.MaxHorizontalFov;
    o.VerticalFov = p.MaxVerticalFov;
    o.Aspect = 1;
    const View view(p, o);
    EXPECT_TRUE(view.Ray(vec2(0, 0)).Inside) << p.Name;
    EXPECT_TRUE(view.Ray(vec2(0.999999, 0)).Inside) << p.Name;
    EXPECT_FALSE(view.Ray(vec2(1.000001, 0)).Inside) << p.Name;
    EXPECT_FALSE(view.Ray(vec2(0, -1.000001)).Inside) << p.Name;
    EXPECT_FALSE(view.Ray(vec2(Infinity, 0)).Inside) << p.Name;
    const bool corner = view.Ray(vec2(0.9, 0.9)).Inside;
    // cylinders, seen straight or from their far side, and cubes have corners
    const bool hasCorners = p.StraightSeam || p.Name == "panini" || p.Axis == Family::Faces;
    EXPECT_EQ(corner, hasCorners) << p.Name;
  }
}

TEST(NeverNan, BehindThePlanarEyeIsSaid)
{
  ViewOptions o;
  o.HorizontalFov = o.VerticalFov = 90;
  const View view(*FindProjection("perspective"), o);
  for (const vec3& d : { vec3(0, 0, 1), vec3(1, 0, 0), vec3(0.1, 0.2, 0.5) })
  {
    const NdcPoint p = view.Forward(d);
    EXPECT_FALSE(p.Inside) << Text(d);
    EXPECT_TRUE(std::isfinite(p.Ndc.x) && std::isfinite(p.Ndc.y)) << Text(d);
  }
}

TEST(NeverNan, ForwardAtExtremes)
{
  const double sizes[] = { 0, 1e-300, 1e-30, 1, 1e30, 1e150 };
  for (const NamedView& v : AllViews())
  {
    for (double x : sizes)
    {
      for (double y : sizes)
      {
        for (double z : { 0.0, 1.0, -1.0, 1e-300, -1e30 })
        {
          const NdcPoint p = v.TheView.Forward(vec3(x, y, z));
          EXPECT_FALSE(std::isnan(p.Ndc.x) || std::isnan(p.Ndc.y) || std::isnan(p.Ndc.z))
            << v.Name << " point " << Text(vec3(x, y, z));
        }
      }
    }
  }
}

RC_GTEST_PROP(NeverNan, RayAtAnyBits, (double x, double y))
{
  static const std::vector<NamedView> views = AllViews();
  const auto& v = *rc::gen::elementOf(views);
  RC_ASSERT(IsSane(v, vec2(x, y)));
}
