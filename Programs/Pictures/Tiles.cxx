// SPDX-License-Identifier: BSD-3-Clause
#include "Tiles.h"

#include "EyePictures.h"
#include "Frame.h"
#include "Options/StereoChoice.h"
#include "Options/StereoLayout.h"
#include "Options/StereoOptions.h"
#include "System/Progress.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace widefov
{
namespace
{
// Pixels along a side of a tile: powers of two, which leave a tile's rounding as it is in the
// whole picture, and small enough for several samples a pixel.
constexpr int TileSide = 2048;

// Pixels of a picture that is drawn at once, at the most: a gigabyte with four samples each.
constexpr long LargestAtOnce = 1L << 25;

// Column by column of one row of tiles.
Picture DrawRow(
  const TileGrid& grid, vtkRenderWindow* window, int row, std::size_t eye, const DrawEye& draw)
{
  Picture band;
  band.Width = grid.Picture[0];
  band.Height = grid.Rows(row);
  band.Rgb.resize(3 * static_cast<std::size_t>(band.Width) * band.Height);
  vtkNew<vtkUnsignedCharArray> pixels;
  for (int column = 0; column < grid.Count(0); column++)
  {
    ShowTile(grid, window, column, row);
    draw(eye);
    const int width = grid.Size(0, column);
    window->GetPixelData(0, 0, width - 1, band.Height - 1, 0, pixels);
    for (int j = 0; j < band.Height; j++)
    {
      const unsigned char* const from =
        pixels->GetPointer(3 * static_cast<vtkIdType>(width) * (band.Height - 1 - j));
      const std::size_t at =
        static_cast<std::size_t>(j) * band.Width + static_cast<std::size_t>(column) * grid.Tile[0];
      std::copy(from, from + 3 * static_cast<std::ptrdiff_t>(width), &band.Rgb[3 * at]);
    }
  }
  return band;
}

// An even number, so that pairs of pixels that belong together stay together.
int FitTile(int wanted, int picture)
{
  return wanted >= picture ? picture : std::max(2, wanted / 2 * 2);
}

bool OneBelowTheOther(const Options& o)
{
  return HasTwoEyes(o) && FindStereoLayout(o.Layout).Rows == 2;
}
}

int TileGrid::Columns(int axis) const
{
  const int end =
    std::max(this->Part.Whole[axis], this->Part.Start[axis] + this->Count(axis) * this->Tile[axis]);
  return (end + this->Tile[axis] - 1) / this->Tile[axis];
}

int TileGrid::Rows(int row) const
{
  return this->Size(1, this->Count(1) - 1 - row);
}

int TileGrid::Size(int axis, int i) const
{
  return std::min(this->Tile[axis], this->Picture[axis] - i * this->Tile[axis]);
}

std::optional<TileGrid> PlanTiles(const Options& o, const GlLimits& limits)
{
  if (o.Technique == Technique::CubeMap || !EyesFitTiles(o))
  {
    return std::nullopt;
  }
  const bool large = static_cast<long>(o.Size[0]) * o.Size[1] > LargestAtOnce;
  if (!o.Part && !o.Tile && !large && o.Size[0] <= limits.Width && o.Size[1] <= limits.Height)
  {
    return std::nullopt;
  }
  const std::array<int, 2> wanted = o.Tile.value_or(std::array<int, 2>{ { TileSide, TileSide } });
  TileGrid grid;
  grid.Picture = o.Size;
  grid.Tile = { { FitTile(std::min(wanted[0], limits.Width), o.Size[0]),
    FitTile(std::min(wanted[1], limits.Height), o.Size[1]) } };
  grid.Part = o.Part.value_or(PartOfPicture{ o.Size, { { 0, 0 } } });
  return grid;
}

void SetTiles(const TileGrid& grid, vtkRenderWindow* window, vtkRenderer* renderer)
{
  // the last tiles hang over; the picture is that part of the grid. It begins at the lower left
  // corner, so that pixels come in the same pairs, which fragment shaders are run in.
  const int nx = grid.Columns(0);
  const int ny = grid.Columns(1);
  window->SetSize(grid.Tile[0], grid.Tile[1]);
  window->SetTileScale(nx, ny);
  const double right = grid.Part.Whole[0] / (static_cast<double>(nx) * grid.Tile[0]);
  const double height = grid.Part.Whole[1] / (static_cast<double>(ny) * grid.Tile[1]);
  renderer->SetViewport(0, 0, right, height);
}

void ShowPart(const Options& o, vtkRenderWindow* window, vtkRenderer* renderer)
{
  const TileGrid once{ o.Size, o.Size, o.Part.value_or(PartOfPicture{ o.Size, { { 0, 0 } } }) };
  SetTiles(once, window, renderer);
  ShowTile(once, window, 0, 0);
}

void ShowTile(const TileGrid& grid, vtkRenderWindow* window, int column, int row)
{
  const double width = static_cast<double>(grid.Columns(0)) * grid.Tile[0];
  const double height = static_cast<double>(grid.Columns(1)) * grid.Tile[1];
  const double left = grid.Part.Start[0] + column * grid.Tile[0];
  const double bottom = grid.Part.Start[1] + (grid.Count(1) - 1 - row) * grid.Tile[1];
  window->SetTileViewport(
    left / width, bottom / height, (left + grid.Tile[0]) / width, (bottom + grid.Tile[1]) / height);
}

void DrawTiles(const TileGrid& grid, const Options& o, vtkRenderWindow* window, std::size_t eyes,
  const DrawEye& draw, const TakeRows& take)
{
  Progress progress("drawing in tiles");
  const StereoLayout& layout = FindStereoLayout(o.Layout);
  const bool below = OneBelowTheOther(o);
  const int rows = grid.Count(1);
  for (std::size_t outer = 0; outer < (below ? eyes : 1); outer++)
  {
    for (int row = 0; row < rows; row++)
    {
      std::vector<Picture> bands;
      for (std::size_t eye = below ? outer : 0; eye < (below ? outer + 1 : eyes); eye++)
      {
        bands.push_back(DrawRow(grid, window, row, eye, draw));
      }
      if (below && layout.Half)
      {
        bands[0] = Halve(bands[0], true);
      }
      else if (!below && eyes > 1)
      {
        bands = Arrange(layout, bands);
      }
      for (std::size_t i = 0; i < bands.size(); i++)
      {
        take(i, bands[i]);
      }
      progress.Update((row + 1.0 + static_cast<double>(outer) * rows) / (below ? 2 * rows : rows));
    }
  }
}
}
