// SPDX-License-Identifier: BSD-3-Clause
// A display described by one ray direction a pixel, and the tables by which the projection
// "direction-map" (direction-map.glsl) draws with it: pure mathematics, no VTK.
#ifndef WideFoVDirectionMap_h
#define WideFoVDirectionMap_h

#include "Projection.h"

#include <array>
#include <string>
#include <vector>

namespace wfv
{
// Immutable, so that views may share one.
class WFV_EXPORT DirectionMap
{
public:
  // Four numbers of a table.
  using Texel = std::array<float, 4>;

  // A picture of width x height directions, view coordinates (x right, y up, looking down
  // -z), three numbers a pixel, the bottom row first. Unit vectors within UnitSlack, or
  // 0, 0, 0 for a pixel that shows nothing. Directions must have passed Check.
  DirectionMap(int width, int height, const std::vector<float>& directions);

  // An empty string, or why these directions make no map: fewer than 2 x 2 pixels, another
  // count of numbers, a pixel that is no number or no unit vector, or none that shows
  // anything. Rows are counted from the top in what it says.
  static std::string Check(int width, int height, const std::vector<float>& directions);

  // How far the length of a direction may be from 1: what half precision leaves.
  static constexpr double UnitSlack = 2e-3;

  // A number that no other map has had.
  unsigned long GetSerial() const { return this->Serial; }

  // Pixels.
  int GetWidth() const { return this->Width; }
  // Pixels.
  int GetHeight() const { return this->Height; }

  // Cells along a face of the cube on the finest level: a power of two.
  int GetCells() const { return this->Cells; }

  // Width, height, cells and the longest step between neighbours that hang together (radians; 0
  // where none do), as wfv::WfvView has them.
  vec4 GetSizes() const { return { this->Width, this->Height, this->Cells, this->LongestStep }; }

  // The directions as a table of width x height, rows from the bottom.
  const std::vector<Texel>& GetDirections() const { return this->Directions; }

  // A table 12 cells wide, rows from the bottom: two rectangles a cell, all levels one above the
  // other. Where a cell has one rectangle the y of the other may say how even it is:
  // WfvPlaces::curvature.
  const std::vector<Texel>& GetCellBounds() const { return this->CellBounds; }

  // A table 12 cells wide, rows from the bottom: two seeds a texel, negative where there are no
  // more.
  const std::vector<Texel>& GetSeeds() const { return this->Seeds; }

  // Rows of GetCellBounds.
  int GetCellBoundsHeight() const { return 2 * this->Cells - 4; }

  // NDC of a unit vector from the pixel that looks nearest to it, found among all that may;
  // outside the picture where none does. For what the search from the seeds has missed.
  vec2 Find(const vec3& direction) const;

private:
  void MarkPixels();
  void ChooseCells();
  void BoundCells();
  void FindCellCurvature();
  void PlantSeeds();

  unsigned long Serial;
  int Width;
  int Height;
  int Cells = 4;
  double LongestStep = 0;
  std::vector<Texel> Directions;
  std::vector<Texel> CellBounds;
  std::vector<Texel> Seeds;
};

// What direction-map.glsl asks for, as the shaders have it from textures.
inline vec4 TexelOf(const std::vector<DirectionMap::Texel>& table, int width, int x, int y)
{
  const DirectionMap::Texel& t = table[static_cast<std::size_t>(y) * width + x];
  return vec4(t[0], t[1], t[2], t[3]);
}
inline vec4 wfvDirectionTexel(const WfvView& v, int x, int y)
{
  return TexelOf(v.map->GetDirections(), v.map->GetWidth(), x, y);
}
inline vec4 wfvCellTexel(const WfvView& v, int x, int y)
{
  return TexelOf(v.map->GetCellBounds(), 12 * v.map->GetCells(), x, y);
}
inline vec4 wfvSeedTexel(const WfvView& v, int x, int y)
{
  return TexelOf(v.map->GetSeeds(), 12 * v.map->GetCells(), x, y);
}
}

#endif
