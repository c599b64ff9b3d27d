// SPDX-License-Identifier: BSD-3-Clause
// What options a projection takes, what it says to the others, and which lenses grow.
#include "Views.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

ViewOptions Small()
{
  ViewOptions o;
  o.HorizontalFov = 90;
  o.VerticalFov = 60;
  return o;
}

// The same, or what the projection has nearest to it.
ViewOptions SmallFor(const Projection& p)
{
  ViewOptions o = Small();
  o.HorizontalFov = std::max(o.HorizontalFov, p.MinHorizontalFov);
  o.VerticalFov = std::max(o.VerticalFov, p.MinVerticalFov);
  return o;
}

// One message, no line break, that names all of these.
void ExpectRefused(const Projection& p, const ViewOptions& o, const std::vector<std::string>& words)
{
  const std::string message = CheckOptions(p, o);
  EXPECT_FALSE(message.empty()) << p.Name;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  for (const std::string& word : words)
  {
    EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' in: " << message;
  }
}
}

TEST(Options, RegistryIsConsistent)
{
  std::set<std::string> names;
  for (const Projection& p : Projections())
  {
    EXPECT_TRUE(names.insert(p.Name).second) << p.Name;
    EXPECT_EQ(FindProjection(p.Name), &p);
    EXPECT_FALSE(p.Title.empty()) << p.Name;
    ASSERT_TRUE(p.Map && p.Project && p.Unproject && p.Bounds) << p.Name;
    EXPECT_NE(p.Glsl.find("wfvProject"), std::string::npos) << p.Name;
  }
  for (const char* name : { "equirectangular", "cylindrical-equal-area", "miller", "mercator",
         "central-cylindrical", "mollweide", "sinusoidal", "eckert-iv", "winkel-tripel", "aitoff",
         "hammer", "panini", "azimuthal-equidistant", "azimuthal-equal-area", "stereographic",
         "orthographic", "gnomonic", "brown-conrady", "equi-angular-cubemap", "perspective" })
  {
    EXPECT_EQ(names.count(name), 1u) << name;
  }
  EXPECT_EQ(FindProjection(""), nullptr);
  EXPECT_EQ(FindProjection("Hammer"), nullptr);
  EXPECT_EQ(FindProjection("no such projection"), nullptr);
}

TEST(Options, FieldsOfViewHaveARange)
{
  for (const Projection& p : Projections())
  {
    EXPECT_EQ(CheckOptions(p, SmallFor(p)), "") << p.Name;
    for (double bad : { 0.0, -1.0, p.MaxHorizontalFov * 1.001, NaN, Infinite, -Infinite })
    {
      ViewOptions o = SmallFor(p);
      o.HorizontalFov = bad;
      ExpectRefused(p, o, { "horizontal", p.Name, "degrees" });
    }
    for (double bad : { 0.0, -1.0, p.MaxVerticalFov * 1.001, NaN, Infinite })
    {
      ViewOptions o = SmallFor(p);
      o.VerticalFov = bad;
      ExpectRefused(p, o, { "vertical", p.Name, "degrees" });
    }
    ViewOptions o = SmallFor(p);
    o.HorizontalFov = p.MaxHorizontalFov;
    o.VerticalFov = p.MaxVerticalFov;
    EXPECT_EQ(CheckOptions(p, o), "") << p.Name;
  }
}

TEST(Options, RefusalsNameTheValues)
{
  const Projection& p = *FindProjection("hammer");
  ViewOptions o = Small();
  o.HorizontalFov = 361.5;
  ExpectRefused(p, o, { "360", "361.5" });
  o = Small();
  o.Radii = { { 3, 2 } };
  ExpectRefused(p, o, { "clip", "near", "far", "3", "2" });
}

// What a map cannot show is refused with the reason.
TEST(Options, LimitsAreExplained)
{
  const Projection& mercator = *FindProjection("mercator");
  ViewOptions o = Small();
  o.VerticalFov = 2 * 90; // a latitude limit of 90 degrees
  ExpectRefused(mercator, o, { "vertical", "mercator", "170.1", "180", "poles", "infinitely" });
  o = Small();
  ExpectRefused(
    *FindProjection("equi-angular-cubemap"), o, { "must be 360", "90", "whole sphere" });
  o.HorizontalFov = 181;
  ExpectRefused(*FindProjection("orthographic"), o, { "180", "181", "half sphere" });
  o.HorizontalFov = 321;
  ExpectRefused(*FindProjection("stereographic"), o, { "320", "321", "antipode" });
  ExpectRefused(*FindProjection("gnomonic"), o, { "160", "321", "infinitely" });
  ExpectRefused(*FindProjection("panini"), o, { "320", "321", "infinity" });
}

TEST(Options, TiltAndRadii)
{
  for (const Projection& p : Projections())
  {
    for (double bad : { NaN, Infinite, -Infinite })
    {
      ViewOptions o = SmallFor(p);
      o.Tilt = bad;
      ExpectRefused(p, o, { "tilt" });
    }
    const std::array<double, 2> bad[] = { { { 0, 1 } }, { { -1, 1 } }, { { 1, 1 } }, { { 2, 1 } },
      { { NaN, 1 } }, { { 1, NaN } }, { { 1, Infinite } } };
    for (const auto& radii : bad)
    {
      ViewOptions o = SmallFor(p);
      o.Radii = radii;
      ExpectRefused(p, o, { "clip" });
    }
  }
}

TEST(Options, Lens)
{
  ViewOptions o = Small();
  o.Lens = Lenses(*FindProjection("azimuthal-equidistant"), 180)[0];
  for (const Projection& p : Projections())
  {
    o.HorizontalFov = std::min(180.0, p.MaxHorizontalFov);
    if (p.HasLens)
    {
      EXPECT_EQ(CheckOptions(p, o), "") << p.Name;
    }
    else if (p.MaxHorizontalFov >= 180 && p.MinHorizontalFov == 0)
    {
      ExpectRefused(p, o, { p.Name, "lens" });
    }
  }
  o.HorizontalFov = 180;
  const Projection& fisheye = *FindProjection("azimuthal-equidistant");
  // c1 0: the slope is 0 on the axis; sin turns round at 90 degrees; falling at once
  const LensCoefficients bad[] = { { { 0, 1, 0, 0, 0 } }, { { 1, 0, -0.3, 0, 0 } },
    { { -1, 0, 0, 0, 0 } }, { { NaN, 0, 0, 0, 0 } }, { { 1, Infinite, 0, 0, 0 } } };
  for (const auto& lens : bad)
  {
    o.Lens = lens;
    ExpectRefused(fisheye, o, { "lens", "grow" });
  }
}

TEST(Lens, MonotoneIsDecidedUpToTheRim)
{
  // r = t - t^3 / 3 has its top at t = 1
  const LensCoefficients lens{ { 1, 0, -1.0 / 3, 0, 0 } };
  EXPECT_TRUE(LensIsMonotone(lens, 0.99));
  EXPECT_FALSE(LensIsMonotone(lens, 1.01));
  EXPECT_TRUE(LensIsMonotone({ { 1, 0, 0, 0, 0 } }, WFV_PI));
  EXPECT_FALSE(LensIsMonotone({ { 0, 0, 0, 0, 0 } }, WFV_PI));
  EXPECT_FALSE(LensIsMonotone({ { -1, 0, 0, 0, 0 } }, WFV_PI));
}

// A slope with a dip of given width: (t - m)^2 - w^2 is negative for w round m.
TEST(Lens, NarrowDipsAreFound)
{
  for (double m : { 0.3, 1.0, 1.5, 2.9 })
  {
    for (double w : { 0.1, 0.01, 0.001 })
    {
      const LensCoefficients lens{ { m * m - w * w, -m, 1.0 / 3, 0, 0 } };
      EXPECT_FALSE(LensIsMonotone(lens, WFV_PI)) << "dip at " << m << " of width " << w;
      const LensCoefficients lifted{ { m * m + w * w, -m, 1.0 / 3, 0, 0 } };
      EXPECT_TRUE(LensIsMonotone(lifted, WFV_PI)) << "lifted dip at " << m;
    }
  }
}

// What is called monotone can be inverted: theta comes back from r.
RC_GTEST_PROP(Lens, MonotoneOnesInvert, ())
{
  // the shares of the five terms in the radius at the rim
  const auto c = *rc::gen::container<std::vector<int>>(5, rc::gen::inRange(0, 41));
  ViewOptions o;
  o.HorizontalFov = *rc::gen::inRange(1, 361);
  o.Aspect = 1;
  const double rim = 0.5 * o.HorizontalFov * Degree;
  for (int i = 0; i < 5; ++i)
  {
    const double share = (c[i] % 2 ? -1 : 1) * c[i] / 200.0;
    o.Lens[i] = ((i == 0 ? 0.6 : 0) + share) / std::pow(rim, i + 1);
  }
  const Projection& p = *FindProjection("azimuthal-equidistant");
  RC_PRE(CheckOptions(p, o).empty());
  const View view(p, o);
  const double theta = view.GetParameters().maxAngle * *rc::gen::inRange(0, 1001) / 1000.0;
  const vec3 d = wfvAzimuthalDirection(vec2(0.7, theta));
  const vec3 ndc = view.Forward(d).Ndc;
  const vec3 back = view.Forward(view.Ray(vec2(ndc.x, ndc.y)).Direction).Ndc;
  // compared in the picture, where a nearly flat lens is not ill-conditioned
  RC_ASSERT(glm::length(back - ndc) < 1e-12 * std::max(1.0, glm::length(ndc)));
}
