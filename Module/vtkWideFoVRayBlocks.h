// SPDX-License-Identifier: BSD-3-Clause
// The rays of a picture by squares of its pixels.
#ifndef vtkWideFoVRayBlocks_h
#define vtkWideFoVRayBlocks_h

#include "vtkWideFoVSampleRays.h"

#include <algorithm>
#include <vector>

namespace wfv
{
// Of what may be anywhere in the picture one square answers for all of its pixels.
class RayBlocks
{
public:
  // Pixels of a side.
  static constexpr int Side = 16;

  struct Block
  {
    int X = 0; // its first pixel
    int Y = 0;
    vec3 Direction{ 0 }; // in the middle of those of its rays
    double Angle = 0;    // by which theirs are off that, as vectors
    vec3 Start{ 0 };     // the same of where they begin
    double Aside = 0;
  };

  // seen: by one eye of the view; of those whose rays begin in the origin the starts are there.
  void Make(const SortView& view, const WfvView& seen, const SampleRays& rays)
  {
    const vec2 size = view.Samples.GetSize();
    this->Blocks.clear();
    for (int y = 0; y < size.y; y += Side)
    {
      for (int x = 0; x < size.x; x += Side)
      {
        this->Add(x, y, view, seen, rays);
      }
    }
  }

  bool IsEmpty() const { return this->Blocks.empty(); }

  // Those with pixels that see something.
  const std::vector<Block>& GetBlocks() const { return this->Blocks; }

  template <typename Visit> // (x, y)
  static void ForEachPixel(const Block& block, const vec2& size, const Visit& visit)
  {
    const int endX = std::min(block.X + Side, static_cast<int>(size.x));
    const int endY = std::min(block.Y + Side, static_cast<int>(size.y));
    for (int y = block.Y; y < endY; y++)
    {
      for (int x = block.X; x < endX; x++)
      {
        visit(x, y);
      }
    }
  }

private:
  struct Range
  {
    vec3 Low{ VTK_DOUBLE_MAX };
    vec3 High{ -VTK_DOUBLE_MAX };

    void Add(const vec3& v)
    {
      this->Low = glm::min(this->Low, v);
      this->High = glm::max(this->High, v);
    }
    vec3 GetMiddle() const { return 0.5 * (this->Low + this->High); }
    double GetRadius() const { return 0.5 * glm::length(this->High - this->Low); }
  };

  void Add(int x, int y, const SortView& view, const WfvView& seen, const SampleRays& rays)
  {
    Block block;
    block.X = x;
    block.Y = y;
    Range directions;
    Range starts;
    ForEachPixel(block, view.Samples.GetSize(), [&](int i, int j) {
      const vec3 direction = rays.GetDirection(i, j);
      if (direction != vec3(0))
      {
        directions.Add(direction);
        starts.Add(view.Own ? view.Own->EyeAt(direction, seen) : vec3(0));
      }
    });
    if (directions.Low.x > directions.High.x)
    {
      return; // beside the map
    }
    block.Direction = directions.GetMiddle();
    block.Angle = directions.GetRadius();
    block.Start = starts.GetMiddle();
    block.Aside = starts.GetRadius();
    this->Blocks.push_back(block);
  }

  std::vector<Block> Blocks;
};
}

#endif
