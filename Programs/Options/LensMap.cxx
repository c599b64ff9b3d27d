// SPDX-License-Identifier: BSD-3-Clause
#include "LensMap.h"

#include "Text/Angles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace widefov
{
namespace
{
using wfv::vec2;

// Beyond the corners of the picture, of the radius there: what decentering may move in from
// outside.
constexpr double BeyondCorners = 1.05;

// Degrees: as far from the axis as brown-conrady goes.
constexpr double MostAngle = 80;

// Steps from the axis to the largest angle, in which a lens is followed.
constexpr int LensSteps = 1 << 14;

// Newton's steps, and the rest, in focal lengths, with which a place counts as found: a
// hundredth of a pixel of the largest picture.
constexpr int MostSteps = 50;
constexpr double Rest = 1e-8;

// The radius of a fisheye with prism at the angle a, radians.
double RadiusOfFisheye(const std::array<double, 8>& k, double a)
{
  const double s = a * a;
  return a * (1 + s * (k[0] + s * (k[1] + s * (k[4] + s * k[5]))));
}

// The radius of the lens at the tangent t, without decentering and prism.
double RadiusOf(const CalibratedLens& lens, double t)
{
  const std::array<double, 8>& k = lens.Coefficients;
  if (lens.Kind == UnevenKind::Fov)
  {
    return std::atan(2 * t * std::tan(0.5 * k[0])) / k[0];
  }
  if (lens.Kind == UnevenKind::PrismFisheye)
  {
    return RadiusOfFisheye(k, std::atan(t));
  }
  const double s = t * t;
  return t * (1 + s * (k[0] + s * (k[1] + s * k[4]))) / (1 + s * (k[5] + s * (k[6] + s * k[7])));
}

// How far decentering and prism move the place q.
vec2 Aside(const CalibratedLens& lens, const vec2& q)
{
  const std::array<double, 8>& k = lens.Coefficients;
  if (lens.Kind == UnevenKind::Fov)
  {
    return vec2(0);
  }
  const double s = glm::dot(q, q);
  const vec2 aside(2 * k[2] * q.x * q.y + k[3] * (s + 2 * q.x * q.x),
    k[2] * (s + 2 * q.y * q.y) + 2 * k[3] * q.x * q.y);
  return lens.Kind == UnevenKind::PrismFisheye ? aside + s * vec2(k[6], k[7]) : aside;
}

// The place at which the lens shows the direction (p, 1), y down, z ahead; pixels divided by the
// focal lengths.
vec2 PlaceOf(const CalibratedLens& lens, const vec2& p)
{
  const double t = glm::length(p);
  const bool fisheye = lens.Kind == UnevenKind::PrismFisheye;
  const vec2 q = fisheye && t > 0 ? std::atan(t) / t * p : p;
  return (t > 0 ? RadiusOf(lens, t) / t : 1) * p + Aside(lens, q);
}

// Of the radius alone, by halving: the start of the search.
double TangentOf(const CalibratedLens& lens, double radius)
{
  double low = 0;
  double high = lens.End;
  for (int i = 0; i < 20; i++)
  {
    const double middle = 0.5 * (low + high);
    (RadiusOf(lens, middle) < radius ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// The direction (p, 1) that is shown at a place; false: none up to the end of the lens.
bool Solve(const CalibratedLens& lens, const vec2& place, vec2& p)
{
  const double radius = glm::length(place);
  p = radius > 0 ? TangentOf(lens, radius) / radius * place : vec2(0);
  constexpr double h = 1e-6;
  for (int i = 0; i < MostSteps; i++)
  {
    const vec2 off = PlaceOf(lens, p) - place;
    if (glm::length(off) < Rest)
    {
      return glm::length(p) <= lens.End;
    }
    const vec2 x = (PlaceOf(lens, p + vec2(h, 0)) - PlaceOf(lens, p - vec2(h, 0))) / (2 * h);
    const vec2 y = (PlaceOf(lens, p + vec2(0, h)) - PlaceOf(lens, p - vec2(0, h))) / (2 * h);
    const double determinant = x.x * y.y - x.y * y.x;
    if (!(determinant > 0))
    {
      return false; // the lens is folded here
    }
    p -= vec2(off.x * y.y - off.y * y.x, off.y * x.x - off.x * x.y) / determinant;
  }
  return false;
}
}

bool IsUneven(const CalibratedLens& lens)
{
  const std::array<double, 8>& k = lens.Coefficients;
  return lens.Kind != UnevenKind::OpenCv || k[2] != 0 || k[3] != 0 || k[5] != 0 || k[6] != 0 ||
    k[7] != 0;
}

double RadiusToCorners(const wfv::MeasuredPicture& m)
{
  double farthest = 0;
  for (int i = 0; i < 4; i++)
  {
    const vec2 corner(i & 1 ? m.Size.x : 0, i & 2 ? m.Size.y : 0);
    farthest = std::max(farthest, glm::length((corner - m.Axis) / m.Focal));
  }
  return farthest;
}

double FollowLens(const std::string& file, const LensReach& reach,
  const std::function<double(double angle)>& radiusAt)
{
  double before = 0;
  for (int i = 1; i <= LensSteps; i++)
  {
    const double last = reach.Most * (i - 1) / LensSteps;
    const double angle = reach.Most * i / LensSteps;
    const double radius = radiusAt(angle);
    if (!(radius > before) && before < reach.Corner)
    {
      FailUsage(file + ": the lens stops growing " + Text(std::floor(10 * last / Degree) / 10) +
        " degrees from its axis, inside the picture; check the calibration, or give a smaller "
        "--fov");
    }
    if (!(radius > before) || radius >= reach.End)
    {
      return radius > before ? angle : last;
    }
    before = radius;
  }
  return reach.Most;
}

double EndOfLens(
  const std::string& file, const CalibratedLens& lens, const std::optional<double>& fov)
{
  const double corner = RadiusToCorners({ lens.Size, lens.Axis, lens.Focal });
  const double most = std::min(MostAngle, fov ? 0.5 * *fov : MostAngle) * Degree;
  const double angle = FollowLens(file, { most, corner, BeyondCorners * corner },
    [&](double a) { return RadiusOf(lens, std::tan(a)); });
  if (lens.Kind != UnevenKind::OpenCv && !fov && RadiusOf(lens, std::tan(angle)) < corner)
  {
    Say("warning: " + file + " shows more than " + Text(MostAngle) +
      " degrees from its axis, beyond which this kind of lens is not drawn");
  }
  return std::tan(angle);
}

std::shared_ptr<const wfv::DirectionMap> MakeLensMap(
  const CalibratedLens& lens, int width, int height)
{
  const vec2 size(width, height);
  const double scale = std::min(size.x / lens.Size.x, size.y / lens.Size.y);
  std::vector<float> directions;
  directions.reserve(3 * static_cast<std::size_t>(width) * height);
  for (int row = height - 1; row >= 0; row--)
  {
    for (int column = 0; column < width; column++)
    {
      const vec2 at = (vec2(column, row) + 0.5 - 0.5 * size) / scale + 0.5 * lens.Size;
      vec2 p;
      wfv::vec3 d(0);
      if (Solve(lens, (at - lens.Axis) / lens.Focal, p))
      {
        d = glm::normalize(wfv::vec3(p.x, -p.y, -1));
      }
      for (int i = 0; i < 3; i++)
      {
        directions.push_back(static_cast<float>(d[i]));
      }
    }
  }
  return std::make_shared<const wfv::DirectionMap>(width, height, directions);
}
}
