// SPDX-License-Identifier: BSD-3-Clause
// PROJ as an independent witness of every formula it knows.
#include "Views.h"

#include <gtest/gtest.h>
#include <proj.h>

#include <algorithm>
#include <limits>
#include <memory>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Largest difference, in units of the sphere's radius: 0.06 mm on the Earth.
constexpr double ProjAgreement = 1e-11;

constexpr double Radius = 6.4e6; // metres

// The longitude handed to PROJ is rounded, and near the antipode a round map stretches
// that by the half circumference over the sine of the distance to it.
constexpr double LongitudeRounding = 2 * std::numeric_limits<double>::epsilon();

struct Counterpart
{
  const char* Projection;
  const char* Proj;
  const char* Sphere; // the same by PROJ's formula for the sphere
  double Fov;         // degrees
  bool TearsAtAntipode;
  double MaxLatitude = 90; // degrees: up to where PROJ's own solver ends within `ProjAgreement`
  double MinAngle = 0;     // radians: how near the centre or the antipode PROJ's formula holds
};

// PROJ ends its iterations for these two at steps of 1e-7, and beside the poles, where
// Newton's steps become slow, after a fixed number of them; there IndependentTest.cxx looks.
constexpr double MollweideEnd = 88;
constexpr double EckertEnd = 85;

// Radians from the centre (Aitoff, Winkel tripel: acos of a cosine) or the antipode
// (azimuthal equal-area: one plus a cosine) inside which PROJ's formula for the sphere loses
// the digits asked for; there IndependentTest.cxx looks.
constexpr double NearCentre = 1e-4;
constexpr double NearAntipode = 1e-2;

const Counterpart Counterparts[] = {
  { "equirectangular", "+proj=eqc", "+proj=eqc", 360, false },
  { "cylindrical-equal-area", "+proj=cea", "+proj=cea", 360, false },
  { "miller", "+proj=mill", "+proj=mill", 360, false },
  { "mercator", "+proj=merc", "+proj=merc", 360, false },
  { "central-cylindrical", "+proj=cc", "+proj=cc", 360, false },
  { "mollweide", "+proj=moll", "+proj=moll", 360, false, MollweideEnd },
  { "sinusoidal", "+proj=sinu", "+proj=sinu", 360, false },
  { "eckert-iv", "+proj=eck4", "+proj=eck4", 360, false, EckertEnd },
  { "winkel-tripel", "+proj=wintri", "+proj=wintri", 360, false, 90, NearCentre },
  { "aitoff", "+proj=aitoff", "+proj=aitoff", 360, false, 90, NearCentre },
  { "azimuthal-equal-area", "+proj=laea", "+proj=laea", 360, false, 90, NearAntipode },
  { "stereographic", "+proj=stere", "+proj=stere", 320, false },
  { "orthographic", "+proj=ortho", "+proj=ortho", 180, false },
  { "gnomonic", "+proj=gnom", "+proj=gnom", 160, false },
  { "brown-conrady", "+proj=gnom", "+proj=gnom", 160, false }, // without a lens
  { "hammer", "+proj=hammer", "+proj=hammer", 360, false },
  // a flattening below double's epsilon makes PROJ solve for geodesics: its formula for the
  // sphere goes through acos and loses half the digits near the axis and the antipode
  { "azimuthal-equidistant", "+proj=aeqd +rf=1e17", "+proj=aeqd", 360, true },
  { "perspective", "+proj=gnom", "+proj=gnom", 90, false },
};

struct ContextDeleter
{
  void operator()(PJ_CONTEXT* c) const { proj_context_destroy(c); }
};
struct PjDeleter
{
  void operator()(PJ* p) const { proj_destroy(p); }
};

class Oracle
{
public:
  explicit Oracle(const Counterpart& c)
    : Context(proj_context_create())
    , Map(proj_create(this->Context.get(),
        (std::string(c.Proj) + " +a=" + std::to_string(Radius) + " +lat_0=0 +lon_0=0").c_str()))
  {
    // its complaints about points outside are what the checks look for
    proj_log_level(this->Context.get(), PJ_LOG_NONE);
  }

  // (lambda, phi) to the plane, radii. False where PROJ refuses.
  bool Forward(const vec2& angles, vec2& xy)
  {
    proj_errno_reset(this->Map.get());
    const PJ_COORD c = proj_trans(this->Map.get(), PJ_FWD, proj_coord(angles.x, angles.y, 0, 0));
    xy = vec2(c.xy.x / Radius, c.xy.y / Radius);
    return proj_errno(this->Map.get()) == 0 && std::isfinite(xy.x);
  }

  bool Inverse(const vec2& xy, vec2& angles)
  {
    proj_errno_reset(this->Map.get());
    const PJ_COORD c =
      proj_trans(this->Map.get(), PJ_INV, proj_coord(xy.x * Radius, xy.y * Radius, 0, 0));
    angles = vec2(c.lp.lam, c.lp.phi);
    return proj_errno(this->Map.get()) == 0 && std::isfinite(angles.x);
  }

  explicit operator bool() const { return this->Map != nullptr; }

private:
  std::unique_ptr<PJ_CONTEXT, ContextDeleter> Context;
  std::unique_ptr<PJ, PjDeleter> Map;
};

View ViewOf(const Counterpart& c)
{
  const Projection& p = *FindProjection(c.Projection);
  ViewOptions o;
  o.HorizontalFov = c.Fov;
  o.VerticalFov = std::min(c.Fov, p.MaxVerticalFov);
  o.Aspect = 1;
  return View(p, o);
}

// The place in the plane of a unit sphere.
vec2 Plane(const View& view, const vec3& direction)
{
  const vec3 ndc = view.Forward(direction).Ndc;
  const vec2 scale = view.GetParameters().scale;
  return vec2(ndc.x / scale.x, ndc.y / scale.y);
}

double Sine(const vec3& d)
{
  return std::hypot(d.x, d.y);
}

// The sphere in a circle or an ellipse, outside of which PROJ refuses to answer (it does
// answer for aitoff).
bool IsRound(const Projection& p)
{
  return p.Name == "hammer" || p.Name == "mollweide" ||
    (p.Axis == Family::Azimuthal && p.Limit.empty());
}
}

class Proj : public ::testing::TestWithParam<Counterpart>
{
};

TEST_P(Proj, AgreesForward)
{
  const Counterpart& c = GetParam();
  Oracle oracle(c);
  ASSERT_TRUE(oracle);
  const View view = ViewOf(c);
  double worst = 0;
  std::string where;
  long count = 0;
  for (const vec3& d : ManyDirections())
  {
    const vec2 angles = wfvMeridianAngles(d);
    vec2 xy;
    // the seam itself may be drawn on either side
    const bool seam = std::abs(angles.x) > WFV_PI - 1e-10;
    const bool slow = std::abs(angles.y) > c.MaxLatitude * Degree || Sine(d) < c.MinAngle;
    if (seam || slow || !InDomain(view, d) || !oracle.Forward(angles, xy))
    {
      continue;
    }
    ++count;
    const vec2 ours = Plane(view, d);
    const double size = std::max(1.0, glm::length(xy)); // the gnomonic plane has no end
    const double rounding = c.TearsAtAntipode && d.z > 0 ? LongitudeRounding * WFV_PI / Sine(d) : 0;
    const double error = glm::length(ours - xy) / size - rounding;
    if (!(error <= worst))
    {
      worst = error;
      where = Text(d) + " ours " + Text(ours) + " PROJ " + Text(xy);
    }
  }
  std::cout << c.Projection << ": " << count << " directions, worst " << worst << " radii at "
            << where << "\n";
  EXPECT_GT(count, 8000);
  EXPECT_LE(worst, ProjAgreement) << where;
}

TEST_P(Proj, AgreesInverse)
{
  const Counterpart& c = GetParam();
  Oracle oracle(c);
  ASSERT_TRUE(oracle);
  const View view = ViewOf(c);
  const vec2 scale = view.GetParameters().scale;
  double worst = 0;
  std::string where;
  long count = 0;
  for (int i = 0; i <= 200; ++i)
  {
    for (int j = 0; j <= 200; ++j)
    {
      const vec2 ndc(i / 100.0 - 1, j / 100.0 - 1);
      vec2 angles;
      const ViewRay ray = view.Ray(ndc);
      // a direction at the border may be on either side for PROJ
      const bool rim = !view.Ray(ndc * (1 + 1e-6)).Inside;
      if (!ray.Inside || rim || !oracle.Inverse(vec2(ndc.x / scale.x, ndc.y / scale.y), angles))
      {
        continue;
      }
      ++count;
      const double error = glm::length(wfvMeridianDirection(angles) - ray.Direction);
      if (!(error <= worst))
      {
        worst = error;
        where = Text(ndc) + " ours " + Text(ray.Direction) + " PROJ angles " + Text(angles);
      }
    }
  }
  std::cout << c.Projection << ": " << count << " points, worst " << worst << " rad at " << where
            << "\n";
  EXPECT_GT(count, 20000);
  EXPECT_LE(worst, ProjAgreement) << where;
}

// Round maps: PROJ's spherical formulas refuse what lies half a radius outside; the view
// tells the border to a millionth.
TEST(ProjRefuses, OutsideOfRoundMaps)
{
  for (const Counterpart& c : Counterparts)
  {
    if (!IsRound(*FindProjection(c.Projection)))
    {
      continue;
    }
    Oracle oracle({ c.Projection, c.Sphere, c.Sphere, c.Fov, c.TearsAtAntipode });
    ASSERT_TRUE(oracle);
    const View view = ViewOf(c);
    const vec2 scale = view.GetParameters().scale;
    for (int i = 0; i < 64; ++i)
    {
      const double a = 2 * WFV_PI * i / 64;
      for (double r : { 0.9, 1 - 1e-6, 1 + 1e-6, 1.5 })
      {
        const vec2 ndc(r * std::cos(a), r * std::sin(a));
        EXPECT_EQ(view.Ray(ndc).Inside, r < 1) << c.Projection << " " << Text(ndc);
        vec2 angles;
        if (std::abs(r - 1) > 0.01)
        {
          const bool proj = oracle.Inverse(vec2(ndc.x / scale.x, ndc.y / scale.y), angles);
          EXPECT_EQ(proj, r < 1) << c.Projection << " PROJ " << Text(ndc);
        }
      }
    }
  }
}

// No latitude above 90 degrees.
TEST(ProjRefuses, BeyondThePoles)
{
  Oracle oracle(Counterparts[0]);
  const View view = ViewOf(Counterparts[0]);
  for (double beyond : { 1e-6, 0.1 })
  {
    vec2 xy;
    EXPECT_FALSE(oracle.Forward(vec2(0.3, 0.5 * WFV_PI * (1 + beyond)), xy));
    EXPECT_FALSE(view.Ray(vec2(0.3, 1 + beyond)).Inside);
    EXPECT_TRUE(oracle.Forward(vec2(0.3, 0.5 * WFV_PI * (1 - beyond)), xy));
    EXPECT_TRUE(view.Ray(vec2(0.3, 1 - beyond)).Inside);
  }
}

// Nothing behind a planar eye.
TEST(ProjRefuses, BehindThePlanarEye)
{
  for (const Counterpart& c : Counterparts)
  {
    if (FindProjection(c.Projection)->Axis != Family::Planar)
    {
      continue;
    }
    Oracle oracle(c);
    const View view = ViewOf(c);
    for (const vec3& d : { vec3(0, 0, 1), vec3(0.6, 0, 0.8), vec3(0, -0.8, 0.6) })
    {
      vec2 xy;
      EXPECT_FALSE(oracle.Forward(wfvMeridianAngles(d), xy)) << Text(d);
      EXPECT_FALSE(view.Forward(d).Inside) << Text(d);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Proj, ::testing::ValuesIn(Counterparts),
  [](const ::testing::TestParamInfo<Counterpart>& info) {
    std::string name = info.param.Projection;
    name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
    return name;
  });

// A projection added to the registry needs its witness here, or in IndependentTest.cxx.
TEST(ProjCoverage, EveryProjectionHasAWitness)
{
  for (const Projection& p : Projections())
  {
    bool found = p.Name == "panini" || p.Name == "equi-angular-cubemap";
    for (const Counterpart& c : Counterparts)
    {
      found = found || p.Name == c.Projection;
    }
    EXPECT_TRUE(found) << p.Name;
  }
}
