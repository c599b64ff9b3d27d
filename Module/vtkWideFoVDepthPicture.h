// SPDX-License-Identifier: BSD-3-Clause
// How far away what is seen is, at each pixel of a picture.
#ifndef vtkWideFoVDepthPicture_h
#define vtkWideFoVDepthPicture_h

#include <cstddef>
#include <vector>

namespace wfv
{
class DepthPicture
{
public:
  // Reads a part (x, y, width, height in pixels) of the framebuffer that is bound to be drawn to.
  // False where it has several samples a pixel, or too many pixels.
  bool Read(const int part[4]);

  // Of a pixel that is there, from the lower left corner: window depth, 0 to 1.
  double GetDepth(int x, int y) const
  {
    return this->Depths[static_cast<std::size_t>(y) * this->Width + static_cast<std::size_t>(x)];
  }

  bool IsEmpty() const { return this->Depths.empty(); }

private:
  std::size_t Width = 0;
  std::vector<float> Depths;
};
}

#endif
