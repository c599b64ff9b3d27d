// SPDX-License-Identifier: BSD-3-Clause
// Direction maps: pixels from which the search for a direction starts.
#include "Projections/DirectionMap/DirectionTables.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
using namespace tables;

namespace
{
// Pixels: seeds of one cell that are farther apart lie on different pieces of the map.
constexpr double SeedGap = 8;

// Cells that the seeds of one spread to.
constexpr int SpreadRounds = 4;

// The seeds of the cells of one level, a round at a time: in each round the pixel nearest to
// the middle of its cell that is far from the cell's earlier seeds.
class SeedBed
{
public:
  explicit SeedBed(const DirectionMap& map)
    : Map(map)
    , Columns(6 * map.GetCells())
    , Cells(map.GetDirections().size(), -1)
    , Seeds(static_cast<std::size_t>(this->Columns) * map.GetCells())
  {
    const int cells = map.GetCells();
    for (std::size_t i = 0; i < this->Cells.size(); i++)
    {
      const Texel& texel = map.GetDirections()[i];
      if (texel[3] != 0)
      {
        const vec3 d = DirectionOf(texel);
        this->Cells[i] = wfvCellRow(d, cells) * this->Columns + wfvCellColumn(d, cells);
      }
    }
    for (int round = 0; round < WFV_CELL_SEEDS; round++)
    {
      this->Plant(round);
    }
    this->Spread();
  }

  std::vector<Texel> GetTexels() const
  {
    std::vector<Texel> texels;
    for (const auto& seeds : this->Seeds)
    {
      for (int i = 0; i < WFV_CELL_SEEDS; i += 2)
      {
        texels.push_back({ { static_cast<float>(seeds[i].x), static_cast<float>(seeds[i].y),
          static_cast<float>(seeds[i + 1].x), static_cast<float>(seeds[i + 1].y) } });
      }
    }
    return texels;
  }

private:
  struct CellSeeds : std::array<vec2, WFV_CELL_SEEDS>
  {
    CellSeeds() { this->fill(vec2(-1, -1)); }
  };

  vec3 MiddleOf(std::size_t cell) const
  {
    const int cells = this->Map.GetCells();
    const int column = static_cast<int>(cell % this->Columns);
    const int row = static_cast<int>(cell / this->Columns);
    const double angle = 0.5 * WFV_PI / cells;
    const vec3 q(std::tan((column % cells + 0.5) * angle - 0.25 * WFV_PI),
      std::tan((row + 0.5) * angle - 0.25 * WFV_PI), 1);
    return glm::normalize(wfvFromFace(q, column / cells));
  }

  void Plant(int round)
  {
    std::vector<double> best(this->Seeds.size(), -2);
    for (std::size_t i = 0; i < this->Cells.size(); i++)
    {
      const int cell = this->Cells[i];
      if (cell < 0)
      {
        continue;
      }
      const vec2 pixel(i % this->Map.GetWidth(), i / this->Map.GetWidth());
      CellSeeds& seeds = this->Seeds[cell];
      const bool apart = std::all_of(seeds.begin(), seeds.begin() + round,
        [&](const vec2& s) { return s.x >= 0 && glm::distance(s, pixel) > SeedGap; });
      if (!apart)
      {
        continue;
      }
      const double near = glm::dot(this->MiddleOf(cell), DirectionOf(this->Map.GetDirections()[i]));
      if (near > best[cell])
      {
        best[cell] = near;
        seeds[round] = pixel;
      }
    }
  }

  // A cell without pixels takes the seeds of a neighbour in its row or column: between the
  // pixels of a coarse map, and beside its borders.
  void Spread()
  {
    for (int round = 0; round < SpreadRounds; round++)
    {
      const std::vector<CellSeeds> before = this->Seeds;
      for (std::size_t i = 0; i < before.size(); i++)
      {
        for (std::size_t j : { i - 1, i + 1, i - this->Columns, i + this->Columns })
        {
          if (this->Seeds[i][0].x < 0 && j < before.size())
          {
            this->Seeds[i] = before[j];
          }
        }
      }
    }
  }

  const DirectionMap& Map;
  int Columns;
  std::vector<int> Cells; // of each pixel
  std::vector<CellSeeds> Seeds;
};
}

vec2 DirectionMap::Find(const vec3& direction) const
{
  WfvView view{};
  view.tables = this->GetSizes();
  view.map = this;
  const WfvPlaces places = wfvCapPlaces(direction, 0, view);
  double nearest = -2;
  vec2 pixel(0);
  for (const vec4& r : { places.first, places.second })
  {
    const int x1 = std::min(this->Width - 1, static_cast<int>(0.5 * (r.z + 1) * this->Width));
    const int y1 = std::min(this->Height - 1, static_cast<int>(0.5 * (r.w + 1) * this->Height));
    for (int y = std::max(0, static_cast<int>(0.5 * (r.y + 1) * this->Height)); y <= y1; y++)
    {
      for (int x = std::max(0, static_cast<int>(0.5 * (r.x + 1) * this->Width)); x <= x1; x++)
      {
        const Texel& texel = this->Directions[static_cast<std::size_t>(y) * this->Width + x];
        const double near = texel[3] != 0 ? glm::dot(DirectionOf(texel), direction) : -2;
        if (near > nearest)
        {
          nearest = near;
          pixel = vec2(x, y);
        }
      }
    }
  }
  const vec3 found = nearest > -2 ? wfvFindFrom(pixel, direction, view) : vec3(0, 0, 1e9);
  return found.z < WFV_SEARCH_REST ? wfvNdcOfPixel(vec2(found.x, found.y), view)
                                   : vec2(WFV_ELSEWHERE, WFV_ELSEWHERE);
}

void DirectionMap::PlantSeeds()
{
  this->Seeds = SeedBed(*this).GetTexels();
}
}
