// SPDX-License-Identifier: BSD-3-Clause
#include "TangentFrame.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace reference
{
namespace
{
// Pixels: step of the differences that a frame is made of. Their own error is the square
// of it by the curvature of the map, and the rounding of a direction over it.
constexpr double FrameStep = 1e-3;

// Relative: less than this of the product of its sides, and the pixel's shape is a line.
constexpr double FlatFrame = 1e-9;

// The part of a polygon where the function is not negative, which is linear along edges.
template <typename Point, typename Function>
std::vector<Point> CutBy(const std::vector<Point>& polygon, Function function)
{
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point& p = polygon[i];
    const Point& q = polygon[(i + 1) % polygon.size()];
    const double a = function(p);
    const double b = function(q);
    if (a >= 0)
    {
      kept.push_back(p);
    }
    if ((a > 0 && b < 0) || (a < 0 && b > 0))
    {
      kept.push_back(p + (q - p) * (a / (a - b)));
    }
  }
  return kept;
}

double Cross(vec2 a, vec2 b)
{
  return a.x * b.y - a.y * b.x;
}

double SignedArea(const Polygon& polygon)
{
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    twice += Cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return 0.5 * twice;
}

// Counterclockwise, or nothing where it has no area.
Polygon Proper(Polygon polygon)
{
  const double area = SignedArea(polygon);
  if (!(std::abs(area) >= LeastArea) || !std::isfinite(area))
  {
    return {};
  }
  if (area < 0)
  {
    std::reverse(polygon.begin(), polygon.end());
  }
  return polygon;
}

// The change of direction per pixel along one axis, from both sides where the map has both.
vec3 StepAlong(const View& view, vec2 size, vec2 place, vec2 axis, const vec3& ahead)
{
  const auto ray = [&](double pixels) {
    const vec2 at = place + axis * pixels;
    return view.Ray(PixelToNdc(at.x, at.y, int(size.x), int(size.y)));
  };
  const ViewRay next = ray(FrameStep);
  const ViewRay before = ray(-FrameStep);
  const vec3 to = next.Inside ? next.Direction : ahead;
  const vec3 from = before.Inside ? before.Direction : ahead;
  const double steps = (next.Inside ? 1 : 0) + (before.Inside ? 1 : 0);
  const vec3 step = (to - from) / (std::max(steps, 1.0) * FrameStep);
  return step - ahead * glm::dot(step, ahead);
}
}

TangentFrame::TangentFrame(const View& view, int width, int height, vec2 place)
{
  const ViewRay ray = view.Ray(PixelToNdc(place.x, place.y, width, height));
  this->Origin = ray.Origin;
  this->Ahead = ray.Direction;
  this->Right = StepAlong(view, vec2(width, height), place, vec2(1, 0), ray.Direction);
  this->Down = StepAlong(view, vec2(width, height), place, vec2(0, 1), ray.Direction);
  const double rr = glm::dot(this->Right, this->Right);
  const double dd = glm::dot(this->Down, this->Down);
  const double rd = glm::dot(this->Right, this->Down);
  const double det = rr * dd - rd * rd;
  this->Valid = ray.Inside && det > FlatFrame * rr * dd;
  if (this->Valid)
  {
    this->ToRight = (this->Right * dd - this->Down * rd) / det;
    this->ToDown = (this->Down * rr - this->Right * rd) / det;
  }
}

vec3 TangentFrame::DirectionAt(vec2 pixels) const
{
  return this->Ahead + this->Right * pixels.x + this->Down * pixels.y;
}

// Ways from the eye, cut to what is so near.
std::vector<vec3> TangentFrame::Within(std::vector<vec3> corners, double reach) const
{
  for (const vec3& axis : { this->ToRight, -this->ToRight, this->ToDown, -this->ToDown })
  {
    const vec3 plane = this->Ahead * reach - axis;
    corners = CutBy(corners, [&](const vec3& w) { return glm::dot(plane, w); });
  }
  return corners;
}

std::vector<vec3> TangentFrame::EdgeWithin(const vec3& a, const vec3& b, double reach) const
{
  return this->Within({ a - this->Origin, b - this->Origin }, reach);
}

Polygon TangentFrame::Picture(const std::vector<vec3>& corners, double reach) const
{
  Polygon polygon;
  for (const vec3& w : this->Within(corners, reach))
  {
    polygon.push_back(
      vec2(glm::dot(this->ToRight, w), glm::dot(this->ToDown, w)) / glm::dot(this->Ahead, w));
  }
  return Proper(polygon);
}

Polygon TangentFrame::PictureOf(const std::array<vec3, 3>& t, double reach) const
{
  return this->Picture({ t[0] - this->Origin, t[1] - this->Origin, t[2] - this->Origin }, reach);
}

Polygon TangentFrame::PictureBefore(
  const std::array<vec3, 3>& t, const std::array<vec3, 3>& other, double reach) const
{
  const vec3 o = this->Origin;
  const vec3 normal = glm::cross(other[1] - other[0], other[2] - other[0]);
  const double offset = glm::dot(normal, other[0] - o);
  const double side = offset > 0 ? 1 : -1;
  return this->Picture(CutBy(std::vector<vec3>{ t[0] - o, t[1] - o, t[2] - o },
                         [&](const vec3& w) { return side * (offset - glm::dot(normal, w)); }),
    reach);
}

double Area(const Polygon& polygon)
{
  return std::abs(SignedArea(polygon));
}

vec2 Centroid(const Polygon& polygon)
{
  vec2 sum(0);
  for (const vec2& p : polygon)
  {
    sum += p;
  }
  return sum / double(polygon.size());
}

bool Holds(const Polygon& polygon, vec2 point)
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const vec2 a = polygon[i];
    const vec2 b = polygon[(i + 1) % polygon.size()];
    if (Cross(b - a, point - a) < 0)
    {
      return false;
    }
  }
  return !polygon.empty();
}

vec2 NearestToOrigin(const Polygon& polygon)
{
  if (Holds(polygon, vec2(0)))
  {
    return vec2(0);
  }
  vec2 best = polygon[0];
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const vec2 a = polygon[i];
    const vec2 ab = polygon[(i + 1) % polygon.size()] - a;
    const double l2 = glm::dot(ab, ab);
    const double t = l2 > 0 ? std::clamp(-glm::dot(a, ab) / l2, 0.0, 1.0) : 0.0;
    const vec2 p = a + ab * t;
    best = glm::dot(p, p) < glm::dot(best, best) ? p : best;
  }
  return best;
}

Polygon Cut(const Polygon& polygon, vec2 normal, double offset)
{
  return Proper(CutBy(polygon, [&](vec2 p) { return glm::dot(normal, p) - offset; }));
}

std::vector<Polygon> Without(const Polygon& polygon, const Polygon& other)
{
  std::vector<Polygon> parts;
  Polygon rest = polygon;
  for (std::size_t i = 0; i < other.size() && !rest.empty(); ++i)
  {
    const vec2 a = other[i];
    const vec2 ab = other[(i + 1) % other.size()] - a;
    const vec2 inwards(-ab.y, ab.x);
    const double offset = glm::dot(inwards, a);
    const Polygon outside = Cut(rest, -inwards, -offset);
    if (!outside.empty())
    {
      parts.push_back(outside);
    }
    rest = Cut(rest, inwards, offset);
  }
  return parts;
}

std::vector<Polygon> Halves(const Polygon& polygon)
{
  vec2 longest(0);
  for (const vec2& p : polygon)
  {
    for (const vec2& q : polygon)
    {
      longest = glm::dot(p - q, p - q) > glm::dot(longest, longest) ? p - q : longest;
    }
  }
  const double offset = glm::dot(longest, Centroid(polygon));
  std::vector<Polygon> halves;
  for (const double side : { 1.0, -1.0 })
  {
    const Polygon half = Cut(polygon, longest * side, offset * side);
    if (!half.empty())
    {
      halves.push_back(half);
    }
  }
  return halves;
}
}
}
