// SPDX-License-Identifier: BSD-3-Clause
// The bounds in the map of a rectangle of angles hold everything that it maps to, and
// little else.
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
// A corner of the bounds and a point mapped to it are two roundings of one value.
constexpr double BoundsRounding = 1e-12; // relative to the picture, NDC

// Samples along each side of a rectangle of angles, and the part of the size of the
// bounds that the extremes between samples may be missed by.
constexpr int Samples = 24;
constexpr double BoundsSlack = 0.02;

struct Sampled
{
  vec2 Low{ 1e300 };
  vec2 High{ -1e300 };
  void Add(const vec2& p)
  {
    this->Low = glm::min(this->Low, p);
    this->High = glm::max(this->High, p);
  }
};

// Angles a rectangle may reach: all of the domain of the map.
vec4 DomainOf(const View& view)
{
  const double a = view.GetParameters().maxAngle;
  switch (view.GetProjection().Axis)
  {
    case Family::Azimuthal:
      return vec4(-WFV_PI, 0, WFV_PI, a);
    case Family::Planar:
      return vec4(-a, -view.GetParameters().halfFov.y, a, view.GetParameters().halfFov.y);
    default:
    {
      const Projection& p = view.GetProjection();
      const vec2 half(0.5 * p.MaxHorizontalFov * Degree, 0.5 * p.MaxVerticalFov * Degree);
      return vec4(-half.x, -half.y, half.x, half.y);
    }
  }
}

// Random, with corners that like to lie on the borders, the axes and each other.
vec4 RandomRectangle(const vec4& domain, std::mt19937_64& engine)
{
  std::uniform_real_distribution<double> unit(0, 1);
  const auto pick = [&](double low, double high) {
    const double t = unit(engine);
    const double special[] = { low, high, 0.5 * (low + high), low + 0.25 * (high - low) };
    return t < 0.3 ? special[int(t / 0.3 * 4)] : low + (high - low) * unit(engine);
  };
  vec4 r(pick(domain.x, domain.z), pick(domain.y, domain.w), pick(domain.x, domain.z),
    pick(domain.y, domain.w));
  return vec4(std::min(r.x, r.z), std::min(r.y, r.w), std::max(r.x, r.z), std::max(r.y, r.w));
}

Sampled SampleMap(const View& view, const vec4& r)
{
  Sampled s;
  for (int i = 0; i <= Samples; ++i)
  {
    for (int j = 0; j <= Samples; ++j)
    {
      const vec2 t(double(i) / Samples, double(j) / Samples);
      const vec2 angles =
        glm::min(vec2(r.x + (r.z - r.x) * t.x, r.y + (r.w - r.y) * t.y), vec2(r.z, r.w));
      const vec2 p = view.GetProjection().Map(angles, view.GetParameters());
      // a planar map bounds the window only
      const bool window = std::abs(p.x) <= 1 && std::abs(p.y) <= 1;
      if (view.GetProjection().Axis != Family::Planar || window)
      {
        s.Add(p);
      }
    }
  }
  return s;
}
}

TEST(Bounds, HoldEveryMappedPoint)
{
  std::mt19937_64 engine(42);
  for (const NamedView& v : AllViews())
  {
    for (int n = 0; n < 60; ++n)
    {
      const vec4 r = RandomRectangle(DomainOf(v.TheView), engine);
      const vec4 b = v.TheView.GetProjection().Bounds(r, v.TheView.GetParameters());
      const Sampled s = SampleMap(v.TheView, r);
      const double size = std::max(1.0, std::max(std::abs(b.x), std::abs(b.w)));
      const double e = BoundsRounding * size;
      ASSERT_TRUE(
        s.Low.x >= b.x - e && s.Low.y >= b.y - e && s.High.x <= b.z + e && s.High.y <= b.w + e)
        << v.Name << "\nangles " << Text(vec2(r.x, r.y)) << " to " << Text(vec2(r.z, r.w))
        << "\nbounds " << Text(vec2(b.x, b.y)) << " to " << Text(vec2(b.z, b.w)) << "\nmapped "
        << Text(s.Low) << " to " << Text(s.High);
    }
  }
}

TEST(Bounds, AreTight)
{
  std::mt19937_64 engine(43);
  for (const NamedView& v : AllViews())
  {
    const Family family = v.TheView.GetProjection().Axis;
    if (family == Family::Planar || family == Family::Faces)
    {
      continue; // the whole window
    }
    for (int n = 0; n < 60; ++n)
    {
      const vec4 r = RandomRectangle(DomainOf(v.TheView), engine);
      const vec4 b = v.TheView.GetProjection().Bounds(r, v.TheView.GetParameters());
      const Sampled s = SampleMap(v.TheView, r);
      const vec2 e = vec2(b.z - b.x, b.w - b.y) * BoundsSlack + vec2(1e-9);
      ASSERT_TRUE(s.Low.x <= b.x + e.x && s.Low.y <= b.y + e.y && s.High.x >= b.z - e.x &&
        s.High.y >= b.w - e.y)
        << v.Name << "\nangles " << Text(vec2(r.x, r.y)) << " to " << Text(vec2(r.z, r.w))
        << "\nbounds " << Text(vec2(b.x, b.y)) << " to " << Text(vec2(b.z, b.w)) << "\nmapped "
        << Text(s.Low) << " to " << Text(s.High);
    }
  }
}
