// SPDX-License-Identifier: BSD-3-Clause
#include "Views.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace wfv
{
namespace test
{
namespace
{
// An ideal radius from which on float32 has too few digits for terms of a lens that nearly cancel:
// more than that of any fisheye, less than the tangent of 80 degrees.
constexpr double LargestFlat = 4;

// The smallest distance from a border, radians, that a round trip is asked to survive,
// and larger ones on the way to the open sphere.
constexpr double Offsets[] = { 1e-9, 1e-7, 1e-5, 1e-3, 0.1 };

std::vector<LensCoefficients> LensesAndNone(const Projection& p, double fov)
{
  std::vector<LensCoefficients> lenses = Lenses(p, fov);
  lenses.insert(lenses.begin(), LensCoefficients());
  return lenses;
}

// The vertical field of view nearest to this one, degrees.
double FitVertical(const Projection& p, double degrees)
{
  return std::clamp(degrees, p.MinVerticalFov, p.MaxVerticalFov);
}

void AddViews(std::vector<NamedView>& views, const Projection& p, double fov)
{
  for (double tilt : { 0.0, 21.0, 90.0, -135.0 })
  {
    for (const auto& lens : LensesAndNone(p, fov))
    {
      ViewOptions o;
      o.HorizontalFov = fov;
      o.VerticalFov = FitVertical(p, fov / 2);
      o.Tilt = tilt;
      o.Lens = lens;
      views.push_back(MakeView(p, o));
    }
  }
}
}

NamedView MakeView(const Projection& p, const ViewOptions& o)
{
  char text[200];
  std::snprintf(text, sizeof text, "%s hfov %g vfov %g tilt %g aspect %g lens %g %g %g %g %g",
    p.Name.c_str(), o.HorizontalFov, o.VerticalFov, o.Tilt, o.Aspect, o.Lens[0], o.Lens[1],
    o.Lens[2], o.Lens[3], o.Lens[4]);
  const bool lens = o.Lens != LensCoefficients{ { 0, 0, 0, 0, 0 } };
  return { text, o, View(p, o), lens };
}

std::vector<NamedView> AllViews()
{
  std::vector<NamedView> views;
  for (const Projection& p : Projections())
  {
    for (double fov : { 0.001, 1.0, 60.0, 90.0, 120.0, 179.0, 180.0, 270.0, 359.9 })
    {
      if (fov >= p.MinHorizontalFov && fov <= p.MaxHorizontalFov)
      {
        AddViews(views, p, fov);
      }
    }
    AddViews(views, p, p.MaxHorizontalFov);
  }
  return views;
}

std::vector<LensCoefficients> Lenses(const Projection& p, double fov)
{
  if (!p.HasLens)
  {
    return {};
  }
  const double h = RadiusAt(p, ViewOptions(), 0.5 * fov * Degree); // of the ideal lens
  std::vector<LensCoefficients> lenses{ { { 0.8 / h, 0, 0.2 / (h * h * h), 0, 0 } },
    { { 1.2 / h, -0.1 / (h * h), 0, -0.1 / (h * h * h * h), 0 } },
    { { 1.1 / h, 0, 0, 0, -0.1 / (h * h * h * h * h) } },
    // as OpenCV's fisheyes are
    { { 1 / h, 0, -0.06 / std::pow(h, 3), 0, 0.1 / std::pow(h, 5), 0, -0.07 / std::pow(h, 7), 0,
      0.03 / std::pow(h, 9) } } };
  if (h < LargestFlat)
  {
    // flat in the middle: a quarter of the mean slope
    lenses.push_back({ { 2.5 / h, -4.5 / (h * h), 3 / (h * h * h), 0, 0 } });
  }
  return lenses;
}

std::vector<vec3> SpecialDirections(double offset)
{
  std::vector<vec3> d;
  for (int x = -1; x <= 1; ++x)
  {
    for (int y = -1; y <= 1; ++y)
    {
      for (int z = -1; z <= 1; ++z)
      {
        if (x || y || z)
        {
          d.push_back(glm::normalize(vec3(x, y, z)));
        }
      }
    }
  }
  constexpr int Around = 24;
  for (int i = 0; i < Around; ++i)
  {
    const double a = 2 * WFV_PI * (i + 0.125) / Around - WFV_PI;
    for (double s : { -1.0, 1.0 })
    {
      d.push_back(wfvMeridianDirection(vec2(a, s * (0.5 * WFV_PI - offset))));
      d.push_back(wfvMeridianDirection(vec2(a, s * offset)));
      d.push_back(wfvMeridianDirection(vec2(s * (WFV_PI - offset), a / 2)));
    }
    d.push_back(wfvAzimuthalDirection(vec2(a, WFV_PI - offset)));
    d.push_back(wfvAzimuthalDirection(vec2(a, offset)));
  }
  return d;
}

std::vector<vec3> RandomDirections(int count)
{
  std::mt19937_64 engine(20240229);
  std::normal_distribution<double> normal;
  std::vector<vec3> d;
  for (int i = 0; i < count; ++i)
  {
    const double x = normal(engine);
    const double y = normal(engine);
    d.push_back(glm::normalize(vec3(x, y, normal(engine))));
  }
  return d;
}

std::vector<vec3> ManyDirections()
{
  std::vector<vec3> all = RandomDirections(20000);
  for (double offset : { 1e-9, 1e-7, 1e-5, 1e-3, 0.1 })
  {
    const std::vector<vec3> special = SpecialDirections(offset);
    all.insert(all.end(), special.begin(), special.end());
  }
  return all;
}

std::vector<vec3> RimDirections(const View& view, double offset)
{
  std::vector<vec3> d;
  const Projection& p = view.GetProjection();
  const double rim = view.GetParameters().maxAngle - offset;
  const vec2 half(0.5 * p.MaxHorizontalFov * Degree, 0.5 * p.MaxVerticalFov * Degree);
  constexpr int Around = 32;
  for (int i = 0; i < Around; ++i)
  {
    const double t = (i + 0.5) / Around * 2 - 1;
    if (p.Axis == Family::Azimuthal && rim > 0)
    {
      d.push_back(wfvAzimuthalDirection(vec2(WFV_PI * t, rim)));
    }
    if (p.Axis == Family::Meridian)
    {
      const double s = i % 2 ? 1 : -1;
      d.push_back(wfvMeridianDirection(vec2(half.x * t, s * (half.y - offset))));
      d.push_back(wfvMeridianDirection(vec2(s * (half.x - offset), half.y * t)));
    }
  }
  return d;
}

std::vector<vec3> DirectionsFor(const View& view)
{
  std::vector<vec3> all = RandomDirections(2000);
  for (double offset : Offsets)
  {
    for (const auto& some : { SpecialDirections(offset), RimDirections(view, offset) })
    {
      all.insert(all.end(), some.begin(), some.end());
    }
  }
  for (vec3& d : all)
  {
    d = wfvUntilt(d, view.GetParameters());
  }
  return all;
}

bool InDomain(const View& view, const vec3& direction)
{
  const WfvView& v = view.GetParameters();
  const vec3 p = wfvTilt(direction, v);
  switch (view.GetProjection().Axis)
  {
    case Family::Azimuthal:
      return wfvAzimuthalAngles(p).y <= v.maxAngle;
    case Family::Planar:
      return p.z < 0;
    case Family::Meridian:
    {
      const Projection& map = view.GetProjection();
      const vec2 a = wfvMeridianAngles(p) / Degree;
      return std::abs(a.x) <= 0.5 * map.MaxHorizontalFov &&
        std::abs(a.y) <= 0.5 * map.MaxVerticalFov;
    }
    default:
      return true;
  }
}

vec2 AnglesOf(const Projection& projection, const vec3& d)
{
  return projection.Axis == Family::Azimuthal ? wfvAzimuthalAngles(d) : wfvMeridianAngles(d);
}

std::string Text(const vec3& v)
{
  char text[120];
  std::snprintf(text, sizeof text, "(%.17g, %.17g, %.17g)", v.x, v.y, v.z);
  return text;
}

std::string Text(const vec2& v)
{
  char text[80];
  std::snprintf(text, sizeof text, "(%.17g, %.17g)", v.x, v.y);
  return text;
}
}
}
