// SPDX-License-Identifier: BSD-3-Clause
// The depth mappings in double: their formulas, their ends, and back again.
#include "Projections/Projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

using namespace wfv;

namespace
{
// Relative; times the condition of the inverse, which is far / near for REVERSED (its depth
// approaches 1 long before the far sphere) and log(far / near) for LOGARITHMIC.
constexpr double DepthRoundTrip = 8 * std::numeric_limits<double>::epsilon();

const DepthMapping All[] = { DepthMapping::Linear, DepthMapping::Logarithmic,
  DepthMapping::Reversed };

const std::pair<double, double> Radii[] = { { 1e-4, 1 }, { 0.01, 1000 }, { 1, 1.001 },
  { 1e-6, 1e6 }, { 1e8, 1e12 } };

View MakeView(DepthMapping mapping, double near, double far)
{
  ViewOptions o;
  o.Mapping = mapping;
  o.Radii = { { near, far } };
  return View(*FindProjection("equirectangular"), o);
}

// As the documentation has it, without a care for rounding.
long double Formula(DepthMapping mapping, long double rho, long double near, long double far)
{
  switch (mapping)
  {
    case DepthMapping::Logarithmic:
      return std::log(rho / near) / std::log(far / near);
    case DepthMapping::Reversed:
      return (1 / near - 1 / rho) / (1 / near - 1 / far);
    default:
      return (rho - near) / (far - near);
  }
}

double Condition(DepthMapping mapping, double ratio)
{
  return mapping == DepthMapping::Linear ? 1
    : mapping == DepthMapping::Reversed  ? ratio
                                         : 1 + std::log(ratio);
}
}

TEST(Depth, FollowsTheFormulaAndComesBack)
{
  constexpr int Steps = 1000;
  for (DepthMapping mapping : All)
  {
    for (const auto& [near, far] : Radii)
    {
      const View view = MakeView(mapping, near, far);
      const WfvView& v = view.GetParameters();
      double before = -1;
      for (int i = 0; i <= Steps; i++)
      {
        const double rho = near * std::pow(far / near, double(i) / Steps);
        const double depth = wfvDepthOf(rho, v);
        const double rounding = DepthRoundTrip * Condition(mapping, far / near);
        // of a difference of two nearly equal distances where the spheres are close
        const double close = DepthRoundTrip * far / (far - near);
        EXPECT_NEAR(depth, double(Formula(mapping, rho, near, far)), DepthRoundTrip + close)
          << int(mapping) << " " << rho;
        EXPECT_GT(depth, before) << int(mapping) << " " << rho;
        before = depth;
        EXPECT_NEAR(wfvDistanceAt(depth, v) / rho, 1, rounding) << int(mapping) << " " << rho;
        EXPECT_DOUBLE_EQ(view.Forward(vec3(0, 0, -rho)).Ndc.z, 2 * depth - 1);
      }
    }
  }
}

TEST(Depth, EndsOnTheSpheres)
{
  for (DepthMapping mapping : All)
  {
    for (const auto& [near, far] : Radii)
    {
      const WfvView v = MakeView(mapping, near, far).GetParameters();
      EXPECT_EQ(wfvDepthOf(near, v), 0);
      EXPECT_EQ(wfvDepthOf(far, v), 1);
      EXPECT_LT(wfvDepthOf(0.999 * near, v), 0);
      EXPECT_GT(wfvDepthOf(1.001 * far, v), 1);
      EXPECT_LT(wfvDepthOf(0, v), 0); // the eye itself is clipped
      EXPECT_TRUE(std::isfinite(wfvDepthOf(0, v)));
    }
  }
}
