// SPDX-License-Identifier: BSD-3-Clause
#include "Projections/Bounds/ViewFrustum.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace
{
// Degrees from the axis: beyond, a frustum holds hardly less than a half space does.
constexpr double WidestFrustum = 80;

// Relative, of its tangents: lines and points are as wide as they are.
constexpr double FrustumMargin = 0.1;

// Convex; a quadrangle that four planes have cut.
struct Polygon
{
  std::array<vec3, 8> Points;
  int Count = 0;
};

// What is on the side of a plane through the origin that its normal points to.
Polygon Cut(const Polygon& polygon, const vec3& normal)
{
  Polygon cut;
  for (int i = 0; i < polygon.Count; i++)
  {
    const vec3& p = polygon.Points[i];
    const vec3& q = polygon.Points[(i + 1) % polygon.Count];
    const double atP = glm::dot(normal, p);
    const double atQ = glm::dot(normal, q);
    // a convex polygon has no more corners; rounding may see a sliver go in and out once more
    if (atP >= 0 && cut.Count < 8)
    {
      cut.Points[cut.Count++] = p;
    }
    if ((atP < 0) != (atQ < 0) && cut.Count < 8)
    {
      cut.Points[cut.Count++] = p + atP / (atP - atQ) * (q - p);
    }
  }
  return cut;
}
}

std::optional<double> FarthestSeen(
  const Projection& p, const ViewOptions& o, const BoxCorners& corners)
{
  const vec2 half = 0.5 * vec2(o.HorizontalFov, p.Framed ? o.VerticalFov : o.HorizontalFov);
  if (p.Axis != Family::Azimuthal || !(std::max(half.x, half.y) < WidestFrustum))
  {
    return std::nullopt;
  }
  WfvView v;
  v.tilt = vec2(std::cos(glm::radians(o.Tilt)), std::sin(glm::radians(o.Tilt)));
  BoxCorners tilted;
  std::transform(corners.begin(), corners.end(), tilted.begin(),
    [&v](const vec3& corner) { return wfvTilt(corner, v); });
  const double farthest =
    FarthestInFrustum(tilted, (1 + FrustumMargin) * glm::tan(glm::radians(half)));
  return farthest > 0 ? std::optional<double>(farthest) : std::nullopt;
}

double FarthestInFrustum(const BoxCorners& corners, const vec2& tangents)
{
  static constexpr int Faces[6][4] = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
    { 2, 3, 7, 6 }, { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };
  const vec3 planes[4] = { vec3(1, 0, -tangents.x), vec3(-1, 0, -tangents.x),
    vec3(0, 1, -tangents.y), vec3(0, -1, -tangents.y) };
  double farthest = 0;
  for (const auto& face : Faces)
  {
    Polygon seen;
    for (const int corner : face)
    {
      seen.Points[seen.Count++] = corners[corner];
    }
    for (const vec3& plane : planes)
    {
      seen = Cut(seen, plane);
    }
    for (int i = 0; i < seen.Count; i++)
    {
      farthest = std::max(farthest, glm::length(seen.Points[i]));
    }
  }
  return farthest;
}
}
