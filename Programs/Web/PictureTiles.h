// SPDX-License-Identifier: BSD-3-Clause
// Smaller pictures of a panorama, whole and in tiles.
#ifndef WideFoVPictureTiles_h
#define WideFoVPictureTiles_h

#include "Pictures/Picture.h"

#include <vector>

namespace widefov
{
// Scales a picture. Pixels of a smaller picture are means.
Picture Scale(const Picture& picture, int width, int height);

// One size of a panorama in tiles: twice as many columns as rows.
struct TileLevel
{
  int Width; // pixels
  int Columns;
};

// The sizes of a whole sphere of so many pixels across, the smallest first. The viewer takes powers
// of two as numbers of columns.
std::vector<TileLevel> PlanLevels(int width);

Picture CutTile(const Picture& picture, const TileLevel& level, int column, int row);
}

#endif
