// SPDX-License-Identifier: BSD-3-Clause
#include "Displays.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
using wfv::vec2;
using wfv::vec3;

const wfv::WfvRay Nothing{ vec3(0), false };

// What a camera far behind the eye, that looks ahead, sees in a ball round it. Its middle shows the
// camera, its rim what lies ahead.
wfv::WfvRay MirrorBallRay(const vec2& place)
{
  const double s = glm::dot(place, place);
  if (s > 1)
  {
    return Nothing;
  }
  const double ahead = std::sqrt(1 - s); // of the ball's normal, towards the camera
  return { vec3(2 * ahead * place.x, 2 * ahead * place.y, 1 - 2 * s), true };
}

// Half of the sphere in each circle, its radius the angle: behind on the left, ahead on the right.
wfv::WfvRay DualFisheyeRay(const vec2& place)
{
  const double side = place.x < 0 ? -1 : 1;
  const vec2 at(2 * place.x - side, place.y);
  const double r = glm::length(at);
  if (r > 1)
  {
    return Nothing;
  }
  const double angle = 0.5 * wfv::WFV_PI * r;
  const vec2 along = r > 0 ? at / r : vec2(0);
  return {
    vec3(side * std::sin(angle) * along.x, std::sin(angle) * along.y, -side * std::cos(angle)), true
  };
}

// A face of the cube round the eye, upright: l, r, u, d, f, b; place: of it.
vec3 OnFace(char face, const vec2& place)
{
  const double x = place.x;
  const double y = place.y;
  switch (face)
  {
    case 'r':
      return { 1, y, x };
    case 'l':
      return { -1, y, -x };
    case 'u':
      return { x, 1, y };
    case 'd':
      return { x, -1, -y };
    case 'b':
      return { -x, y, 1 };
    default:
      return { x, y, -1 };
  }
}

// faces: so many columns and rows, the upper left one first; '.': none.
wfv::WfvRay CubeRay(const vec2& place, const char* faces, int columns, int rows)
{
  const vec2 at = 0.5 * (vec2(place.x, -place.y) + 1.0) * vec2(columns, rows);
  const int column = std::clamp(static_cast<int>(at.x), 0, columns - 1);
  const int row = std::clamp(static_cast<int>(at.y), 0, rows - 1);
  const char face = faces[row * columns + column];
  const vec2 on(2 * (at.x - column) - 1, 1 - 2 * (at.y - row));
  return face == '.' ? Nothing : wfv::WfvRay{ OnFace(face, on), true };
}

const Display Displays[] = {
  { "mirror-ball", { { 2048, 2048 } }, true, MirrorBallRay },
  { "dual-fisheye", { { 4096, 2048 } }, true, DualFisheyeRay },
  { "cube-3x2", { { 3072, 2048 } }, false,
    [](const vec2& place) { return CubeRay(place, "rludfb", 3, 2); } },
  { "cube-6x1", { { 6144, 1024 } }, false,
    [](const vec2& place) { return CubeRay(place, "rludfb", 6, 1); } },
  { "cube-cross", { { 4096, 3072 } }, false,
    [](const vec2& place) { return CubeRay(place, ".u..lfrb.d..", 4, 3); } },
};
}

std::vector<std::string> DisplayNames()
{
  std::vector<std::string> names;
  for (const Display& d : Displays)
  {
    names.push_back(d.Name);
  }
  return names;
}

const Display* FindDisplay(const std::string& name)
{
  const auto* const found = std::find_if(
    std::begin(Displays), std::end(Displays), [&name](const Display& d) { return name == d.Name; });
  return found == std::end(Displays) ? nullptr : found;
}

std::shared_ptr<const wfv::DirectionMap> MakeDisplay(const Display& display, int width, int height)
{
  const double wider = double(width) / height * display.Size[1] / display.Size[0];
  const vec2 fit = display.Round ? vec2(std::max(1.0, wider), std::max(1.0, 1 / wider)) : vec2(1);
  std::vector<float> directions;
  directions.reserve(3 * static_cast<std::size_t>(width) * height);
  for (int row = 0; row < height; row++)
  {
    for (int column = 0; column < width; column++)
    {
      const vec2 place = fit * (2.0 * (vec2(column, row) + 0.5) / vec2(width, height) - 1.0);
      const bool inside = std::abs(place.x) <= 1 && std::abs(place.y) <= 1;
      const wfv::WfvRay ray = inside ? display.Ray(place) : Nothing;
      const vec3 d = ray.inside ? glm::normalize(ray.direction) : vec3(0);
      for (int i = 0; i < 3; i++)
      {
        directions.push_back(static_cast<float>(d[i]));
      }
    }
  }
  return std::make_shared<const wfv::DirectionMap>(width, height, directions);
}
}
