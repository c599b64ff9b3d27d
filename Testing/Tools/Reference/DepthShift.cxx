// SPDX-License-Identifier: BSD-3-Clause
#include "DepthShift.h"

#include <cmath>

namespace wfv
{
namespace reference
{
namespace
{
// Pixels, each way, of the differences that the slope comes from.
constexpr double ShiftStep = 1e-3;
}

double DepthRounding(const Caster& caster, int width, int height, int i, int j, const Hit& hit)
{
  const TriangleSoup* const soup = caster.GetSoup();
  if (!soup || hit.Triangle < 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const auto& corners = soup->Triangles[hit.Triangle];
  const vec3 p = soup->Points[corners[0]];
  const vec3 normal = glm::cross(soup->Points[corners[1]] - p, soup->Points[corners[2]] - p);
  const vec3 d = caster.GetView().Ray(PixelToNdc(i + 0.5, j + 0.5, width, height)).Direction;
  double change = 0;
  for (int k = 0; k < 3; ++k)
  {
    const float component = float(std::abs(d[k]));
    const double step = double(std::nextafter(component, 2.0f)) - component;
    change += 0.5 * step * std::abs(normal[k]);
  }
  return change / std::abs(glm::dot(normal, d));
}

double DepthShift(
  const Caster& caster, int width, int height, int i, int j, const Hit& hit, double drawn)
{
  const double unknown = std::numeric_limits<double>::infinity();
  const TriangleSoup* const soup = caster.GetSoup();
  if (!soup || hit.Triangle < 0)
  {
    return unknown;
  }
  const auto& corners = soup->Triangles[hit.Triangle];
  const vec3 p = soup->Points[corners[0]];
  const vec3 normal = glm::cross(soup->Points[corners[1]] - p, soup->Points[corners[2]] - p);
  const double h = ShiftStep;
  const auto distance = [&](double x, double y) {
    const ViewRay ray = caster.GetView().Ray(PixelToNdc(i + 0.5 + x, j + 0.5 + y, width, height));
    return glm::dot(normal, p - ray.Origin) / glm::dot(normal, ray.Direction);
  };
  const double slope =
    std::hypot(distance(h, 0) - distance(-h, 0), distance(0, h) - distance(0, -h)) / (2 * h);
  const double shift = std::abs(drawn - hit.Distance) / slope;
  return std::isfinite(shift) ? shift : unknown;
}
}
}
