// SPDX-License-Identifier: BSD-3-Clause
// Where the samples of a picture are.
#ifndef vtkWideFoVSampleGrid_h
#define vtkWideFoVSampleGrid_h

#include "Projections/Projection.h"

#include <array>

namespace wfv
{
// The samples of a framebuffer: one or several a pixel, the same in each.
class WFV_EXPORT SampleGrid
{
public:
  static constexpr int MostSamples = 16;

  // Takes the samples of the framebuffer that is bound. Where they cannot be known, nothing is
  // ever between them.
  void TakeBound();

  // From normalized device coordinates of the whole picture to pixels of the framebuffer's
  // viewport, from its lower left corner.
  void SetPlace(const vec2& scale, const vec2& shift)
  {
    this->Scale = scale;
    this->Shift = shift;
  }
  vec2 At(const vec2& ndc) const { return ndc * this->Scale + this->Shift; }

  // True where no sample is within a triangle of the picture or nearer to it than `grow`, pixels.
  // Looked into for triangles of a few pixels; never for larger ones, or where a corner is no
  // number.
  bool Misses(const vec2 corners[3], double grow) const;

  bool operator==(const SampleGrid& other) const;

private:
  std::array<vec2, MostSamples> Offsets{ { vec2(0.5) } }; // from a pixel's lower left corner
  int Count = 1;                                          // 0: not known
  vec2 Scale{ 1 };
  vec2 Shift{ 0 };
};
}

#endif
