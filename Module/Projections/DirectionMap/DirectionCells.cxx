// SPDX-License-Identifier: BSD-3-Clause
// Direction maps: where in the picture what lies round a place of the sphere is shown.
#include "Projections/DirectionMap/DirectionTables.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
using namespace tables;

namespace
{
Texel TexelOf(const vec4& v)
{
  return { { static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
    static_cast<float>(v.w) } };
}

void Unite(WfvPlaces& a, const WfvPlaces& b)
{
  a = wfvWithPlaces(a, b);
}

// The cells of one level.
struct Level
{
  int Cells;
  std::vector<WfvPlaces> Bounds;

  explicit Level(int cells)
    : Cells(cells)
    , Bounds(6 * static_cast<std::size_t>(cells) * cells, wfvNoPlaces())
  {
  }
  WfvPlaces& At(int column, int row)
  {
    return this->Bounds[static_cast<std::size_t>(row) * 6 * this->Cells + column];
  }
  const WfvPlaces& At(int column, int row) const
  {
    return this->Bounds[static_cast<std::size_t>(row) * 6 * this->Cells + column];
  }
};

// Unites a cell with what lies around it across a border of its face: seven by seven
// places up to a cell's width away.
WfvPlaces AroundBorder(const Level& level, int column, int row)
{
  const int face = column / level.Cells;
  const double angle = 0.5 * WFV_PI / level.Cells;
  WfvPlaces all = wfvNoPlaces();
  for (int i = -2; i <= 4; i++)
  {
    for (int j = -2; j <= 4; j++)
    {
      const double u = (column % level.Cells + 0.5 * i) * angle - 0.25 * WFV_PI;
      const double v = (row + 0.5 * j) * angle - 0.25 * WFV_PI;
      const vec3 d = wfvFromFace(vec3(std::tan(u), std::tan(v), 1), face);
      Unite(all, level.At(wfvCellColumn(d, level.Cells), wfvCellRow(d, level.Cells)));
    }
  }
  return all;
}

// Every cell with its eight neighbours.
Level Dilate(const Level& level)
{
  Level wide(level.Cells);
  const int last = level.Cells - 1;
  for (int row = 0; row <= last; row++)
  {
    for (int column = 0; column < 6 * level.Cells; column++)
    {
      const int i = column % level.Cells;
      if (i == 0 || i == last || row == 0 || row == last)
      {
        wide.At(column, row) = AroundBorder(level, column, row);
        continue;
      }
      for (int k = 0; k < 9; k++)
      {
        Unite(wide.At(column, row), level.At(column - 1 + k % 3, row - 1 + k / 3));
      }
    }
  }
  return wide;
}

// Stores each pixel in the cell of its direction, on the finest level that is coarse enough
// for it; level 0 holds those for which none is.
std::vector<Level> StorePixels(const DirectionMap& map)
{
  std::vector<Level> levels{ Level(WFV_COARSEST_CELLS / 2) };
  for (int cells = WFV_COARSEST_CELLS; cells <= map.GetCells(); cells *= 2)
  {
    levels.emplace_back(cells);
  }
  const int width = map.GetWidth();
  const int height = map.GetHeight();
  for (std::size_t i = 0; i < map.GetDirections().size(); i++)
  {
    const Texel& texel = map.GetDirections()[i];
    if (texel[3] == 0)
    {
      continue;
    }
    const int x = static_cast<int>(i % width);
    const int y = static_cast<int>(i / width);
    const double radius = RadiusOf(map, x, y);
    std::size_t l = levels.size() - 1;
    while (l > 0 && radius * levels[l].Cells > WFV_CAP_SHARE * 0.5 * WFV_PI)
    {
      l--;
    }
    const vec3 d = DirectionOf(texel);
    WfvPlaces pixel = wfvNoPlaces();
    pixel.first = vec4(
      2. * x / width - 1, 2. * y / height - 1, 2. * (x + 1) / width - 1, 2. * (y + 1) / height - 1);
    pixel.simple = (static_cast<int>(texel[3]) & WFV_PIXEL_SIMPLE) != 0;
    Unite(levels[l].At(wfvCellColumn(d, levels[l].Cells), wfvCellRow(d, levels[l].Cells)), pixel);
  }
  WfvPlaces everywhere = wfvNoPlaces();
  for (const WfvPlaces& cell : levels[0].Bounds)
  {
    Unite(everywhere, cell);
  }
  std::fill(levels[0].Bounds.begin(), levels[0].Bounds.end(), everywhere);
  return levels;
}

// Unites each cell with the one that holds it on the next coarser level.
void UniteWithCoarser(Level& level, const Level& coarser)
{
  for (int row = 0; row < level.Cells; row++)
  {
    for (int column = 0; column < 6 * level.Cells; column++)
    {
      Unite(level.At(column, row), coarser.At(column / 2, row / 2));
    }
  }
}

// Unites each cell with the four that it holds on the next finer level.
void UniteWithFiner(Level& level, const Level& finer)
{
  for (int row = 0; row < finer.Cells; row++)
  {
    for (int column = 0; column < 6 * finer.Cells; column++)
    {
      Unite(level.At(column / 2, row / 2), finer.At(column, row));
    }
  }
}

// Writes a level into its rows of the table.
void WriteLevel(const Level& level, int cells, std::vector<Texel>& table)
{
  for (int row = 0; row < level.Cells; row++)
  {
    for (int column = 0; column < 6 * level.Cells; column++)
    {
      const WfvPlaces& cell = level.At(column, row);
      const std::size_t line = level.Cells - WFV_COARSEST_CELLS + row;
      Texel* const texels = &table[2 * (line * 6 * cells + column)];
      texels[0] = TexelOf(cell.first);
      texels[1] = TexelOf(cell.second);
      texels[0][0] += cell.simple && cell.first.x <= 1 ? static_cast<float>(WFV_SIMPLE_CELL) : 0.f;
    }
  }
}
}

// A cell has what lies in it and its neighbours, on its own level and all finer ones, and
// what of coarser ones lies round the cell that holds it.
void DirectionMap::BoundCells()
{
  const std::vector<Level> own = StorePixels(*this);
  std::vector<Level> whole = own;
  for (std::size_t l = whole.size() - 1; l > 1; l--)
  {
    UniteWithFiner(whole[l - 1], whole[l]);
  }
  Level coarser = own[0];
  this->CellBounds.assign(12 * static_cast<std::size_t>(this->Cells) * this->GetCellBoundsHeight(),
    TexelOf(wfvNoPlaces().first));
  for (std::size_t l = 1; l < own.size(); l++)
  {
    Level wide = Dilate(whole[l]);
    UniteWithCoarser(wide, coarser);
    WriteLevel(wide, this->Cells, this->CellBounds);
    Level next = Dilate(own[l]);
    UniteWithCoarser(next, coarser);
    coarser = next;
  }
}
}
