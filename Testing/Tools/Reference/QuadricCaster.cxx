// SPDX-License-Identifier: BSD-3-Clause
#include "QuadricCaster.h"

namespace wfv
{
namespace reference
{
QuadricCaster::QuadricCaster(const std::vector<Body>& bodies, const View& view)
  : Caster(view)
  , Bodies(bodies)
{
}

Hit QuadricCaster::Cast(const vec3& origin, const vec3& direction) const
{
  const vec2 radii = this->TheView.GetParameters().radii;
  const auto between = [&radii](double t) { return t >= radii.x && t <= radii.y; };
  Hit best;
  for (std::size_t i = 0; i < this->Bodies.size(); ++i)
  {
    const Crossings c = Cross(this->Bodies[i], origin, direction);
    const bool front = between(c.Entry);
    const double distance = front ? c.Entry : c.Exit;
    if (c.Hit() && between(distance) && distance < best.Distance)
    {
      best.Cell = vtkIdType(i);
      best.Distance = distance;
      best.Normal = front ? c.EntryNormal : -c.ExitNormal;
    }
  }
  return best;
}

double PixelAngle(const View& view, const vec3& direction, int width, int height)
{
  constexpr double Step = 1e-5; // NDC: rounding and curvature both far below 1e-6
  const vec3 ndc = view.Forward(direction).Ndc;
  const auto ray = [&](
                     double x, double y) { return view.Ray(vec2(ndc.x + x, ndc.y + y)).Direction; };
  const vec3 dx = (ray(Step, 0) - ray(-Step, 0)) / (Step * width);
  const vec3 dy = (ray(0, Step) - ray(0, -Step)) / (Step * height);
  return std::sqrt(glm::length(glm::cross(dx, dy)));
}
}
}
