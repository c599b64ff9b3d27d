// SPDX-License-Identifier: BSD-3-Clause
// Direction maps: where the picture of a straight edge is nearly straight.
#include "Projections/DirectionMap/DirectionTables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace wfv
{
using namespace tables;

namespace
{
// From pixel to pixel steps change by no more than WFV_SIMPLE_CHANGE of them, or than a half, a
// quarter,
// .. of it: so many degrees of evenness are told apart.
constexpr int Degrees = 8;

// Pixels of a rectangle along and across, together, times their curvature: up to this no two of its
// places see one direction, for no step is turned or stretched by as much as itself (e^0.64 - 1).
constexpr double OnePiece = 0.9;

double CurvatureOfDegree(int degree)
{
  return std::ldexp(WFV_SIMPLE_CHANGE, -degree);
}

// By how many steps along both axes a second difference of directions moves a place.
double InSteps(const vec3& h, const vec3& x, const vec3& y)
{
  const double a = glm::dot(x, x);
  const double b = glm::dot(x, y);
  const double c = glm::dot(y, y);
  const double det = a * c - b * b;
  const double hx = glm::dot(h, x);
  const double hy = glm::dot(h, y);
  return det > 0 ? std::hypot(c * hx - b * hy, a * hy - b * hx) / det
                 : std::numeric_limits<double>::infinity();
}

// How even the pixels of a map are: of each the degree, -1 where it hangs not together with the
// eight around it or changes faster than any.
class Evenness
{
public:
  explicit Evenness(const DirectionMap& map)
    : Map(map)
    , Width(map.GetWidth())
    , Height(map.GetHeight())
    , Of(map.GetDirections().size(), -1)
  {
    for (int y = 1; y + 1 < this->Height; y++)
    {
      for (int x = 1; x + 1 < this->Width; x++)
      {
        const double curvature = this->Hangs(x, y) ? this->CurvatureAt(x, y) : 1;
        int degree = -1;
        while (degree + 1 < Degrees && curvature <= CurvatureOfDegree(degree + 1))
        {
          degree++;
        }
        this->Of[this->IndexOf(x, y)] = static_cast<std::int8_t>(degree);
      }
    }
  }

  // Counts the pixels of a degree at the least, for AreAll.
  void Count(int degree)
  {
    this->Sums.assign(static_cast<std::size_t>(this->Width + 1) * (this->Height + 1), 0);
    for (int y = 0; y < this->Height; y++)
    {
      std::uint32_t row = 0;
      for (int x = 0; x < this->Width; x++)
      {
        row += this->Of[this->IndexOf(x, y)] >= degree ? 1 : 0;
        this->SumTo(x + 1, y + 1) = this->SumTo(x + 1, y) + row;
      }
    }
  }

  // All pixels from (x0, y0) to before (x1, y1) are counted.
  bool AreAll(int x0, int y0, int x1, int y1)
  {
    const std::uint32_t counted =
      this->SumTo(x1, y1) - this->SumTo(x0, y1) - this->SumTo(x1, y0) + this->SumTo(x0, y0);
    return counted == static_cast<std::uint32_t>(x1 - x0) * static_cast<std::uint32_t>(y1 - y0);
  }

private:
  std::size_t IndexOf(int x, int y) const { return static_cast<std::size_t>(y) * this->Width + x; }
  std::uint32_t& SumTo(int x, int y)
  {
    return this->Sums[static_cast<std::size_t>(y) * (this->Width + 1) + x];
  }
  vec3 At(int x, int y) const
  {
    return DirectionOf(this->Map.GetDirections()[this->IndexOf(x, y)]);
  }

  // The four squares that a pixel is a corner of do.
  bool Hangs(int x, int y) const
  {
    const auto square = [&](int i, int j) {
      const int bits = static_cast<int>(this->Map.GetDirections()[this->IndexOf(i, j)][3]);
      return (bits & WFV_PIXEL_SQUARE) != 0;
    };
    return square(x, y) && square(x - 1, y) && square(x, y - 1) && square(x - 1, y - 1);
  }

  // The largest of the second differences, in steps.
  double CurvatureAt(int x, int y) const
  {
    const vec3 d = this->At(x, y);
    const vec3 right = this->At(x + 1, y) - d;
    const vec3 left = d - this->At(x - 1, y);
    const vec3 up = this->At(x, y + 1) - d;
    const vec3 down = d - this->At(x, y - 1);
    const vec3 twists[4] = { this->At(x + 1, y + 1) - d - right - up,
      right + d - this->At(x + 1, y - 1) - down, up + d - this->At(x - 1, y + 1) - left,
      this->At(x - 1, y - 1) - d + left + down };
    const vec3 stepX = 0.5 * (right + left);
    const vec3 stepY = 0.5 * (up + down);
    double curvature =
      std::max(InSteps(right - left, stepX, stepY), InSteps(up - down, stepX, stepY));
    for (const vec3& twist : twists)
    {
      curvature = std::max(curvature, InSteps(twist, stepX, stepY));
    }
    return curvature;
  }

  const DirectionMap& Map;
  int Width;
  int Height;
  std::vector<std::int8_t> Of;
  std::vector<std::uint32_t> Sums;
};
}

// The rectangle of a cell is one piece where it is its only one and all pixels in it are as even as
// its size asks for.
void DirectionMap::FindCellCurvature()
{
  Evenness even(*this);
  const auto pixel = [](double ndc, int count) {
    return static_cast<int>(std::lround(0.5 * (ndc + 1) * count));
  };
  for (int degree = 0; degree < Degrees; degree++)
  {
    const double curvature = CurvatureOfDegree(degree);
    even.Count(degree);
    for (std::size_t i = 0; i < this->CellBounds.size(); i += 2)
    {
      const Texel& first = this->CellBounds[i];
      Texel& second = this->CellBounds[i + 1];
      const double left = first[0] > 0.5 * WFV_SIMPLE_CELL ? first[0] - WFV_SIMPLE_CELL : first[0];
      if (left > first[2] || second[0] <= second[2])
      {
        continue;
      }
      const int x0 = pixel(left, this->Width);
      const int y0 = pixel(first[1], this->Height);
      const int x1 = pixel(first[2], this->Width);
      const int y1 = pixel(first[3], this->Height);
      if (curvature * (x1 - x0 + y1 - y0) <= OnePiece && even.AreAll(x0, y0, x1, y1))
      {
        second[1] = static_cast<float>(curvature);
      }
    }
  }
}
}
