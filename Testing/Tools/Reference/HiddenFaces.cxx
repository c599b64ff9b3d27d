// SPDX-License-Identifier: BSD-3-Clause
#include "HiddenFaces.h"

#include "NearestFace.h"
#include "NearestPlace.h"
#include "TangentFrame.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace wfv
{
namespace reference
{
namespace
{
vec2 CentreOf(const WorstPixel& pixel, int width, int height)
{
  return PixelToNdc(pixel.I + 0.5, pixel.J + 0.5, width, height);
}

bool IsSeenAround(
  const RayCaster& caster, int width, int height, const WorstPixel& pixel, double tolerance)
{
  constexpr int circles = 32;
  constexpr int points = 256;
  for (int k = 0; k < circles * points; ++k)
  {
    const double radius = tolerance * (k / points + 1) / circles;
    const double angle = 2 * WFV_PI * (k % points) / points;
    const vec2 ndc = PixelToNdc(pixel.I + 0.5 + radius * std::cos(angle),
      pixel.J + 0.5 + radius * std::sin(angle), width, height);
    if (caster.Sees(ndc, pixel.Drawn))
    {
      return true;
    }
  }
  return false;
}

using Place = std::array<double, 3>;
using Ends = std::pair<Place, Place>;

// The corners opposite an edge, of the triangles at it: two but at a border.
using Edges = std::map<Ends, std::vector<vec3>>;

// Edges of the triangles that are partly within so many pixels, by the places of their ends: where
// meshes are put together, points are there twice.
Edges EdgesNear(const TriangleSoup& soup, const TangentFrame& frame, double reach)
{
  Edges edges;
  for (const auto& triangle : soup.Triangles)
  {
    const std::array<vec3, 3> corners{ { soup.Points[triangle[0]], soup.Points[triangle[1]],
      soup.Points[triangle[2]] } };
    if (frame.PictureOf(corners, reach).empty())
    {
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const vec3& a = corners[i];
      const vec3& b = corners[(i + 1) % 3];
      const Ends ends = std::minmax({ Place{ { a.x, a.y, a.z } }, Place{ { b.x, b.y, b.z } } });
      edges[ends].push_back(corners[(i + 2) % 3]);
    }
  }
  return edges;
}

// Whether a surface ends at the edge, or both its triangles are on the same side of it.
bool IsRim(const vec3& eye, const vec3& a, const vec3& b, const std::vector<vec3>& opposite)
{
  if (opposite.size() != 2)
  {
    return true;
  }
  const vec3 normal = glm::cross(a - eye, b - eye);
  return glm::dot(normal, opposite[0] - eye) * glm::dot(normal, opposite[1] - eye) >= 0;
}

// Whether the eye sees a place of these ways, which are those to an edge.
bool SeesSome(const RayCaster& caster, const vec3& eye, const std::vector<vec3>& ways)
{
  constexpr int steps = 16;
  constexpr double rounding = 1e-6; // of a distance: the edge itself is met as well
  for (std::size_t i = 1; i < ways.size(); ++i)
  {
    for (int k = 0; k <= steps; ++k)
    {
      const vec3 way = ways[i - 1] + (ways[i] - ways[i - 1]) * (double(k) / steps);
      const double distance = glm::length(way);
      if (caster.Cast(eye, way / distance).Distance >= distance * (1 - rounding))
      {
        return true;
      }
    }
  }
  return false;
}
}

bool IsSeenWithin(
  const RayCaster& caster, int width, int height, const WorstPixel& pixel, double tolerance)
{
  const vec2 centre(pixel.I + 0.5, pixel.J + 0.5);
  const double limit = 2 * tolerance; // the search compares it with distances of first order
  return IsSeenAround(caster, width, height, pixel, tolerance) ||
    NearestPlace(caster, width, height, centre, pixel.Drawn, limit) <= tolerance + SnapStep;
}

bool IsThere(
  const RayCaster& caster, int width, int height, const WorstPixel& pixel, double tolerance)
{
  if (pixel.Drawn < 0)
  {
    return false;
  }
  bool inside = false;
  if (!IsClear(caster.GetView(), pixel.I, pixel.J, width, height, tolerance, inside))
  {
    return true; // its place may be beyond the border of the map, where no ray is
  }
  const vec2 centre(pixel.I + 0.5, pixel.J + 0.5);
  const double most = tolerance + SnapStep;
  return NearestFace(caster, width, height, centre, pixel.Drawn, most) <= most;
}

bool IsBesideRim(
  const RayCaster& caster, int width, int height, const WorstPixel& pixel, double tolerance)
{
  bool inside = false;
  if (!IsClear(caster.GetView(), pixel.I, pixel.J, width, height, tolerance, inside))
  {
    return true; // as above
  }
  const vec3 eye = caster.GetView().Ray(CentreOf(pixel, width, height)).Origin;
  const vec2 centre(pixel.I + 0.5, pixel.J + 0.5);
  const TangentFrame frame(caster.GetView(), width, height, centre);
  const Edges edges = EdgesNear(caster.GetTriangles(), frame, tolerance);
  return std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const Place& first = edge.first.first;
    const Place& last = edge.first.second;
    const vec3 a(first[0], first[1], first[2]);
    const vec3 b(last[0], last[1], last[2]);
    return IsRim(eye, a, b, edge.second) &&
      SeesSome(caster, eye, frame.EdgeWithin(a, b, tolerance));
  });
}

bool IsHardlyHidden(const RayCaster& caster, int width, int height, const WorstPixel& pixel)
{
  const RayCaster alone(OnlyCell(caster.GetTriangles(), pixel.Drawn), caster.GetView());
  const double distance = alone.Cast(CentreOf(pixel, width, height)).Distance;
  // (a chord may have given the pixel to a cell that its ray passes)
  const double shown = std::isfinite(distance) ? distance : pixel.DrawnDistance;
  return shown <= (1 + ChordDepth) * pixel.ReferenceDistance;
}

bool MayShow(
  const RayCaster& caster, int width, int height, const WorstPixel& pixel, double tolerance)
{
  return IsSeenWithin(caster, width, height, pixel, tolerance) ||
    (IsThere(caster, width, height, pixel, tolerance) &&
      (IsBesideRim(caster, width, height, pixel, tolerance) ||
        IsHardlyHidden(caster, width, height, pixel)));
}

long CountOff(const RayCaster& caster, int width, int height, const Metrics& m, double tolerance)
{
  return std::count_if(m.Worst.begin(), m.Worst.end(),
    [&](const auto& pixel) { return !IsSeenWithin(caster, width, height, pixel, tolerance); });
}
}
}
