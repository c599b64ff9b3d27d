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

// Of the angle from a pole or an antipode: no part of an edge is nearer than this share of what its
// ends are.
constexpr double Farther = 0.75;

// Tolerances: nearer to a pole what is off by one of them is bent.
constexpr double BesidePole = 32;

float LimitOf(const LocalBend& bends, std::size_t cell, const vec2& half, double tolerance)
{
  double limit = 0;
  double longest2 = LocalBend::LongestEdge * LocalBend::LongestEdge;
  for (int level = 0; level < LocalBend::Levels; level++, longest2 *= 4)
  {
    const LocalBend::Cell& bend = bends.OfCell(cell, level);
    const double pixels = std::hypot(bend[0] * half.x, bend[1] * half.y);
    // (0 where it is infinite)
    limit = std::max(limit, std::min(longest2, 8 * tolerance / pixels));
  }
  constexpr double longest = ChordLimits::LongestChord * ChordLimits::LongestChord;
  return static_cast<float>(std::min(limit, longest));
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

ChordLimits::ChordLimits(const Projection& projection, const WfvView& view, const LocalBend& bends,
  const vec2& pixels, double tolerance)
  : Axis(projection.Axis)
  , BesideSine2(0)
  , PerSine2(0)
{
  const bool singular =
    Axis == Family::Meridian || (Axis == Family::Azimuthal && !projection.FlatRim);
  if (singular && view.bend > 0)
  {
    this->PerSine2 = Farther * Farther * 8 * tolerance / (view.bend * 0.5 * glm::length(pixels));
  }
  const vec2 half = 0.5 * pixels;
  this->Limits.resize(LocalBend::NumberOfCells);
  this->Stretches.resize(LocalBend::NumberOfCells);
  for (std::size_t cell = 0; cell < LocalBend::NumberOfCells; cell++)
  {
    this->Limits[cell] = LimitOf(bends, cell, half, tolerance);
    this->Stretches[cell] = static_cast<float>(bends.OfCell(cell, 0)[2] * std::max(half.x, half.y));
  }
  const double beside = BesidePole * tolerance / this->StretchAt(vec3(0, 0, -1));
  this->BesideSine2 = beside * beside;
  std::vector<float> least(this->Limits);
  for (int ring = 0; ring < Rings; ring++)
  {
    // one more than twice as far, for across the faces' borders cells do not lie in rows
    for (int i = 0; i <= 1 << ring; i++)
    {
      least = LeastAroundEach(least);
    }
    this->Least[ring] = least;
  }
}

double ChordLimits::Sine2Of(const vec3& direction) const
{
  const vec3 d = glm::normalize(direction);
  return Axis == Family::Meridian            ? d.x * d.x + d.z * d.z
    : Axis == Family::Azimuthal && d.z > 0 ? d.x * d.x + d.y * d.y
                                           : 1;
}

bool ChordLimits::IsBesideSingularity(const vec3& direction) const
{
  return this->Sine2Of(direction) < this->BesideSine2;
}

float ChordLimits::NearSingularity(const vec3& direction) const
{
  const double sine2 = this->Sine2Of(direction);
  constexpr double share = (1 - Farther) * (1 - Farther);
  constexpr double longest = LongestChord * LongestChord;
  return static_cast<float>(std::min({ this->PerSine2, share, longest / sine2 }) * sine2);
}

float ChordLimits::LeastAround(const vec3& direction, double sine) const
{
  double reach = NarrowestCell;
  for (int ring = 0; ring < Rings; ring++, reach *= 2)
  {
    if (sine <= reach)
    {
      return this->Least[ring][LocalBend::CellOf(direction)];
    }
  }
  return 0;
}
}
