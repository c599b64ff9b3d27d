// SPDX-License-Identifier: BSD-3-Clause
// How far away lies what a view shows of a box: no farther than is said, and as far.
#include "Projections/Bounds/ViewFrustum.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int Boxes = 200; // a view
constexpr int Points = 60; // a box

// Relative: what lengths in double may differ by.
constexpr double LengthRounding = 1e-12;

class RandomBoxes
{
public:
  double Unit() { return this->Distribution(this->Engine); }

  // Round the eye and beside it, ahead and behind, flat ones among them.
  BoxCorners Make()
  {
    this->Middle = vec3(this->Unit(), this->Unit(), this->Unit()) * std::pow(10, this->Unit());
    this->Half = glm::abs(vec3(this->Unit(), this->Unit(), this->Unit())) *
      std::pow(10, this->Unit()) * (this->Unit() > 0.8 ? vec3(1, 0, 1) : vec3(1));
    BoxCorners corners;
    for (int i = 0; i < 8; i++)
    {
      corners[i] = this->Middle + this->Half * vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    }
    return corners;
  }

  // Of the box made last, on its borders often.
  vec3 Point()
  {
    vec3 t;
    for (int i = 0; i < 3; i++)
    {
      t[i] = std::clamp(1.5 * this->Unit(), -1.0, 1.0);
    }
    return this->Middle + this->Half * t;
  }

private:
  std::mt19937_64 Engine{ 29 };
  std::uniform_real_distribution<double> Distribution{ -1, 1 };
  vec3 Middle;
  vec3 Half;
};

std::vector<NamedView> RoundViews()
{
  std::vector<NamedView> views;
  for (NamedView& v : AllViews())
  {
    if (v.TheView.GetProjection().Axis == Family::Azimuthal && v.Options.HorizontalFov >= 1)
    {
      views.push_back(v);
    }
  }
  for (const vec2& fov : { vec2(1, 0.5), vec2(40, 60), vec2(120, 90), vec2(159, 1) })
  {
    ViewOptions o;
    o.HorizontalFov = fov.x;
    o.VerticalFov = fov.y;
    o.Tilt = fov.y;
    views.push_back(MakeView(FramedPerspective(), o));
  }
  return views;
}

bool IsShown(const View& view, const vec3& p)
{
  const NdcPoint at = view.Forward(p);
  return at.Inside && std::max(std::abs(at.Ndc.x), std::abs(at.Ndc.y)) <= 1;
}

BoxCorners Box(const vec3& low, const vec3& high)
{
  BoxCorners corners;
  for (int i = 0; i < 8; i++)
  {
    corners[i] = vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
  }
  return corners;
}
}

TEST(ViewFrustum, NothingThatIsSeenIsFarther)
{
  RandomBoxes random;
  long nearer = 0;
  long shown = 0;
  for (const NamedView& v : RoundViews())
  {
    for (int i = 0; i < Boxes; i++)
    {
      const BoxCorners corners = random.Make();
      const auto farthest = FarthestSeen(v.TheView.GetProjection(), v.Options, corners);
      double most = 0;
      for (const vec3& corner : corners)
      {
        most = std::max(most, glm::length(corner));
      }
      nearer += farthest && *farthest < 0.9 * most;
      for (int k = 0; k < Points && farthest; k++)
      {
        const vec3 p = random.Point();
        if (IsShown(v.TheView, p))
        {
          shown++;
          EXPECT_LE(glm::length(p), *farthest * (1 + LengthRounding)) << v.Name;
        }
      }
    }
  }
  EXPECT_GT(nearer, 1000);
  EXPECT_GT(shown, 10000);
}

TEST(ViewFrustum, IsNotSaidWhereAnythingMayBeSeen)
{
  const BoxCorners round = Box(vec3(-1), vec3(1));
  for (const NamedView& v : AllViews())
  {
    const bool one =
      v.TheView.GetProjection().Axis == Family::Azimuthal && v.Options.HorizontalFov < 160;
    EXPECT_EQ(one, FarthestSeen(v.TheView.GetProjection(), v.Options, round).has_value()) << v.Name;
  }
}

TEST(ViewFrustum, ReachesTheFarthestPoint)
{
  const vec2 wide(2, 2);
  const vec2 low(0.5, 0.1);
  // all of it ahead: its corners
  EXPECT_DOUBLE_EQ(FarthestInFrustum(Box(vec3(-1, -1, -4), vec3(1, 1, -2)), wide), std::sqrt(18.0));
  // cut above and below
  EXPECT_DOUBLE_EQ(FarthestInFrustum(Box(vec3(-1, -1, -4), vec3(1, 1, -2)), low), std::sqrt(17.16));
  // round the eye: what is behind does not count
  EXPECT_DOUBLE_EQ(
    FarthestInFrustum(Box(vec3(-9, -9, -4), vec3(9, 9, 90)), low), std::sqrt(4 + 0.16 + 16));
  // through an edge of the frustum, beside the axis
  EXPECT_DOUBLE_EQ(FarthestInFrustum(Box(vec3(1, 0.1, -9), vec3(2, 0.3, -1)), vec2(0.5, 0.05)),
    std::sqrt(4 + 0.09 + 81));
  EXPECT_EQ(FarthestInFrustum(Box(vec3(-1, -1, 1), vec3(1, 1, 2)), wide), 0);
  EXPECT_EQ(FarthestInFrustum(Box(vec3(5, -1, -1), vec3(6, 1, -0.5)), wide), 0);
}
