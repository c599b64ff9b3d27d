// SPDX-License-Identifier: BSD-3-Clause
#include "OwnMap.h"

#include "Caster.h"

#include <limits>

namespace wfv
{
namespace reference
{
namespace
{
// Pixels from a pixel's centre, in it, between which it is seen how its directions change.
constexpr double Inside = 1e-4;
}

OwnMap::OwnMap(const View& view, int i, int j, int width, int height)
{
  const auto ray = [&](double x, double y) {
    return view.Ray(PixelToNdc(i + 0.5 + x, j + 0.5 - y, width, height));
  };
  const ViewRay centre = ray(0, 0);
  const vec3 d = centre.Direction;
  const auto slope = [&](double x, double y) {
    const vec3 ahead = ray(x, y).Direction;
    const vec3 behind = ray(-x, -y).Direction;
    return (ahead / glm::dot(ahead, d) - behind / glm::dot(behind, d)) / (2 * Inside);
  };
  vec3 right = slope(Inside, 0);
  vec3 up = slope(0, Inside);
  right = glm::length(right) > 0 ? right : glm::cross(up, d);
  up = glm::length(up) > 0 ? up : glm::cross(d, right);
  const vec3 across = glm::cross(right, up);
  this->Normal = glm::dot(across, d) < 0 ? -across : across;
  this->Shown = centre.Inside && glm::length(across) > 0;
  this->ToMap = this->Shown ? glm::inverse(glm::dmat3(right, up, d)) : glm::dmat3(1);
}

vec2 OwnMap::PlaceOf(const vec3& direction) const
{
  const vec3 w = this->ToMap * direction;
  return w.z > 0 ? vec2(w.x, w.y) / w.z : vec2(std::numeric_limits<double>::infinity());
}
}
}
