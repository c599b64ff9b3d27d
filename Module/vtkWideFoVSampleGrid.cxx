// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVSampleGrid.h"

#include "vtkWideFoVGl.h"

#include <algorithm>
#include <cmath>

namespace
{
using wfv::vec2;

// Pixels, along an axis: larger triangles rarely lie between samples.
constexpr double LargestSpan = 4;

// A triangle with its sides moved out, within its own bounds moved out as far.
struct Grown
{
  const vec2* Corners;
  double Grow;
  vec2 Low;
  vec2 High;
  vec2 Inwards[3]; // across the sides; of one without area both ways, so that a band is left

  Grown(const vec2 c[3], double grow)
    : Corners(c)
    , Grow(grow)
    , Low(glm::min(c[0], glm::min(c[1], c[2])) - grow)
    , High(glm::max(c[0], glm::max(c[1], c[2])) + grow)
  {
    const vec2 a = c[1] - c[0];
    const vec2 b = c[2] - c[0];
    const double turn = a.x * b.y - a.y * b.x < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++)
    {
      const vec2 side = c[(i + 1) % 3] - c[i];
      const double length = glm::length(side);
      this->Inwards[i] = length > 0 ? vec2(-side.y, side.x) * (turn / length) : vec2(0);
    }
  }

  // Never where a corner is no number: smallest and largest would pass over it.
  bool IsSmall() const
  {
    const vec2 sum = this->Corners[0] + this->Corners[1] + this->Corners[2];
    return std::isfinite(sum.x + sum.y) && this->High.x - this->Low.x < LargestSpan &&
      this->High.y - this->Low.y < LargestSpan;
  }

  bool Holds(const vec2& s) const
  {
    const vec2* c = this->Corners;
    return s.x >= this->Low.x && s.y >= this->Low.y && s.x <= this->High.x && s.y <= this->High.y &&
      glm::dot(s - c[0], this->Inwards[0]) >= -this->Grow &&
      glm::dot(s - c[1], this->Inwards[1]) >= -this->Grow &&
      glm::dot(s - c[2], this->Inwards[2]) >= -this->Grow;
  }
};
}

namespace wfv
{
void SampleGrid::TakeBound()
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  this->Count = samples > MostSamples ? 0 : 1;
  this->Offsets[0] = vec2(0.5);
  if (samples > 1 && samples <= MostSamples && glIsEnabled(GL_MULTISAMPLE))
  {
    this->Count = samples;
    for (int i = 0; i < samples; i++)
    {
      GLfloat offset[2];
      glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), offset);
      this->Offsets[i] = vec2(offset[0], offset[1]);
    }
  }
}

bool SampleGrid::Misses(const vec2 corners[3], double grow) const
{
  const Grown triangle(corners, grow);
  if (!triangle.IsSmall() || this->Count == 0)
  {
    return false;
  }
  for (double y = std::floor(triangle.Low.y); y <= triangle.High.y; y++)
  {
    for (double x = std::floor(triangle.Low.x); x <= triangle.High.x; x++)
    {
      for (int i = 0; i < this->Count; i++)
      {
        if (triangle.Holds(vec2(x, y) + this->Offsets[i]))
        {
          return false;
        }
      }
    }
  }
  return true;
}

vec2 SampleGrid::SampleAt(unsigned int number) const
{
  const unsigned int pixel = number / this->Count;
  const unsigned int width = static_cast<unsigned int>(this->Size.x);
  return vec2(pixel % width, pixel / width) + this->Offsets[number % this->Count];
}

bool SampleGrid::operator==(const SampleGrid& o) const
{
  return this->Count == o.Count && this->Scale == o.Scale && this->Shift == o.Shift &&
    this->Size == o.Size &&
    std::equal(this->Offsets.begin(), this->Offsets.begin() + this->Count, o.Offsets.begin());
}
}
