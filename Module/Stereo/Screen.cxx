// SPDX-License-Identifier: BSD-3-Clause
#include "Stereo/Screen.h"

#include "Projections/NumberText.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace
{
// Cosine of the angle between two sides of a screen: corners measured by hand pass.
constexpr double LargestSkew = 0.01;

// Of a screen's diagonal: nearer to the plane of a screen no eye is taken to be.
constexpr double LeastDistance = 1e-6;

bool IsFinite(const vec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
}

std::string CheckScreen(const Screen& s)
{
  if (!IsFinite(s.LowerLeft) || !IsFinite(s.LowerRight) || !IsFinite(s.UpperRight))
  {
    return "a corner is not finite";
  }
  const vec3 across = s.LowerRight - s.LowerLeft;
  const vec3 upward = s.UpperRight - s.LowerRight;
  const double width = glm::length(across);
  const double height = glm::length(upward);
  if (!(width > 0) || !(height > 0) || !std::isfinite(width * height) || !(width * height > 0))
  {
    return "its corners span no area";
  }
  const double skew = glm::dot(across / width, upward / height);
  return std::abs(skew) <= LargestSkew
    ? ""
    : "its corners are those of no rectangle: the angle at the lower right one is " +
      NumberText(std::round(10 * std::acos(-skew) * 180 / WFV_PI) / 10) + " degrees";
}

vec3 TurnedWith(const Head& head, const vec3& v)
{
  const std::array<double, 4>& t = head.Turn;
  const vec3 axis(t[0], t[1], t[2]);
  const double square = glm::dot(axis, axis) + t[3] * t[3];
  return v + glm::cross(axis, glm::cross(axis, v) + t[3] * v) * (2 / square);
}

vec3 EyeOf(const Head& head, double interpupillaryDistance, Eye eye)
{
  const double aside = 0.5 * interpupillaryDistance * SideOf(eye);
  return head.Position + TurnedWith(head, vec3(aside, 0, 0));
}

ScreenFrustum LookThrough(const Screen& s, const vec3& eye)
{
  const vec3 across = s.LowerRight - s.LowerLeft;
  ScreenFrustum frustum;
  frustum.Right = glm::normalize(across);
  frustum.Back = glm::normalize(glm::cross(frustum.Right, s.UpperRight - s.LowerRight));
  frustum.Up = glm::cross(frustum.Back, frustum.Right);
  frustum.Distance = glm::dot(eye - s.LowerRight, frustum.Back);
  const vec2 half =
    vec2(glm::length(across), glm::dot(s.UpperRight - s.LowerRight, frustum.Up)) * 0.5;
  const vec3 corner = s.LowerLeft - eye;
  const vec2 middle = vec2(glm::dot(corner, frustum.Right), glm::dot(corner, frustum.Up)) + half;
  const double d = std::max(frustum.Distance, 2 * LeastDistance * glm::length(half));
  frustum.Half = half / d;
  frustum.Center = -middle / half;
  return frustum;
}

vec3 DirectionThrough(const ScreenFrustum& frustum, const vec2& ndc)
{
  const vec2 aside = (ndc - frustum.Center) * frustum.Half;
  return glm::normalize(aside.x * frustum.Right + aside.y * frustum.Up - frustum.Back);
}
}
