// SPDX-License-Identifier: BSD-3-Clause
// What PROJ does not know, or not well enough, against formulas of its own in long double.
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace wfv;
using namespace wfv::test;

namespace
{
using real = long double;

// Largest difference in the raw map, relative to its size.
constexpr double FormulaAgreement = 1e-13;

const real Pi = 3.14159265358979323846264338327950288L;

struct MapPlace
{
  real X;
  real Y;
};

View WidestView(const char* name)
{
  const Projection& p = *FindProjection(name);
  ViewOptions o;
  o.Aspect = 1;
  o.HorizontalFov = p.MaxHorizontalFov;
  o.VerticalFov = p.MaxVerticalFov;
  return View(p, o);
}

// Worst difference over the directions that `formula` has a place for.
void Check(const char* name, const std::vector<vec3>& directions,
  const std::function<MapPlace(const vec3&)>& formula)
{
  const View view = WidestView(name);
  const vec2 scale = view.GetParameters().scale;
  double worst = 0;
  std::string where;
  long count = 0;
  for (const vec3& d : directions)
  {
    // a pole may be a line: any of its points is right
    if (!InDomain(view, d) || !(std::hypot(d.x, d.z) > 0))
    {
      continue;
    }
    ++count;
    const MapPlace right = formula(d);
    const vec3 ndc = view.Forward(d).Ndc;
    const double error =
      std::hypot(double(ndc.x / scale.x - right.X), double(ndc.y / scale.y - right.Y)) /
      std::max(1.0, std::hypot(double(right.X), double(right.Y)));
    if (!(error <= worst))
    {
      worst = error;
      where = Text(d) + " ours " + Text(vec2(ndc.x / scale.x, ndc.y / scale.y)) + " formula " +
        Text(vec2(double(right.X), double(right.Y)));
    }
  }
  std::cout << name << ": " << count << " directions, worst " << worst << " at " << where << "\n";
  EXPECT_GT(count, 2000) << name;
  EXPECT_LE(worst, FormulaAgreement) << where;
}

real Longitude(const vec3& d)
{
  return std::atan2(real(d.x), -real(d.z));
}

real Latitude(const vec3& d)
{
  return std::atan2(real(d.y), std::hypot(real(d.x), real(d.z)));
}

// Sharpless, Postle and German 2010: with S = (d + 1) / (d + cos(phi)) horizontally
// h = S sin(phi) and vertically v = S tan(theta), phi the longitude, theta the latitude.
MapPlace Pannini(const vec3& direction)
{
  const real d = 1;
  const real s = (d + 1) / (d + std::cos(Longitude(direction)));
  return { s * std::sin(Longitude(direction)), s * std::tan(Latitude(direction)) };
}

// FFmpeg's v360 filter, "eac": a cube of 3 by 2 faces, 2 / pi atan(uv) + 0.5 on each, the
// lower row turned.
MapPlace EquiAngular(const vec3& p)
{
  const real x = p.x, y = p.y, z = -p.z; // ahead is z there
  const real ax = std::abs(x), ay = std::abs(y), az = std::abs(z);
  real u = 0, v = 0;
  int column = 0, row = 0;
  if (az >= ax && az >= ay)
  {
    column = 1;
    row = z > 0 ? 0 : 1;
    u = z > 0 ? x / z : y / az;
    v = z > 0 ? y / z : x / az;
  }
  else if (ax >= ay)
  {
    column = x > 0 ? 2 : 0;
    u = -z / x;
    v = y / ax;
  }
  else
  {
    column = y > 0 ? 2 : 0;
    row = 1;
    u = z / y;
    v = x / ay;
  }
  const real a = 2 / Pi * std::atan(u) + 0.5L;
  const real b = 2 / Pi * std::atan(v) + 0.5L;
  return { 2 * (column + a) / 3 - 1, (row == 0 ? b : b - 1) };
}

// The root of an increasing function, by halving alone.
real Root(real low, real high, const std::function<real(real)>& f)
{
  for (int i = 0; i < 200; ++i)
  {
    const real middle = 0.5L * (low + high);
    (f(middle) < 0 ? low : high) = middle;
  }
  return 0.5L * (low + high);
}

// One minus the sine of |latitude|, without cancellation.
real Gap(const vec3& d)
{
  const real h = std::hypot(real(d.x), real(d.z));
  const real rho = std::hypot(h, real(d.y));
  return h * h / (rho * (rho + std::abs(real(d.y))));
}

// Snyder, Map Projections: A Working Manual, (31-1) to (31-4), in u = pi/2 - theta, where
// u - sin(u) cos(u) is summed as a series: its terms do not cancel.
real SineExcess(real u) // 2u - sin(2u)
{
  real term = 2 * u * 2 * u * 2 * u / 6;
  real sum = 0;
  for (int k = 4; std::abs(term) > std::abs(sum) * 1e-22L && k < 200; k += 2)
  {
    sum += term;
    term *= -(2 * u) * (2 * u) / (k * (k + 1));
  }
  return sum;
}

MapPlace Mollweide(const vec3& d)
{
  const real q = Gap(d);
  const real u = Root(0, Pi / 2, [q](real t) { return SineExcess(t) - Pi * q; });
  return { 2 * std::sqrt(2.0L) / Pi * Longitude(d) * std::sin(u),
    std::copysign(std::sqrt(2.0L) * std::cos(u), real(d.y)) };
}

// The same manual, (32-1) to (32-5), in u = pi/2 - theta.
MapPlace EckertIV(const vec3& d)
{
  const real q = Gap(d);
  const real u = Root(0, Pi / 2, [q](real t) {
    const real s = std::sin(t / 2);
    return SineExcess(t) / 2 + 4 * s * s - (2 + Pi / 2) * q;
  });
  return { 2 / std::sqrt(Pi * (4 + Pi)) * Longitude(d) * (1 + std::sin(u)),
    std::copysign(2 * std::sqrt(Pi / (4 + Pi)) * std::cos(u), real(d.y)) };
}

// Snyder, Flattening the Earth, p. 130: half the longitude, the angle from the centre, its
// sine by the chord, which does not cancel.
MapPlace Aitoff(const vec3& d)
{
  const real l = Longitude(d) / 2, p = Latitude(d);
  const real x = std::cos(p) * std::sin(l), y = std::sin(p);
  const real s = std::hypot(x, y);
  const real k = s > 0 ? std::atan2(s, std::cos(p) * std::cos(l)) / s : 1;
  return { 2 * x * k, y * k };
}

MapPlace WinkelTripel(const vec3& d)
{
  const MapPlace a = Aitoff(d);
  return { (Longitude(d) * 2 / Pi + a.X) / 2, (Latitude(d) + a.Y) / 2 };
}

// The radius is the chord from the centre: the length of d minus the axis.
MapPlace EqualArea(const vec3& d)
{
  const real x = d.x, y = d.y, s = std::hypot(x, y);
  const real chord = std::hypot(s, real(d.z) + 1);
  return s > 0 ? MapPlace{ chord * x / s, chord * y / s } : MapPlace{ chord, 0 };
}
}

TEST(Independent, Panini)
{
  Check("panini", ManyDirections(), Pannini);
}

TEST(Independent, EquiAngularCubemap)
{
  // on the borders themselves two places are right
  std::vector<vec3> inside;
  for (const vec3& d : ManyDirections())
  {
    const vec3 a = glm::abs(d);
    const double first = std::max({ a.x, a.y, a.z });
    const double others = a.x + a.y + a.z - first;
    const double second = std::max(others - std::min({ a.x, a.y, a.z }), 0.0);
    if (first - second > 1e-12)
    {
      inside.push_back(d);
    }
  }
  Check("equi-angular-cubemap", inside, EquiAngular);
}

TEST(Independent, Mollweide)
{
  Check("mollweide", ManyDirections(), Mollweide);
}

TEST(Independent, EckertIV)
{
  Check("eckert-iv", ManyDirections(), EckertIV);
}

TEST(Independent, Aitoff)
{
  Check("aitoff", ManyDirections(), Aitoff);
}

TEST(Independent, WinkelTripel)
{
  Check("winkel-tripel", ManyDirections(), WinkelTripel);
}

TEST(Independent, AzimuthalEqualArea)
{
  Check("azimuthal-equal-area", ManyDirections(), EqualArea);
}
