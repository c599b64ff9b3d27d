// SPDX-License-Identifier: BSD-3-Clause
// Pictures larger than OpenGL draws at once: a window that shows one tile after the other.
#ifndef WideFoVTiles_h
#define WideFoVTiles_h

#include "vtkWideFoVAbi.h"

#include "ImageOutput.h"
#include "Options/Options.h"
#include "System/Display.h"

#include <functional>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// A picture in tiles of one size, from the lower left; those at the right and at the top may be
// smaller.
struct TileGrid
{
  std::array<int, 2> Picture; // pixels
  std::array<int, 2> Tile;
  PartOfPicture Part; // that the picture is; of itself, where it is whole

  int Count(int axis) const
  {
    return (this->Picture[axis] + this->Tile[axis] - 1) / this->Tile[axis];
  }

  // Pixels along an axis of tile number i.
  int Size(int axis, int i) const;

  // Tiles of which VTK's window has place for all of the larger picture.
  int Columns(int axis) const;

  // Of row number i from the top.
  int Rows(int i) const;
};

// Empty where the picture is drawn at once: it is within the limits, and no tiles were asked for.
// VTK's own pass over cube faces and a window that both eyes share cannot be drawn in tiles.
std::optional<TileGrid> PlanTiles(const Options& options, const GlLimits& limits);

// Makes the window as large as a tile, and its picture as large as the grid's.
void SetTiles(const TileGrid& grid, vtkRenderWindow* window, vtkRenderer* renderer);

// Makes the window as large as the picture, of which it shows the options' part.
void ShowPart(const Options& options, vtkRenderWindow* window, vtkRenderer* renderer);

// What the window draws next; rows are counted from the top.
void ShowTile(const TileGrid& grid, vtkRenderWindow* window, int column, int row);

// Draws eye number i of what the window shows.
using DrawEye = std::function<void(std::size_t i)>;

// Draws all tiles of all eyes, and gives the finished rows of picture number i, from the top, to
// `take`: one picture a file of a name, as the layout arranges them.
using TakeRows = std::function<void(std::size_t i, const Picture& rows)>;
void DrawTiles(const TileGrid& grid, const Options& options, vtkRenderWindow* window,
  std::size_t eyes, const DrawEye& draw, const TakeRows& take);
}

#endif
