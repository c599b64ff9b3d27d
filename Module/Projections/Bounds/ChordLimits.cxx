// SPDX-License-Identifier: BSD-3-Clause
#include "Projections/Bounds/ChordLimits.h"

#include "Projections/Bounds/Curvature.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wfv
{
namespace
{
// Radians: no cell is narrower, in the corners of the cube's faces.
constexpr double NarrowestCell = 0.03;

// Of the angle from a pole or an antipode: no part of an edge is nearer than this share of what its
// ends are.
constexpr double Farther = 0.75;

// Pixels, and tolerances besides: nearer to a pole or an antipode the map curves from pixel to
// pixel.
constexpr double BesidePole = 4;
constexpr double BesidePoleOff = 16;

// Angles are tried from this one on, radians, each larger by this factor, up to the largest.
constexpr double FirstAngle = 0.001;
constexpr double AngleFactor = 1.25;
constexpr double LargestAngle = 0.5;

// Pixels from the pole or antipode to what is seen so far from it, the least all round.
double LeastPixels(const Projection& map, const WfvView& view, const vec2& half, double angle)
{
  constexpr int ways = 16;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < ways; i++)
  {
    const double turn = 2 * WFV_PI * (i + 0.5) / ways; // none is at the seam
    const auto at = [&](double a) {
      const vec2 level(std::sin(a) * std::cos(turn), std::sin(a) * std::sin(turn));
      return map.Project(map.Axis == Family::Meridian ? vec3(level.x, std::cos(a), level.y)
                                                      : vec3(level.x, level.y, std::cos(a)),
        view);
    };
    least = std::min(least, glm::length(half * (at(angle) - at(0.01 * angle))));
  }
  return least;
}

// Sine of the angle within which no place is BesidePole or more away.
double SineBeside(const Projection& map, const WfvView& view, const vec2& half, double tolerance)
{
  double angle = FirstAngle;
  while (angle < LargestAngle &&
    LeastPixels(map, view, half, angle) < BesidePole + BesidePoleOff * tolerance)
  {
    angle *= AngleFactor;
  }
  return std::sin(angle);
}

float LimitOf(const LocalCurvature& table, std::size_t cell, const vec2& half, double tolerance)
{
  double limit = 0;
  double longest2 = LocalCurvature::LongestEdge * LocalCurvature::LongestEdge;
  for (int level = 0; level < LocalCurvature::Levels; level++, longest2 *= 4)
  {
    const LocalCurvature::Cell& curvature = table.OfCell(cell, level);
    const double pixels = std::hypot(curvature[0] * half.x, curvature[1] * half.y);
    // (0 where it is infinite)
    limit = std::max(limit, std::min(longest2, 8 * tolerance / pixels));
  }
  constexpr double longest = ChordLimits::LongestChord * ChordLimits::LongestChord;
  return static_cast<float>(std::min(limit, longest));
}

// better: which of two values is taken.
template <typename Better>
std::vector<float> BestAroundEach(const std::vector<float>& values, Better better)
{
  const std::vector<LocalCurvature::Around>& neighbours = LocalCurvature::GetNeighbours();
  std::vector<float> best(values);
  for (std::size_t cell = 0; cell < values.size(); cell++)
  {
    for (const std::size_t other : neighbours[cell])
    {
      best[cell] = better(best[cell], values[other]);
    }
  }
  return best;
}
}

ChordLimits::ChordLimits(const Projection& projection, const WfvView& view,
  const LocalCurvature& table, const vec2& pixels, double tolerance)
  : Axis(projection.Axis)
  , BesideSine(0)
  , PerSine2(0)
{
  const bool singular =
    Axis == Family::Meridian || (Axis == Family::Azimuthal && !projection.FlatRim);
  if (singular && view.curvature > 0)
  {
    this->PerSine2 =
      Farther * Farther * 8 * tolerance / (view.curvature * 0.5 * glm::length(pixels));
  }
  const vec2 half = 0.5 * pixels;
  this->Limits.resize(LocalCurvature::NumberOfCells);
  this->Stretches.resize(LocalCurvature::NumberOfCells);
  for (std::size_t cell = 0; cell < LocalCurvature::NumberOfCells; cell++)
  {
    this->Limits[cell] = LimitOf(table, cell, half, tolerance);
    this->Stretches[cell] = static_cast<float>(table.OfCell(cell, 0)[2] * std::max(half.x, half.y));
  }
  this->BesideSine = singular ? SineBeside(projection, view, half, tolerance) : 0;
  this->SpreadLimits();
}

void ChordLimits::SpreadLimits()
{
  const auto lesser = [](float a, float b) { return std::min(a, b); };
  const auto greater = [](float a, float b) { return std::max(a, b); };
  std::vector<float> least(this->Limits);
  std::vector<float> most(this->Stretches);
  for (int ring = 0; ring < Rings; ring++)
  {
    // one more than twice as far, for across the faces' borders cells do not lie in rows
    for (int i = 0; i <= 1 << ring; i++)
    {
      least = BestAroundEach(least, lesser);
      most = BestAroundEach(most, greater);
    }
    this->Least[ring] = least;
    this->MostStretches[ring] = most;
  }
}

float ChordLimits::NearSingularity(const vec3& direction, double aside) const
{
  const double sine = SineToSingularity(this->Axis, glm::normalize(direction)) - aside;
  if (!(sine > 0))
  {
    return 0;
  }
  const double sine2 = sine * sine;
  constexpr double share = (1 - Farther) * (1 - Farther);
  constexpr double longest = LongestChord * LongestChord;
  return static_cast<float>(std::min({ this->PerSine2, share, longest / sine2 }) * sine2);
}

float ChordLimits::LeastAround(const vec3& direction, double sine) const
{
  if (this->IsBesideSingularity(direction, sine))
  {
    return 0;
  }
  const int ring = RingOf(sine);
  if (ring == Rings)
  {
    return 0;
  }
  const float least = this->Least[ring][LocalCurvature::CellOf(direction)];
  return least < Coarse ? std::max(least, this->NearSingularity(direction, sine)) : least;
}

float ChordLimits::MostStretchAround(const vec3& direction, double sine) const
{
  const int ring = RingOf(sine);
  return ring == Rings ? std::numeric_limits<float>::infinity()
                       : this->MostStretches[ring][LocalCurvature::CellOf(direction)];
}

int ChordLimits::RingOf(double sine)
{
  int ring = 0;
  for (double widest = NarrowestCell; ring < Rings && !(sine <= widest); widest *= 2)
  {
    ring++;
  }
  return ring;
}
}
