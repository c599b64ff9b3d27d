// SPDX-License-Identifier: BSD-3-Clause
// How far chords are from the edges that they stand for, place by place.
#ifndef WideFoVLocalCurvature_h
#define WideFoVLocalCurvature_h

#include "Projections/Projection.h"

#include <algorithm>
#include <array>
#include <vector>

namespace wfv
{
// wfv::Curvature bounds a whole view by its worst place; this is a table of directions, the cells
// of a cube's faces, each with a bound for itself and its neighbours. A chord of an edge of the
// angle a (radians), which is at most a cell's (LongestEdge), is at most At(d) a^2 / 8 away from
// its edge on either axis, NDC, with d any direction of the edge, as long as the edge crosses no
// discontinuity. Infinite near the points that the family stretches without bound. A third number
// bounds the stretch: how far a place moves, NDC, per radian that the direction turns. Of longer
// edges coarser levels of the table say as much, each with a bound for all that is near its cells.
class WFV_EXPORT LocalCurvature
{
public:
  static constexpr double LongestEdge = 0.03; // radians; cells measure from 0.031 (corners) on

  static constexpr int Levels = 4; // each is for edges twice as long as the one before it

  LocalCurvature(const Projection& projection, const WfvView& view);

  // Curvature along x and y, NDC per radian squared; stretch, NDC per radian.
  using Cell = std::array<float, 3>;

  // direction: of any length but 0, in the map's own frame (behind the tilt).
  const Cell& At(const vec3& direction, int level = 0) const
  {
    return this->OfCell(CellOf(direction), level);
  }
  const Cell& OfCell(std::size_t cell, int level) const { return this->Tables[level][cell]; }

  // Cells of the finest level, which a direction is in one of, some cell also where it is no number
  // or has no length; and of each those round it, and itself.
  static constexpr int Cells = 32; // along a face of the cube
  static constexpr std::size_t NumberOfCells = 6 * Cells * Cells;
  static std::size_t CellOf(const vec3& direction)
  {
    const vec3 a = glm::abs(direction);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    const int face = direction[axis] < 0 ? axis : axis + 3;
    const double scale = 0.5 * Cells / a[axis];
    const int i = IndexOf(0.5 * Cells + direction[(axis + 1) % 3] * scale);
    const int j = IndexOf(0.5 * Cells + direction[(axis + 2) % 3] * scale);
    return static_cast<std::size_t>((face * Cells + i) * Cells + j);
  }
  using Around = std::array<std::size_t, 9>;
  static const std::vector<Around>& GetNeighbours();

private:
  // (of NaN the greater of 0 and it is 0)
  static int IndexOf(double place)
  {
    return static_cast<int>(std::min(Cells - 1.0, std::max(0.0, place)));
  }

  std::vector<Cell> Tables[Levels];
};
}

#endif
