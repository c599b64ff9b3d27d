// SPDX-License-Identifier: BSD-3-Clause
#include "Table.h"

#include <algorithm>

namespace wfv::displays
{
namespace
{
// Share of a triangle, and pixels of its bounds, by which a pixel's centre may lie outside: a
// centre on the edge of two triangles belongs to both, never to none.
constexpr double EdgeRounding = 1e-9;

struct Corner
{
  vec2 At; // pixels, from the centre of the lower left one
  const WarpNode* Node;
};

void DrawTriangle(const std::array<Corner, 3>& c, Raster& values, std::vector<float>& brightness)
{
  const vec2 right = c[1].At - c[0].At;
  const vec2 up = c[2].At - c[0].At;
  const double area = right.x * up.y - right.y * up.x;
  if (area == 0)
  {
    return;
  }
  const auto [left, most] = std::minmax({ c[0].At.x, c[1].At.x, c[2].At.x });
  const auto [low, high] = std::minmax({ c[0].At.y, c[1].At.y, c[2].At.y });
  const auto first = [](double x, int size) {
    return static_cast<int>(std::clamp(std::ceil(x - EdgeRounding), 0., double(size)));
  };
  const auto last = [](double x, int size) {
    return static_cast<int>(std::clamp(std::floor(x + EdgeRounding), -1., size - 1.));
  };
  for (int y = first(low, values.Height); y <= last(high, values.Height); y++)
  {
    for (int x = first(left, values.Width); x <= last(most, values.Width); x++)
    {
      const vec2 p = vec2(x, y) - c[0].At;
      const double b = (p.x * up.y - p.y * up.x) / area;
      const double d = (right.x * p.y - right.y * p.x) / area;
      if (std::min({ b, d, 1 - b - d }) >= -EdgeRounding)
      {
        const std::size_t i = static_cast<std::size_t>(y) * values.Width + x;
        const double a = 1 - b - d;
        values.Values[i] = a * c[0].Node->Shown + b * c[1].Node->Shown + d * c[2].Node->Shown;
        const double light =
          a * c[0].Node->Brightness + b * c[1].Node->Brightness + d * c[2].Node->Brightness;
        brightness[i] = static_cast<float>(std::clamp(light, 0., 1.));
      }
    }
  }
}
}

void DrawMesh(const WarpMesh& mesh, Raster& values, std::vector<float>& brightness)
{
  const std::size_t count = static_cast<std::size_t>(values.Width) * values.Height;
  values.Values.assign(count, vec3(std::nan("")));
  brightness.assign(count, 0);
  const vec2 size(values.Width, values.Height);
  const double aspect = mesh.HalfHeights ? size.x / size.y : 1;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.Triangles)
  {
    std::array<Corner, 3> corners{};
    for (int i = 0; i < 3; i++)
    {
      const WarpNode& node = mesh.Nodes[triangle[i]];
      const vec2 ndc(node.At.x / aspect, node.At.y);
      corners[i] = { (ndc + 1.) * 0.5 * size - 0.5, &node };
    }
    DrawTriangle(corners, values, brightness);
  }
}

Raster Resampled(const Raster& raster, int width, int height)
{
  if (raster.Width == width && raster.Height == height)
  {
    return raster;
  }
  Raster result{ width, height, {} };
  result.Values.reserve(static_cast<std::size_t>(width) * height);
  const auto place = [](int i, int size, int of) {
    return std::clamp((i + 0.5) * of / size - 0.5, 0., of - 1.);
  };
  for (int j = 0; j < height; j++)
  {
    for (int i = 0; i < width; i++)
    {
      const double x = place(i, width, raster.Width);
      const double y = place(j, height, raster.Height);
      const int x0 = std::min(static_cast<int>(x), raster.Width - 2);
      const int y0 = std::min(static_cast<int>(y), raster.Height - 2);
      const vec3* const at = &raster.Values[static_cast<std::size_t>(y0) * raster.Width + x0];
      const vec3 lower = glm::mix(at[0], at[1], x - x0);
      const vec3 upper = glm::mix(at[raster.Width], at[raster.Width + 1], x - x0);
      result.Values.push_back(glm::mix(lower, upper, y - y0));
    }
  }
  return result;
}

double MaskAt(const Mask& mask, double x, double y)
{
  const double column = std::clamp(x * mask.Width - 0.5, 0., mask.Width - 1.);
  const double row = std::clamp(y * mask.Height - 0.5, 0., mask.Height - 1.);
  const int x0 = std::max(0, std::min(static_cast<int>(column), mask.Width - 2));
  const int y0 = std::max(0, std::min(static_cast<int>(row), mask.Height - 2));
  const auto value = [&](int i, int j) {
    const int clampedX = std::min(i, mask.Width - 1);
    const int clampedY = std::min(j, mask.Height - 1);
    return double(mask.Values[static_cast<std::size_t>(clampedY) * mask.Width + clampedX]);
  };
  const double lower = glm::mix(value(x0, y0), value(x0 + 1, y0), column - x0);
  const double upper = glm::mix(value(x0, y0 + 1), value(x0 + 1, y0 + 1), column - x0);
  return glm::mix(lower, upper, row - y0);
}
}
