// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVParallax bounds how far from the middle between them two eyes see what is in a box.
#include "Stereo.h"
#include "Views.h"
#include "vtkWideFoVDiscontinuity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr double Reach = 0.1; // of the eyes, scene units

// Over what is measured: looser bounds would leave nothing far.
constexpr double Looseness = 40;

View ViewOf(const Projection& p, double tilt, Eye eye)
{
  ViewOptions o;
  o.HorizontalFov = std::clamp(360.0, p.MinHorizontalFov, p.MaxHorizontalFov);
  o.VerticalFov = std::clamp(180.0, p.MinVerticalFov, p.MaxVerticalFov);
  o.Radii = { { 0.5, 1e6 } };
  o.Tilt = tilt;
  o.Stereo.Model = FindStereoModel("omnidirectional");
  o.Stereo.InterpupillaryDistance = 2 * Reach;
  o.Stereo.Eye = eye;
  return View(p, o);
}

struct Random
{
  std::mt19937_64 Engine{ 7 };
  double operator()(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Engine);
  }
};

const double Identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };

// Of a box, how much of the bound points in it take at the most, on either axis.
double ShareOf(const View& view, const vec3& centre, double half, Random& random)
{
  const WfvView& v = view.GetParameters();
  const double box[6] = { centre.x - half, centre.x + half, centre.y - half, centre.y + half,
    centre.z - half, centre.z + half };
  const Projection& p = view.GetProjection();
  const vec2 bound = vtkWideFoVParallax(p, v, box, Identity, Reach);
  vec2 most(0);
  for (int i = 0; i < 100 && bound.x < 1; i++)
  {
    const auto at = [&](int axis) { return random(box[2 * axis], box[2 * axis + 1]); };
    const vec3 point(at(0), at(1), at(2));
    const vec3 seen = view.Forward(point).Ndc;
    const vec2 middle = p.Project(glm::normalize(wfvTilt(point, v)), v);
    // beyond the picture the map may do as it likes
    const bool shown = std::abs(middle.x) <= 1 && std::abs(middle.y) <= 1;
    most = shown ? glm::max(most, glm::abs(vec2(seen.x, seen.y) - middle)) : most;
  }
  return std::max(most.x / bound.x, most.y / bound.y);
}
}

TEST(Parallax, IsWithinItsBound)
{
  Random random;
  for (const Projection& p : Projections())
  {
    if (p.Axis == Family::Planar)
    {
      continue;
    }
    double worst = 0;
    for (const vec3& direction : RandomDirections(300))
    {
      const View view = ViewOf(p, random(-90, 90), random(-1, 1) < 0 ? Eye::Left : Eye::Right);
      const double distance = std::pow(10, random(0.5, 4));
      const vec3 centre = direction * distance;
      const double share = ShareOf(view, centre, random(0, 0.4) * distance, random);
      worst = std::max(worst, share);
      ASSERT_LE(share, 1) << p.Name << " " << Text(centre);
    }
    std::cout << p.Name << ": at most " << worst << " of the bound\n";
    EXPECT_GT(worst, 1 / Looseness) << p.Name;
  }
}

TEST(Parallax, IsUnknownWhereItMayBeAnything)
{
  const View view = ViewOf(*FindProjection("hammer"), 0, Eye::Left);
  const auto known = [&view](const vec3& low, const vec3& high, double reach) {
    const double box[6] = { low.x, high.x, low.y, high.y, low.z, high.z };
    return vtkWideFoVParallax(view.GetProjection(), view.GetParameters(), box, Identity, reach).x <
      1;
  };
  const vec3 one(1);
  EXPECT_TRUE(known(vec3(0, 0, -100), vec3(1, 1, -99), Reach));
  EXPECT_FALSE(known(-one, one, Reach));                          // round the eye
  EXPECT_FALSE(known(vec3(0.05, 0, 0), vec3(0.06, 1, 1), Reach)); // within the circle
  EXPECT_FALSE(known(vec3(-1, 0, 99), vec3(1, 1, 100), Reach));   // across the seam
  EXPECT_FALSE(known(vec3(1e-4, 0, 99), vec3(1, 1, 100), Reach)); // as near to it as it moves
  EXPECT_FALSE(known(vec3(-1, 99, -1), vec3(1, 100, 1), Reach));  // over a pole
  EXPECT_TRUE(known(-one, one, 0));                               // of one eye there is none
}
