// SPDX-License-Identifier: BSD-3-Clause
// Where the fields of view end in the picture.
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr double CornerRounding = 1e-12; // NDC

const double Fovs[] = { 0.01, 1, 45, 60, 120, 178.5, 180, 270, 359.99, 360 };
const double Aspects[] = { 0.25, 0.5, 1, 4.0 / 3, 2, 7 };
}

TEST(Normalization, FieldsOfViewEndAtTheBorders)
{
  for (const Projection& p : Projections())
  {
    if (p.Axis == Family::Azimuthal || p.Axis == Family::Faces)
    {
      continue;
    }
    for (double hfov : Fovs)
    {
      for (double vfov : Fovs)
      {
        ViewOptions o;
        o.HorizontalFov = hfov;
        o.VerticalFov = vfov;
        if (!CheckOptions(p, o).empty())
        {
          continue;
        }
        const View view(p, o);
        // 180 degrees itself is the seam: just before it
        const double lambda = 0.5 * hfov * Degree * (hfov == 360 ? 1 - 1e-14 : 1);
        const double phi = 0.5 * vfov * Degree;
        SCOPED_TRACE(MakeView(p, o).Name);
        const vec3 right = view.Forward(wfvMeridianDirection(vec2(lambda, 0))).Ndc;
        EXPECT_NEAR(right.x, 1, CornerRounding);
        EXPECT_NEAR(right.y, 0, CornerRounding);
        EXPECT_NEAR(view.Forward(wfvMeridianDirection(vec2(-lambda, 0))).Ndc.x, -1, CornerRounding);
        const vec3 top = view.Forward(wfvMeridianDirection(vec2(0, phi))).Ndc;
        EXPECT_NEAR(top.x, 0, CornerRounding);
        EXPECT_NEAR(top.y, 1, CornerRounding);
        EXPECT_NEAR(view.Forward(wfvMeridianDirection(vec2(0, -phi))).Ndc.y, -1, CornerRounding);
      }
    }
  }
}

TEST(Normalization, EquirectangularIsLinear)
{
  ViewOptions o;
  o.HorizontalFov = 200;
  o.VerticalFov = 70;
  const View view(*FindProjection("equirectangular"), o);
  for (double lambda : { -170.0, -33.0, 0.0, 12.5, 100.0 })
  {
    for (double phi : { -80.0, -1.0, 0.0, 35.0 })
    {
      const vec3 d = wfvMeridianDirection(vec2(lambda, phi) * Degree);
      const vec3 ndc = view.Forward(d).Ndc;
      EXPECT_NEAR(ndc.x, 2 * lambda / 200, CornerRounding);
      EXPECT_NEAR(ndc.y, 2 * phi / 70, CornerRounding);
    }
  }
}

TEST(Normalization, RoundMapsStayRoundAndTouchTheNearerBorders)
{
  for (const Projection& p : Projections())
  {
    if (p.Axis != Family::Azimuthal)
    {
      continue;
    }
    for (double fov : Fovs)
    {
      for (double aspect : Aspects)
      {
        ViewOptions o;
        o.HorizontalFov = fov;
        o.VerticalFov = std::min(fov, p.MaxVerticalFov);
        o.Aspect = aspect;
        if (!CheckOptions(p, o).empty())
        {
          continue;
        }
        const View view(p, o);
        const double theta = 0.5 * fov * Degree * (1 - 1e-14);
        for (int i = 0; i < 16; ++i)
        {
          const double a = 2 * WFV_PI * i / 16;
          const vec3 ndc = view.Forward(wfvAzimuthalDirection(vec2(a, theta))).Ndc;
          // in units of half the shorter side of the viewport
          const double x = ndc.x * std::max(1.0, aspect);
          const double y = ndc.y * std::max(1.0, 1 / aspect);
          EXPECT_NEAR(x, std::cos(a), CornerRounding) << MakeView(p, o).Name;
          EXPECT_NEAR(y, std::sin(a), CornerRounding) << MakeView(p, o).Name;
        }
      }
    }
  }
}

TEST(Normalization, LensIsThePolynomial)
{
  ViewOptions o;
  o.HorizontalFov = 180;
  o.Aspect = 1;
  const Projection& fisheye = *FindProjection("azimuthal-equidistant");
  for (const auto& c : Lenses(fisheye, 180))
  {
    o.Lens = c;
    const View view(fisheye, o);
    for (double t = 0; t <= 0.5 * WFV_PI; t += 0.01)
    {
      double r = 0;
      for (std::size_t i = 0; i < c.size(); i++)
      {
        r += c[i] * std::pow(t, i + 1.0);
      }
      EXPECT_NEAR(view.Forward(wfvAzimuthalDirection(vec2(0.0, t))).Ndc.x, r, CornerRounding);
    }
  }
}

// Always the whole picture: the middle of the faces, and where the rows end.
TEST(Normalization, FacesFillThePicture)
{
  const Projection& p = *FindProjection("equi-angular-cubemap");
  const View view(p, ViewOptions());
  const std::pair<vec3, vec2> places[] = { { vec3(-1, 0, 0), vec2(-2. / 3, 0.5) },
    { vec3(0, 0, -1), vec2(0, 0.5) }, { vec3(1, 0, 0), vec2(2. / 3, 0.5) },
    { vec3(0, -1, 0), vec2(-2. / 3, -0.5) }, { vec3(0, 0, 1), vec2(0, -0.5) },
    { vec3(0, 1, 0), vec2(2. / 3, -0.5) } };
  for (const auto& place : places)
  {
    const vec3 ndc = view.Forward(place.first).Ndc;
    EXPECT_NEAR(ndc.x, place.second.x, CornerRounding) << Text(place.first);
    EXPECT_NEAR(ndc.y, place.second.y, CornerRounding) << Text(place.first);
  }
  EXPECT_NEAR(view.Ray(vec2(1, 1)).Direction.y, std::sqrt(1. / 3), CornerRounding);
  EXPECT_NEAR(view.Ray(vec2(-1, 1)).Direction.z, std::sqrt(1. / 3), CornerRounding);
}

TEST(Normalization, TiltRaisesTheAxis)
{
  for (const Projection& p : Projections())
  {
    if (p.Axis == Family::Faces)
    {
      continue; // the axis is in the middle of one of six faces
    }
    ViewOptions o;
    o.HorizontalFov = 90;
    o.VerticalFov = 90;
    for (double tilt : { -120.0, -30.0, 0.0, 45.0, 90.0 })
    {
      o.Tilt = tilt;
      const View view(p, o);
      const vec3 axis(0, std::sin(tilt * Degree), -std::cos(tilt * Degree));
      const vec3 ndc = view.Forward(axis).Ndc;
      EXPECT_NEAR(ndc.x, 0, CornerRounding) << p.Name << " " << tilt;
      EXPECT_NEAR(ndc.y, 0, CornerRounding) << p.Name << " " << tilt;
      EXPECT_NEAR(glm::length(view.Ray(vec2(0, 0)).Direction - axis), 0, CornerRounding) << p.Name;
    }
  }
}
