// SPDX-License-Identifier: BSD-3-Clause
#include "Projections/Bounds/LocalCurvature.h"

#include "Projections/Bounds/Curvature.h"

#include <algorithm>
#include <limits>

namespace wfv
{
namespace
{
// Along a face of the cube, and nodes along it: one more on either side.
constexpr int Cells = LocalCurvature::Cells;
constexpr int Nodes = Cells + 3;

// For what lies between the nodes; Testing/Unit/Projections/Bounds/LocalCurvatureTest.cxx looks
// there.
constexpr double LocalSafety = 1.25;

// Sine of the angle from a singular point below which there is no bound.
constexpr double LocalSingular = 0.05;

constexpr float Unbounded = std::numeric_limits<float>::infinity();

// A direction from its face (axis, and 3 more where it looks along the axis), and the two
// coordinates of the next axes over that of its own.
vec3 FromFace(int face, double s, double t)
{
  vec3 d(0);
  const int axis = face % 3;
  d[axis] = face < 3 ? -1 : 1;
  d[(axis + 1) % 3] = s;
  d[(axis + 2) % 3] = t;
  return glm::normalize(d);
}

std::vector<LocalCurvature::Around> FindNeighbours()
{
  std::vector<LocalCurvature::Around> all(LocalCurvature::NumberOfCells);
  for (std::size_t cell = 0; cell < all.size(); cell++)
  {
    const int face = static_cast<int>(cell / (Cells * Cells));
    const int i = static_cast<int>(cell / Cells % Cells);
    const int j = static_cast<int>(cell % Cells);
    for (int k = 0; k < 9; k++)
    {
      const int column = i + k % 3;
      const int row = j + k / 3;
      const double s = -1 + (2.0 * column - 1) / Cells;
      const double t = -1 + (2.0 * row - 1) / Cells;
      all[cell][k] = LocalCurvature::CellOf(FromFace(face, s, t));
    }
  }
  return all;
}

// Each cell holds for those round it as well.
std::vector<LocalCurvature::Cell> Spread(const std::vector<LocalCurvature::Cell>& table)
{
  const std::vector<LocalCurvature::Around>& neighbours = LocalCurvature::GetNeighbours();
  std::vector<LocalCurvature::Cell> wider(table);
  for (std::size_t cell = 0; cell < table.size(); cell++)
  {
    for (const std::size_t other : neighbours[cell])
    {
      for (int k = 0; k < 3; k++)
      {
        wider[cell][k] = std::max(wider[cell][k], table[other][k]);
      }
    }
  }
  return wider;
}

LocalCurvature::Cell NodeAt(const Projection& p, const WfvView& v, int face, int i, int j)
{
  const vec3 d = FromFace(face, -1 + 2.0 * (i - 1) / Cells, -1 + 2.0 * (j - 1) / Cells);
  if (SineToSingularity(p.Axis, d) < LocalSingular)
  {
    return { { Unbounded, Unbounded, Unbounded } };
  }
  const vec2 second = LocalSafety * SecondAt(p, v, d);
  const vec2 both = LocalSafety * FirstAt(p, v, d);
  const double first = std::max(both.x, both.y);
  const bool known = std::isfinite(second.x + second.y + first);
  return { { known ? float(second.x) : Unbounded, known ? float(second.y) : Unbounded,
    known ? float(first) : Unbounded } };
}
}

LocalCurvature::LocalCurvature(const Projection& p, const WfvView& v)
{
  std::vector<Cell>& table = this->Tables[0];
  table.assign(NumberOfCells, Cell{ { 0, 0, 0 } });
  for (int face = 0; face < 6; face++)
  {
    for (int i = 0; i < Nodes; i++)
    {
      for (int j = 0; j < Nodes; j++)
      {
        const Cell node = NodeAt(p, v, face, i, j);
        // every cell that it is a corner of, and their neighbours
        for (int k = std::max(0, i - 3); k <= std::min(Cells - 1, i); k++)
        {
          for (int l = std::max(0, j - 3); l <= std::min(Cells - 1, j); l++)
          {
            Cell& cell = table[(face * Cells + k) * Cells + l];
            cell = { { std::max(cell[0], node[0]), std::max(cell[1], node[1]),
              std::max(cell[2], node[2]) } };
          }
        }
      }
    }
  }
  for (int level = 1; level < Levels; level++)
  {
    // so many cells farther, and one more: across the faces' borders they do not lie in rows
    this->Tables[level] = this->Tables[level - 1];
    for (int i = 0; i <= 1 << (level - 1); i++)
    {
      this->Tables[level] = Spread(this->Tables[level]);
    }
  }
}

const std::vector<LocalCurvature::Around>& LocalCurvature::GetNeighbours()
{
  static const std::vector<Around> neighbours = FindNeighbours();
  return neighbours;
}
}
