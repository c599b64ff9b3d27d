// SPDX-License-Identifier: BSD-3-Clause
// The stereo models in double: closed forms, round trips, parallax, and an answer everywhere.
#include "Stereo/Comfort.h"
#include "Stereo/Stereo.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <limits>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Largest error of a round trip and of a closed form: radians, NDC, or relative to a distance.
constexpr double StereoRoundTrip = 1e-12;

ViewOptions OptionsOf(const char* model, Eye eye)
{
  ViewOptions o;
  o.Radii = { { 0.5, 20 } };
  o.Stereo.Model = FindStereoModel(model);
  o.Stereo.Eye = eye;
  return o;
}

// One eye in one projection, at its largest field of view.
View EyeOf(const Projection& p, const StereoOptions& stereo, double tilt = 0)
{
  ViewOptions o;
  o.HorizontalFov = std::max(std::min(360.0, p.MaxHorizontalFov), p.MinHorizontalFov);
  o.VerticalFov = std::max(std::min(180.0, p.MaxVerticalFov), p.MinVerticalFov);
  if (p.Axis == Family::Planar)
  {
    o.HorizontalFov = 100;
    o.VerticalFov = 70;
  }
  o.Radii = { { 0.5, 20 } };
  o.Tilt = tilt;
  o.Stereo = stereo;
  EXPECT_EQ(CheckOptions(p, o), "") << p.Name;
  return View(p, o);
}

// Every model with every projection it takes, both eyes, with and without a fade.
std::vector<NamedView> StereoViews()
{
  std::vector<NamedView> views;
  for (const StereoModel& model : StereoModels())
  {
    for (const Projection& p : Projections())
    {
      for (double tilt : { 0.0, 30.0 })
      {
        for (double fade : { 0.0, 40.0 })
        {
          StereoOptions s;
          s.Model = &model;
          s.PoleFade = { { fade, 2 * fade } };
          if (!model.Check(s, p).empty() || (fade > 0 && model.Traits.OneCenter))
          {
            continue;
          }
          for (Eye eye : { Eye::Left, Eye::Right })
          {
            s.Eye = eye;
            const std::string name = model.Name + " " + p.Name + " tilt " + std::to_string(tilt) +
              " fade " + std::to_string(fade) + " eye " + std::to_string(int(eye));
            views.push_back({ name, {}, EyeOf(p, s, tilt), false });
          }
        }
      }
    }
  }
  return views;
}

double AngleBetween(const vec3& a, const vec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// How far the point that RayAt gives back is from the one that was asked for, relative.
double TripOf(const View& view, const vec3& p, const NdcPoint& q)
{
  const ViewRay ray = view.RayAt(q.Ndc);
  const double rho = wfvDistanceAt(0.5 * (q.Ndc.z + 1), view.GetParameters());
  return glm::length(ray.Origin + ray.Direction * rho - p) / glm::length(p);
}
}

TEST(Stereo, ModelsAreThoseOfTheContract)
{
  for (const char* name : { "mono", "warped", "omnidirectional", "offaxis" })
  {
    ASSERT_NE(FindStereoModel(name), nullptr) << name;
  }
  EXPECT_EQ(FindStereoModel("cross-eyed"), nullptr);
  EXPECT_EQ(StereoModels().size(), 4u);
}

TEST(Stereo, MonoIsNoModelAtAll)
{
  const View with(*FindProjection("hammer"), OptionsOf("mono", Eye::Left));
  ViewOptions o;
  o.Radii = { { 0.5, 20 } };
  const View without(*FindProjection("hammer"), o);
  for (const vec3& d : RandomDirections(1000))
  {
    const vec3 p = d * 3.0;
    EXPECT_EQ(with.Forward(p).Ndc, without.Forward(p).Ndc);
    const vec2 ndc(with.Forward(p).Ndc.x, with.Forward(p).Ndc.y);
    EXPECT_EQ(with.Ray(ndc).Direction, without.Ray(ndc).Direction);
    EXPECT_EQ(with.Ray(ndc).Origin, vec3(0));
  }
}

TEST(Stereo, PointForwardRayAt)
{
  long count = 0;
  double worst = 0;
  for (const NamedView& v : StereoViews())
  {
    for (const vec3& d : RandomDirections(400))
    {
      for (double rho : { 0.7, 2.0, 19.0 })
      {
        const vec3 p = d * rho;
        const NdcPoint q = v.TheView.Forward(p);
        // within a degree of a pole, the antipode or a flat rim the map stretches its own rounding
        const vec3 m = wfvTilt(d, v.TheView.GetParameters());
        const bool rim = v.TheView.GetProjection().FlatRim && m.z > -0.1;
        const bool antipode = m.z > 0 && std::hypot(m.x, m.y) < 0.02;
        if (!q.Inside || std::hypot(m.x, m.z) < 0.02 || antipode || rim)
        {
          continue;
        }
        count++;
        const double error = TripOf(v.TheView, p, q);
        worst = std::max(worst, error);
        ASSERT_LE(error, StereoRoundTrip) << v.Name << " " << Text(p);
      }
    }
  }
  std::cout << count << " points, worst error " << worst << "\n";
  EXPECT_GT(count, 50000);
}

// The closed form, and that it is that of the tangents: the point lies on its ray.
TEST(Stereo, OmnidirectionalIsTheTangentOfTheCircle)
{
  const double r = 0.4;
  StereoOptions s;
  s.Model = FindStereoModel("omnidirectional");
  s.InterpupillaryDistance = 2 * r;
  for (double sign : { -1.0, 1.0 })
  {
    s.Eye = sign < 0 ? Eye::Left : Eye::Right;
    const View view = EyeOf(*FindProjection("equirectangular"), s);
    for (const vec3& direction : RandomDirections(2000))
    {
      const vec3 p = direction * 3.0;
      const double d = std::hypot(p.x, p.z);
      if (d < 1.01 * r)
      {
        continue;
      }
      const vec2 at(
        std::atan2(p.x, -p.z) - sign * std::asin(r / d), std::atan2(p.y, std::sqrt(d * d - r * r)));
      const vec2 ndc(std::remainder(at.x, 2 * WFV_PI) / WFV_PI, at.y / (0.5 * WFV_PI));
      const NdcPoint q = view.Forward(p);
      // the two borders of the picture are one meridian
      EXPECT_NEAR(std::remainder(q.Ndc.x - ndc.x, 2.0), 0, StereoRoundTrip) << Text(p);
      EXPECT_NEAR(q.Ndc.y, ndc.y, StereoRoundTrip) << Text(p);
      const ViewRay ray = view.Ray(vec2(q.Ndc.x, q.Ndc.y));
      const vec3 tangent = vec3(std::cos(at.x), 0, std::sin(at.x)) * (sign * r);
      EXPECT_LE(glm::length(ray.Origin - tangent), StereoRoundTrip) << Text(p);
      EXPECT_LE(AngleBetween(ray.Direction, p - tangent), 50 * StereoRoundTrip) << Text(p);
    }
  }
}

// Nearer points stand farther to the left for the right eye, in front, beside and behind,
// up to five degrees from the poles.
TEST(Stereo, OmnidirectionalDisparityHasOneSignAllRound)
{
  StereoOptions s;
  s.Model = FindStereoModel("omnidirectional");
  s.InterpupillaryDistance = 0.064;
  s.Eye = Eye::Left;
  const View left = EyeOf(*FindProjection("equirectangular"), s);
  s.Eye = Eye::Right;
  const View right = EyeOf(*FindProjection("equirectangular"), s);
  for (int lambda = -180; lambda < 180; lambda += 3)
  {
    for (int phi = -85; phi <= 85; phi += 5)
    {
      const vec3 d = wfvMeridianDirection(vec2(lambda, phi) * Degree);
      for (double rho : { 0.7, 1.0, 2.0, 10.0 })
      {
        const double flat = rho * std::cos(phi * Degree);
        const double parallax = left.Forward(d * rho).Ndc.x - right.Forward(d * rho).Ndc.x;
        const double expected = 2 * std::asin(0.032 / flat) / WFV_PI;
        EXPECT_NEAR(std::remainder(parallax, 2.0), expected, StereoRoundTrip)
          << lambda << " " << phi << " " << rho;
      }
    }
  }
}

TEST(Stereo, PoleFadeIsFullBelowAndNothingAbove)
{
  StereoOptions s;
  s.Model = FindStereoModel("omnidirectional");
  s.InterpupillaryDistance = 2;
  s.PoleFade = { { 30, 60 } };
  s.Eye = Eye::Right;
  const View view = EyeOf(*FindProjection("equirectangular"), s);
  const auto radius = [&](double phi) { return glm::length(view.Ray(vec2(0.3, phi / 90)).Origin); };
  for (double phi : { 0.0, 20.0, -29.9 })
  {
    EXPECT_NEAR(radius(phi), 1, StereoRoundTrip) << phi;
  }
  EXPECT_NEAR(radius(45), 0.5, StereoRoundTrip);
  for (double phi : { 60.1, -75.0, 89.0 })
  {
    EXPECT_EQ(radius(phi), 0) << phi;
  }
  // its slope has no step at either end
  const double h = 1e-4;
  for (double phi : { 30.0, 60.0 })
  {
    const double before = (radius(phi) - radius(phi - h)) / h;
    const double after = (radius(phi + h) - radius(phi)) / h;
    EXPECT_NEAR(before, after, 1e-5) << phi;
  }
  // what is overhead, inside the circle, is seen there
  EXPECT_TRUE(view.Forward(vec3(0.2, 3, 0.1)).Inside);
  EXPECT_FALSE(view.Forward(vec3(0.6, 0.1, 0.1)).Inside);
}

TEST(Stereo, PaperHasNoParallaxOnItsPlane)
{
  StereoOptions s; // the paper's defaults
  s.Model = FindStereoModel("warped");
  for (const char* name : { "equirectangular", "hammer", "azimuthal-equidistant" })
  {
    s.Eye = Eye::Left;
    const View left = EyeOf(*FindProjection(name), s);
    s.Eye = Eye::Right;
    const View right = EyeOf(*FindProjection(name), s);
    for (const vec3& d : RandomDirections(300))
    {
      for (double z : { -1.0, -0.8, 0.0, 1.0 })
      {
        const vec3 p = d * wfvDistanceAt(0.5 * (z + 1), left.GetParameters());
        const vec3 l = left.Forward(p).Ndc;
        const vec3 r = right.Forward(p).Ndc;
        // two centres of projection 0.5 apart, 5 in front of the plane z = -0.8
        const double expected = 0.5 * (z + 0.8) / (5 + z + 0.8);
        EXPECT_NEAR(r.x - l.x, expected, StereoRoundTrip) << name << " " << z;
        EXPECT_NEAR(r.y, l.y, StereoRoundTrip) << name << " " << z;
      }
    }
  }
}

TEST(Stereo, OffAxisParallaxIsThatOfTheTalk)
{
  const Projection& p = *FindProjection("perspective");
  StereoOptions s;
  s.Model = FindStereoModel("offaxis");
  s.Separation = 0.05;
  s.Convergence = 4;
  s.Eye = Eye::Left;
  const View left = EyeOf(p, s);
  s.Eye = Eye::Right;
  const View right = EyeOf(p, s);
  for (double w : { 1.0, 2.0, 4.0, 8.0, 1e9 })
  {
    const vec3 q(0.1 * w, -0.2 * w, -w);
    const double parallax = 0.5 * (right.Forward(q).Ndc.x - left.Forward(q).Ndc.x);
    EXPECT_NEAR(parallax, 0.05 * (1 - 4 / w), StereoRoundTrip) << w;
    EXPECT_NEAR(right.Forward(q).Ndc.y, left.Forward(q).Ndc.y, StereoRoundTrip) << w;
  }
}

TEST(Stereo, ComfortIsThatOfTheModels)
{
  EXPECT_DOUBLE_EQ(Parallax(0.03, 4, 2), -3);
  EXPECT_DOUBLE_EQ(Parallax(0.03, 4, 4), 0);
  EXPECT_NEAR(Parallax(0.03, 4, 1e15), 3, StereoRoundTrip);
  // of a screen 2 wide seen from 1, one per cent is 0.02 across
  EXPECT_NEAR(ParallaxAngle(1, 2, 1), 2 * std::atan(0.01) / Degree, StereoRoundTrip);
  EXPECT_DOUBLE_EQ(CircleDisparity(0.065, 0.065), 60);
  EXPECT_DOUBLE_EQ(CircleDisparity(0.065, 0.03), 180);
  const std::array<double, 2> budget = DepthBudget(3);
  EXPECT_DOUBLE_EQ(budget[0], 1.5);
  EXPECT_DOUBLE_EQ(budget[1], 300);
  EXPECT_DOUBLE_EQ(LargestSeparation(1.3, 0.065), 0.05);
  EXPECT_DOUBLE_EQ(LargestSeparation(0.05, 0.065), 0.5);
  EXPECT_DOUBLE_EQ(ComfortableEyeDistance(0.75), 0.065);
  EXPECT_NEAR(CircleDisparity(ComfortableEyeDistance(40), 40), 4.97, 0.005); // of 40 parsecs, too
  EXPECT_NEAR(LargestDisparity(), 7.45, 0.005);
}

TEST(Stereo, ConvergenceKeepsWhatIsSeenInTheBudget)
{
  std::vector<double> even(1001);
  std::generate(even.begin(), even.end(), [d = 2 - 0.006]() mutable { return d += 0.006; });
  EXPECT_NEAR(ConvergenceFor(even), 4.12, 1e-9); // twice the nearest of 99 per cent
  std::vector<double> far = even;
  std::fill(far.begin(), far.begin() + 300, 5000); // a hundredth of the farthest
  EXPECT_NEAR(ConvergenceFor(far), 2 * 3.86, 0.1);
  std::vector<double> close(1000, 50);
  close[3] = 0.01; // a leaf before the lens
  EXPECT_DOUBLE_EQ(ConvergenceFor(close), 50);
  EXPECT_DOUBLE_EQ(ConvergenceFor({}), 0);
  std::fill_n(std::fill_n(close.begin(), 600, 1), 400, 1000);
  EXPECT_DOUBLE_EQ(ConvergenceFor(close), 2); // both cannot be: the nearest counts
}

TEST(Stereo, BothEyesOfNoDistanceAreMono)
{
  for (const char* name : { "warped", "omnidirectional" })
  {
    ViewOptions o = OptionsOf(name, Eye::Right);
    o.Stereo.Iod = 0;
    o.Stereo.Offset = -1;
    o.Stereo.Distance = 1e6;
    o.Stereo.InterpupillaryDistance = 0;
    const View view(*FindProjection("mollweide"), o);
    o.Stereo.Model = nullptr;
    const View mono(*FindProjection("mollweide"), o);
    for (const vec3& d : RandomDirections(300))
    {
      EXPECT_LE(glm::length(view.Forward(d * 4.0).Ndc - mono.Forward(d * 4.0).Ndc), 5e-6);
    }
  }
}

TEST(Stereo, AnswersEverywhere)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> sizes{ 0, 1e-300, 0.03, 0.0325, 1, -1, 1e30, infinity };
  for (const NamedView& v : StereoViews())
  {
    for (double x : sizes)
    {
      for (double y : sizes)
      {
        for (double z : { 0.0, -0.0325, 1.0, -1e30 })
        {
          const vec3 ndc = v.TheView.Forward(vec3(x, y, z)).Ndc;
          EXPECT_FALSE(std::isnan(ndc.x) || std::isnan(ndc.y)) << v.Name << Text(vec3(x, y, z));
          const ViewRay ray = v.TheView.RayAt(vec3(x, y, z));
          EXPECT_NEAR(glm::length(ray.Direction), 1, StereoRoundTrip)
            << v.Name << Text(vec3(x, y, z));
          EXPECT_TRUE(std::isfinite(glm::length(ray.Origin))) << v.Name << Text(vec3(x, y, z));
        }
      }
    }
  }
}

TEST(Stereo, WhatDoesNotFitIsRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Projection& wide = *FindProjection("hammer");
  const Projection& flat = *FindProjection("perspective");
  const auto refused = [](const char* model, const Projection& p, auto change) {
    ViewOptions o = OptionsOf(model, Eye::Left);
    o.HorizontalFov = o.VerticalFov = 90;
    change(o.Stereo);
    return !CheckOptions(p, o).empty();
  };
  const auto same = [](StereoOptions&) {};
  EXPECT_FALSE(refused("omnidirectional", wide, same));
  EXPECT_FALSE(refused("warped", wide, same));
  EXPECT_FALSE(refused("offaxis", flat, same));
  EXPECT_TRUE(refused("offaxis", wide, same));
  EXPECT_TRUE(refused("omnidirectional", flat, same));
  for (double bad : { nan, -1.0, std::numeric_limits<double>::infinity() })
  {
    const auto ipd = [=](StereoOptions& s) { s.InterpupillaryDistance = bad; };
    EXPECT_TRUE(refused("omnidirectional", wide, ipd));
    EXPECT_TRUE(refused("warped", wide, [=](StereoOptions& s) { s.Iod = bad; }));
    EXPECT_TRUE(refused("offaxis", flat, [=](StereoOptions& s) { s.Separation = bad; }));
    EXPECT_TRUE(refused("offaxis", flat, [=](StereoOptions& s) { s.Convergence = bad; }));
  }
  EXPECT_TRUE(refused("warped", wide, [](StereoOptions& s) { s.Distance = 0.1; }));
  EXPECT_TRUE(refused("warped", wide, [](StereoOptions& s) { s.Offset = 1.5; }));
  EXPECT_TRUE(refused("omnidirectional", wide, [](StereoOptions& s) {
    s.PoleFade = { { 50, 40 } };
  }));
}
