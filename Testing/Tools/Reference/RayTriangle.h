// SPDX-License-Identifier: BSD-3-Clause
// The decision whether a ray meets a triangle, in ray space: with wi = vi - origin and
// the edge functions e0 = d . (w1 x w2) and so on, the ray's line meets the triangle
// where the three have one sign.
#ifndef WideFoVRayTriangle_h
#define WideFoVRayTriangle_h

#include "Projections/ProjectionMath.h"

#include <algorithm>
#include <array>
#include <limits>

namespace wfv
{
namespace reference
{
struct RayTriangleHit
{
  bool Found = false;
  double Distance = 0;    // along the ray, scene units
  vec3 Barycentrics{ 0 }; // of v0, v1, v2
};

// Rounding of an edge function, relative to the sum of the sizes of its six terms: five
// roundings on the way of each term and two for the differences from the origin, each
// half an epsilon, and one spare.
constexpr double EdgeRounding = 4 * std::numeric_limits<double>::epsilon();

struct EdgeFunction
{
  double Value; // twice the area that the edge spans as seen along the ray, times depth
  double Bound; // |Value| below this may have either sign
};

inline EdgeFunction EvaluateEdge(const vec3& d, const vec3& a, const vec3& b)
{
  const double value =
    d.x * (a.y * b.z - a.z * b.y) + d.y * (a.z * b.x - a.x * b.z) + d.z * (a.x * b.y - a.y * b.x);
  const double size = std::abs(d.x) * (std::abs(a.y * b.z) + std::abs(a.z * b.y)) +
    std::abs(d.y) * (std::abs(a.z * b.x) + std::abs(a.x * b.z)) +
    std::abs(d.z) * (std::abs(a.x * b.y) + std::abs(a.y * b.x));
  return { value, EdgeRounding * size };
}

// Edges are closed by the rounding of their own function: a triangle that truly meets
// the ray is never refused, so a closed mesh has no gap; one that a ray passes within
// 1e-15 of may be taken as well. A triangle seen edge-on, or without area, is not hit.
inline RayTriangleHit IntersectTriangle(
  const vec3& origin, const vec3& d, const std::array<vec3, 3>& v)
{
  const std::array<vec3, 3> w{ { v[0] - origin, v[1] - origin, v[2] - origin } };
  const std::array<EdgeFunction, 3> e{ { EvaluateEdge(d, w[1], w[2]), EvaluateEdge(d, w[2], w[0]),
    EvaluateEdge(d, w[0], w[1]) } };
  bool allUp = true;
  bool allDown = true;
  for (const EdgeFunction& edge : e)
  {
    allUp = allUp && edge.Value >= -edge.Bound;
    allDown = allDown && edge.Value <= edge.Bound;
  }
  RayTriangleHit hit;
  if (allUp == allDown) // outside, or nothing but rounding
  {
    return hit;
  }
  const double sign = allUp ? 1 : -1;
  vec3 weights(std::max(0.0, sign * e[0].Value), std::max(0.0, sign * e[1].Value),
    std::max(0.0, sign * e[2].Value));
  weights = weights / (weights.x + weights.y + weights.z);
  const vec3 point = w[0] * weights.x + w[1] * weights.y + w[2] * weights.z;
  hit.Distance = glm::dot(d, point);
  hit.Barycentrics = weights;
  hit.Found = hit.Distance > 0;
  return hit;
}
}
}

#endif
