// SPDX-License-Identifier: BSD-3-Clause
// Where the samples of a picture are.
#ifndef vtkWideFoVSampleGrid_h
#define vtkWideFoVSampleGrid_h

#include "Projections/Projection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wfv
{
// The samples of a framebuffer: one or several a pixel, the same in each.
class WFV_EXPORT SampleGrid
{
public:
  static constexpr int MostSamples = 16;

  // Pixels: half a pixel, seen across a way that is as steep as it is wide.
  static constexpr double NearestRow = 0.35;

  // Takes the samples of the framebuffer that is bound. Where they cannot be known, nothing is
  // ever between them.
  void TakeBound();

  bool AreKnown() const { return this->Count > 0; }

  // From normalized device coordinates of the whole picture to pixels of the framebuffer's
  // viewport, from its lower left corner.
  // size: pixels of the viewport.
  void SetPlace(const vec2& scale, const vec2& shift, const vec2& size)
  {
    this->Scale = scale;
    this->Shift = shift;
    this->Size = size;
  }
  const vec2& GetSize() const { return this->Size; }
  vec2 At(const vec2& ndc) const { return ndc * this->Scale + this->Shift; }
  vec2 NdcAt(const vec2& pixels) const { return (pixels - this->Shift) / this->Scale; }

  // True where no sample is within a triangle of the picture or nearer to it than `grow`, pixels.
  // Looked into for triangles of a few pixels; never for larger ones, or where a corner is no
  // number.
  bool Misses(const vec2 corners[3], double grow) const;

  // Calls visit(number of the sample, its distance in pixels) for the samples of the viewport that
  // are no farther from the way between two places than `near`, of which there are none but within
  // NearestRow.
  template <typename Visit>
  void ForEachNear(const vec2& from, const vec2& to, double near, const Visit& visit) const;

  // Where the sample of such a number is.
  vec2 SampleAt(unsigned int number) const;

  bool operator==(const SampleGrid& other) const;

private:
  std::array<vec2, MostSamples> Offsets{ { vec2(0.5) } }; // from a pixel's lower left corner
  int Count = 1;                                          // 0: not known
  vec2 Scale{ 1 };
  vec2 Shift{ 0 };
  vec2 Size{ 0 };
};

// Along the longer axis pixel by pixel: beside each place at most one row of samples is so near.
template <typename Visit>
void SampleGrid::ForEachNear(
  const vec2& from, const vec2& to, double near, const Visit& visit) const
{
  near = std::min(near, NearestRow);
  const vec2 way = to - from;
  const int axis = std::abs(way.x) >= std::abs(way.y) ? 0 : 1;
  const double length2 = glm::dot(way, way);
  const double first = std::max(std::floor(std::min(from[axis], to[axis]) - near), 0.0);
  const double last =
    std::min(std::floor(std::max(from[axis], to[axis]) + near), this->Size[axis] - 1);
  for (double x = first; x <= last; x++)
  {
    for (int i = 0; i < this->Count; i++)
    {
      vec2 at;
      at[axis] = x + this->Offsets[i][axis];
      const double share = way[axis] != 0 ? (at[axis] - from[axis]) / way[axis] : 0;
      const vec2 beside = from + way * std::min(std::max(share, 0.0), 1.0);
      const double row = std::floor(beside[1 - axis] - this->Offsets[i][1 - axis] + 0.5);
      at[1 - axis] = row + this->Offsets[i][1 - axis];
      if (std::abs(at[1 - axis] - beside[1 - axis]) > 2 * near || row < 0 ||
        row >= this->Size[1 - axis])
      {
        continue;
      }
      const double t = length2 > 0 ? glm::dot(at - from, way) / length2 : 0;
      const double distance = glm::length(at - from - way * std::min(std::max(t, 0.0), 1.0));
      if (distance <= near)
      {
        const double pixel = axis == 0 ? row * this->Size.x + x : x * this->Size.x + row;
        visit(static_cast<unsigned int>(pixel * this->Count + i), distance);
      }
    }
  }
}
}

#endif
