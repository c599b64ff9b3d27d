// SPDX-License-Identifier: BSD-3-Clause
// How long edges may look for their chords to stand for them.
#ifndef WideFoVChordLimits_h
#define WideFoVChordLimits_h

#include "LocalBend.h"

#include <vector>

namespace wfv
{
// For each cell of directions (wfv::LocalBend) the largest angle that an edge there may have so
// that its chord error, the distance between the edge and its chord in the picture, is within a
// tolerance. One number a cell: to classify a triangle is to look up one of them.
class WFV_EXPORT ChordLimits
{
public:
  // Radians: no longer edge has a limit, whatever the map. Depth and attributes are interpolated
  // along chords; a distance is then off by a quarter of the squared angle at the most.
  static constexpr double LongestChord = 0.08;

  // pixels: of the whole picture; tolerance: pixels.
  ChordLimits(const LocalBend& bends, const vec2& pixels, double tolerance);

  // Squared radians, 0 where no edge may. direction: of any length but 0, in the map's own frame,
  // of any point of the triangle.
  float At(const vec3& direction) const { return this->Limits[0][LocalBend::CellOf(direction)]; }

  // The least of all directions that are no farther from this one than an angle whose sine this is;
  // 0 where the angle is too large to say.
  float LeastAround(const vec3& direction, double sine) const;

  // Pixels a radian, by which the map stretches there at the most.
  float StretchAt(const vec3& direction) const
  {
    return this->Stretches[LocalBend::CellOf(direction)];
  }

private:
  static constexpr int Rings = 4; // a table of the least round each cell, of 1, 2, 4, .. cells

  std::vector<float> Limits[Rings + 1];
  std::vector<float> Stretches;
};
}

#endif
