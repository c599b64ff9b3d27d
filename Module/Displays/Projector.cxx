// SPDX-License-Identifier: BSD-3-Clause
#include "Projector.h"

#include "Readers.h"

namespace wfv::displays
{
namespace
{
// Newton steps of the lens's inverse, and the rest that is none, in focal lengths.
constexpr int LensSteps = 50;
constexpr double LensRest = 1e-12;

// Reflects a ray in the mirror. Returns false if the ray misses the mirror.
bool Reflect(const SphereMirror& mirror, vec3& origin, vec3& direction)
{
  SphereSurface ball;
  ball.Center = mirror.Center;
  ball.Radius = mirror.Radius;
  const double distance = ball.Meet(origin, direction);
  if (distance == Surface::Nowhere)
  {
    return false;
  }
  origin += distance * direction;
  const vec3 normal = (origin - mirror.Center) / mirror.Radius;
  direction -= 2 * glm::dot(direction, normal) * normal;
  return true;
}
}

glm::dmat3 LookAlong(const vec3& direction, const vec3& up)
{
  const vec3 behind = -glm::normalize(direction);
  const vec3 right = glm::normalize(glm::cross(up, behind));
  return glm::dmat3(right, glm::cross(behind, right), behind);
}

Content ThrowLens(double throwRatio, double aspect, vec2 shift)
{
  Frustum frustum;
  frustum.Left = (shift.x - 0.5) / throwRatio;
  frustum.Right = (shift.x + 0.5) / throwRatio;
  frustum.Down = (shift.y - 0.5) / (throwRatio * aspect);
  frustum.Up = (shift.y + 0.5) / (throwRatio * aspect);
  return [frustum](vec2 uv) { return frustum.DirectionAt(uv); };
}

vec3 CameraLens::operator()(vec2 uv) const
{
  const auto [k1, k2, p1, p2, k3] = this->Distortion;
  const vec2 pixel(uv.x * this->Size.x - 0.5, (1 - uv.y) * this->Size.y - 0.5);
  const vec2 seen = (pixel - this->Axis) / this->Focal;
  vec2 p = seen;
  for (int i = 0; i < LensSteps; i++)
  {
    const double r2 = glm::dot(p, p);
    const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const double slope = 2 * (k1 + r2 * (2 * k2 + r2 * 3 * k3)); // d radial / d x, divided by x
    const vec2 distorted = p * radial +
      vec2(2 * p1 * p.x * p.y + p2 * (r2 + 2 * p.x * p.x),
        p1 * (r2 + 2 * p.y * p.y) + 2 * p2 * p.x * p.y);
    const vec2 rest = seen - distorted;
    const double a = radial + slope * p.x * p.x + 2 * p1 * p.y + 6 * p2 * p.x;
    const double b = slope * p.x * p.y + 2 * p1 * p.x + 2 * p2 * p.y;
    const double d = radial + slope * p.y * p.y + 6 * p1 * p.y + 2 * p2 * p.x;
    const double det = a * d - b * b;
    if (!(det > 0))
    {
      break; // the lens folds here
    }
    p += vec2(d * rest.x - b * rest.y, a * rest.y - b * rest.x) / det;
    if (glm::dot(rest, rest) < LensRest * LensRest)
    {
      return glm::normalize(vec3(p.x, -p.y, -1));
    }
  }
  return vec3(std::nan(""));
}

Table CastTable(const Projector& projector, const Surface& surface, int width, int height,
  const std::optional<SphereMirror>& mirror)
{
  Table table;
  table.Width = width;
  table.Height = height;
  table.What = Shows::Point;
  table.Values.assign(table.Count(), vec3(std::nan("")));
  table.Brightness.assign(table.Count(), 0);
  table.Center = mirror ? std::nullopt : std::optional<vec3>(projector.Position);
  bool any = false;
  for (std::size_t i = 0; i < table.Count(); i++)
  {
    const vec2 uv((double(i % width) + 0.5) / width, (double(i / width) + 0.5) / height);
    vec3 origin = projector.Position;
    vec3 direction = projector.Rotation * projector.Lens(uv);
    if (std::isnan(direction.x) || (mirror && !Reflect(*mirror, origin, direction)))
    {
      continue;
    }
    const double distance = surface.Meet(origin, direction);
    if (distance < Surface::Nowhere)
    {
      table.Values[i] = origin + distance * direction;
      table.Brightness[i] = 1;
      any = true;
    }
  }
  if (!any)
  {
    throw FileError("no ray of the projector meets the surface; check where both are");
  }
  return table;
}
}
