// SPDX-License-Identifier: BSD-3-Clause
#include "Surface.h"

namespace wfv::displays
{
namespace
{
// Metres: a ray does not meet the surface that it starts on.
constexpr double LeastDistance = 1e-9;

// The distances at which a t^2 + 2 b t + c = 0, the nearer one first; NaN where there are none.
vec2 Roots(double a, double b, double c)
{
  const double root = std::sqrt(b * b - a * c);
  const double q = -(b + (b < 0 ? -root : root)); // no digits cancel
  const vec2 roots(q / a, c / q);
  return roots.x < roots.y ? roots : vec2(roots.y, roots.x);
}
}

double SphereSurface::Meet(const vec3& origin, const vec3& direction) const
{
  const vec3 from = origin - this->Center;
  const vec2 roots =
    Roots(1, glm::dot(from, direction), glm::dot(from, from) - this->Radius * this->Radius);
  const double least = std::cos(glm::radians(this->HalfAngle)) * this->Radius;
  for (const double t : { roots.x, roots.y })
  {
    const double along = glm::dot(from + t * direction, this->Axis);
    if (t > LeastDistance && (this->HalfAngle >= 180 || along >= least))
    {
      return t;
    }
  }
  return Nowhere;
}

double CylinderSurface::Meet(const vec3& origin, const vec3& direction) const
{
  const vec3 from = origin - this->Center;
  const double a = direction.x * direction.x + direction.z * direction.z;
  const vec2 roots = Roots(a, from.x * direction.x + from.z * direction.z,
    from.x * from.x + from.z * from.z - this->Radius * this->Radius);
  for (const double t : { roots.x, roots.y })
  {
    const vec3 p = from + t * direction;
    const double angle = glm::degrees(std::abs(std::atan2(p.x, -p.z)));
    if (t > LeastDistance && p.y >= this->Low && p.y <= this->High && angle <= this->HalfAngle)
    {
      return t;
    }
  }
  return Nowhere;
}

double PlaneSurface::Meet(const vec3& origin, const vec3& direction) const
{
  const vec3 right = this->LowerRight - this->LowerLeft;
  const vec3 up = this->UpperRight - this->LowerRight;
  const vec3 normal = glm::cross(right, up);
  const double t = glm::dot(this->LowerLeft - origin, normal) / glm::dot(direction, normal);
  const vec3 p = origin + t * direction - this->LowerLeft;
  const double x = glm::dot(p, right) / glm::dot(right, right);
  const double y = glm::dot(p, up) / glm::dot(up, up);
  return t > LeastDistance && x >= 0 && x <= 1 && y >= 0 && y <= 1 ? t : Nowhere;
}
}
