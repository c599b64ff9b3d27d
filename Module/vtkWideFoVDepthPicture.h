// SPDX-License-Identifier: BSD-3-Clause
// How far away what is seen is, in parts of a picture.
#ifndef vtkWideFoVDepthPicture_h
#define vtkWideFoVDepthPicture_h

#include "Projections/Projection.h"

#include <vector>

namespace wfv
{
// The depths of a framebuffer, and the largest of ever larger blocks of them.
class WFV_EXPORT DepthPicture
{
public:
  // Reads a part (x, y, width, height in pixels) of the framebuffer that is bound to be drawn to.
  // False where it has several samples a pixel, or too many pixels.
  bool Read(const int part[4]);

  // Takes the depths of so many pixels, rows upwards, 0 to 1.
  void Take(int width, int height, std::vector<float> depths);

  // No smaller than the depth of any pixel that meets a rectangle, in pixels from the lower left
  // corner; 0 where none does, 1 where it is no number.
  double GetFarthest(const vec2& low, const vec2& high) const;

  // Of one pixel, which is there.
  double GetDepth(int x, int y) const
  {
    const Level& all = this->Levels.front();
    return all.Depths[static_cast<std::size_t>(y) * all.Width + x];
  }

  bool IsEmpty() const { return this->Levels.empty(); }
  void Clear() { this->Levels.clear(); }

private:
  struct Level
  {
    int Width;
    int Height;
    std::vector<float> Depths;
  };
  static Level Halve(const Level& level);

  std::vector<Level> Levels;
};
}

#endif
