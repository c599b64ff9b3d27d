// SPDX-License-Identifier: BSD-3-Clause
#include "ChordLimits.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace
{
// Radians: no cell is narrower, in the corners of the cube's faces.
constexpr double NarrowestCell = 0.03;

float LimitOf(const LocalBend& bends, std::size_t cell, const vec2& half, double tolerance)
{
  double limit = 0;
  double longest2 = LocalBend::LongestEdge * LocalBend::LongestEdge;
  for (int level = 0; level < LocalBend::Levels; level++, longest2 *= 4)
  {
    const LocalBend::Cell& bend = bends.OfCell(cell, level);
    const double pixels = std::hypot(bend[0] * half.x, bend[1] * half.y);
    limit = std::max(limit, std::min(longest2, 8 * tolerance / pixels)); // 0 where it is infinite
  }
  return static_cast<float>(
    std::min(limit, ChordLimits::LongestChord * ChordLimits::LongestChord));
}

std::vector<float> LeastAroundEach(const std::vector<float>& limits)
{
  const std::vector<LocalBend::Around>& neighbours = LocalBend::GetNeighbours();
  std::vector<float> least(limits);
  for (std::size_t cell = 0; cell < limits.size(); cell++)
  {
    for (const std::size_t other : neighbours[cell])
    {
      least[cell] = std::min(least[cell], limits[other]);
    }
  }
  return least;
}
}

ChordLimits::ChordLimits(const LocalBend& bends, const vec2& pixels, double tolerance)
{
  const vec2 half = 0.5 * pixels;
  this->Limits[0].resize(LocalBend::NumberOfCells);
  this->Stretches.resize(LocalBend::NumberOfCells);
  for (std::size_t cell = 0; cell < LocalBend::NumberOfCells; cell++)
  {
    this->Limits[0][cell] = LimitOf(bends, cell, half, tolerance);
    this->Stretches[cell] =
      static_cast<float>(bends.OfCell(cell, 0)[2] * std::max(half.x, half.y));
  }
  for (int ring = 1; ring <= Rings; ring++)
  {
    // one more than twice as far, for across the faces' borders cells do not lie in rows
    this->Limits[ring] = this->Limits[ring - 1];
    for (int i = 0; i <= 1 << (ring - 1); i++)
    {
      this->Limits[ring] = LeastAroundEach(this->Limits[ring]);
    }
  }
}

float ChordLimits::LeastAround(const vec3& direction, double sine) const
{
  double reach = NarrowestCell;
  for (int ring = 1; ring <= Rings; ring++, reach *= 2)
  {
    if (sine <= reach)
    {
      return this->Limits[ring][LocalBend::CellOf(direction)];
    }
  }
  return 0;
}
}
