// SPDX-License-Identifier: BSD-3-Clause
// How far places of a projector's picture are from its edge.
#ifndef WideFoVDisplaysEdgeDistance_h
#define WideFoVDisplaysEdgeDistance_h

#include "Table.h"

namespace wfv::displays
{
class EdgeDistance
{
public:
  explicit EdgeDistance(const Table& table);

  // How far a place (pixels from the centre of the lower left one) is inside: 0 at the centres of
  // the first pixels outside of the picture and of pixels that show nothing, below 1 in the middle.
  // Smooth.
  double At(double x, double y) const;

private:
  int Width; // pixels
  int Height;
  std::vector<float> Distances; // pixels, to the nearest one that shows nothing
};
}

#endif
