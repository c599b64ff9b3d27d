// SPDX-License-Identifier: BSD-3-Clause
#include "PictureTiles.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>

namespace widefov
{
namespace
{
constexpr int LargestSide = 1280;   // of a tile, pixels
constexpr int MostColumns = 64;     // of Photo Sphere Viewer's sphere
constexpr int SmallestLevel = 8192; // pixels across, about; the page has a picture of 4096 as well
}

Picture Scale(const Picture& picture, int width, int height)
{
  if (picture.Width == width && picture.Height == height)
  {
    return picture;
  }
  const auto spec = [](int w, int h) { return OIIO::ImageSpec(w, h, 3, OIIO::TypeDesc::UINT8); };
  const OIIO::ImageBuf from(spec(picture.Width, picture.Height),
    const_cast<unsigned char*>(picture.Rgb.data())); // it is only read
  Picture scaled{ width, height, std::vector<unsigned char>(std::size_t(3) * width * height) };
  OIIO::ImageBuf to(spec(width, height), scaled.Rgb.data());
  OIIO::ImageBufAlgo::resize(to, from, width < picture.Width ? "box" : "lanczos3");
  return scaled;
}

std::vector<TileLevel> PlanLevels(int width)
{
  int columns = 1;
  while (columns < MostColumns && columns * LargestSide < width)
  {
    columns *= 2;
  }
  std::vector<TileLevel> levels;
  for (int side = (width + columns - 1) / columns; columns > 1; columns /= 2)
  {
    levels.insert(levels.begin(), TileLevel{ columns * side, columns });
    if (columns * side <= SmallestLevel)
    {
      break;
    }
  }
  return levels;
}

Picture CutTile(const Picture& picture, const TileLevel& level, int column, int row)
{
  const int side = level.Width / level.Columns;
  Picture tile{ side, side, {} };
  tile.Rgb.reserve(std::size_t(3) * side * side);
  for (int j = row * side; j < (row + 1) * side; j++)
  {
    const auto from = picture.Rgb.begin() +
      static_cast<std::ptrdiff_t>(3) * (std::ptrdiff_t(j) * picture.Width + column * side);
    tile.Rgb.insert(tile.Rgb.end(), from, from + std::ptrdiff_t(3) * side);
  }
  return tile;
}
}
