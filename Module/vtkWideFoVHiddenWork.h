// SPDX-License-Identifier: BSD-3-Clause
// What threads do to find the triangles that stand behind everything that is seen where they are.
#ifndef vtkWideFoVHiddenWork_h
#define vtkWideFoVHiddenWork_h

#include "vtkWideFoVSeenTriangle.h"
#include "vtkWideFoVSortScene.h"
#include "vtkWideFoVSortedEntry.h"

#include <algorithm>
#include <vector>

namespace wfv
{
namespace sorting
{
// A part of the picture, pixels.
struct Part
{
  vec2 Low;
  vec2 High;
};

// A functor for threads, over the triangles of an entry in their order.
template <typename Real, typename Entry>
class HiddenWork
{
public:
  // depths: of each eye of the view; hidden: the answers, eyes that do not see it.
  HiddenWork(const Scene<Real>& scene, const Entry& entry, const DepthPicture* const depths[],
    const SampleRays& rays, const RayBlocks blocks[], std::vector<unsigned char>& hidden)
    : In(scene)
    , Sorted(entry)
    , Depths(depths)
    , Rays(rays)
    , Blocks(blocks)
    , Hidden(hidden)
    , First(entry.Lots[0].All)
  {
  }

  void operator()(vtkIdType from, vtkIdType to) const
  {
    std::vector<Watcher> eyes;
    eyes.reserve(SortView::MostEyes);
    for (int i = 0; i < this->In.V.GetNumberOfEyes(); i++)
    {
      eyes.emplace_back(this->In.V, i, this->Depths[i], this->Blocks[i]);
    }
    for (vtkIdType i = from; i < to; i++)
    {
      const auto place = static_cast<std::size_t>(i);
      const int only = this->Sorted.GetEyeOf(place);
      unsigned char hidden = Entry::NoEye;
      for (Watcher& eye : eyes)
      {
        const double x = eye.View.stereo.x;
        if (x * only >= 0 && !this->IsHidden(place, eye))
        {
          hidden &= eyes.size() == 1 ? 0 : x < 0 ? Entry::RightEye : Entry::LeftEye;
        }
      }
      this->Hidden[place] = hidden;
    }
  }

private:
  // Pixels beyond what is known to hold a triangle.
  static constexpr double Margin = 1;

  // Samples that are looked at one by one, at the most.
  static constexpr double MostSamples = 65536;

  bool IsHidden(std::size_t place, Watcher& eye) const
  {
    const vtkIdType corner = 3 * static_cast<vtkIdType>(this->Sorted.Order[place]);
    if (place < this->First && eye.Blocks.IsEmpty())
    {
      return false;
    }
    TriangleJudge::Corner c[3];
    eye.Seen.Get(this->In, eye.Judge, corner, c);
    return place < this->First
      ? this->IsBehindAnywhere(SeenTriangle(this->In.V, eye, this->Rays, c, true, 0), eye.Blocks)
      : this->IsBehindInPart(place - this->First, c, eye);
  }

  // What may be anywhere in the picture.
  bool IsBehindAnywhere(const SeenTriangle& triangle, const RayBlocks& all) const
  {
    const vec2 size = this->In.V.Samples.GetSize();
    double samples = 0;
    bool shows = false;
    for (const RayBlocks::Block& block : all.GetBlocks())
    {
      if (!triangle.MayShow(block))
      {
        continue;
      }
      samples += RayBlocks::Side * RayBlocks::Side;
      shows = shows || samples > MostSamples;
      RayBlocks::ForEachPixel(
        block, size, [&](int x, int y) { shows = shows || triangle.MayShow(x, y, true); });
      if (shows)
      {
        return false;
      }
    }
    return true;
  }

  // i: after those that may be anywhere.
  bool IsBehindInPart(std::size_t i, const TriangleJudge::Corner c[3], const Watcher& eye) const
  {
    const bool covered = i < this->Sorted.Reaches.size();
    const bool piece = covered && this->Sorted.Reaches[i] >= Sorter::PieceBits;
    const double reach = covered && !piece ? this->GetReach(i) : 0;
    const Part part =
      piece ? this->GetPiece(this->Sorted.Reaches[i] & ~Sorter::PieceBits) : GetPart(c, reach);
    const vec2 size = this->In.V.Samples.GetSize();
    // what reaches beyond a border may be drawn at another one
    const bool inside = part.Low.x >= 0 && part.Low.y >= 0 && part.High.x < size.x &&
      part.High.y < size.y; // false where it is no number
    const SeenTriangle triangle(this->In.V, eye, this->Rays, c, covered, reach);
    return inside && IsBehind(triangle, part, piece);
  }

  static bool IsBehind(const SeenTriangle& triangle, const Part& part, bool piece)
  {
    const vec2 span = part.High - part.Low;
    if (!(span.x * span.y <= MostSamples))
    {
      return false;
    }
    for (int y = static_cast<int>(part.Low.y); y <= static_cast<int>(part.High.y); y++)
    {
      for (int x = static_cast<int>(part.Low.x); x <= static_cast<int>(part.High.x); x++)
      {
        if (triangle.MayShow(x, y, piece))
        {
          return false;
        }
      }
    }
    return true;
  }

  // Pixels that a calm triangle is moved out by.
  double GetReach(std::size_t i) const
  {
    constexpr unsigned int Side = (1u << TriangleJudge::ReachBits) - 1;
    const unsigned int reach = this->Sorted.Reaches[i];
    const unsigned int most = std::max({ reach & Side, (reach >> TriangleJudge::ReachBits) & Side,
      (reach >> (2 * TriangleJudge::ReachBits)) & Side });
    return most / TriangleJudge::Reaches;
  }

  static Part GetPart(const TriangleJudge::Corner c[3], double reach)
  {
    return { glm::min(c[0].At, glm::min(c[1].At, c[2].At)) - reach - Margin,
      glm::max(c[0].At, glm::max(c[1].At, c[2].At)) + reach + Margin };
  }

  // Of a rectangle that holds a part of a triangle.
  Part GetPiece(unsigned int piece) const
  {
    const float* const numbers = this->Sorted.Pieces.data() + 8 * static_cast<std::size_t>(piece);
    const vec2 middle = 0.5 * this->In.V.Samples.GetSize();
    const vec2 from = vec2(numbers[0], numbers[1]) + middle;
    const vec2 side(numbers[2], numbers[3]);
    const vec2 up = vec2(-side.y, side.x) * (numbers[4] / glm::length(side));
    const vec2 c[4] = { from, from + side, from + up, from + side + up };
    return { glm::min(glm::min(c[0], c[1]), glm::min(c[2], c[3])) - Margin,
      glm::max(glm::max(c[0], c[1]), glm::max(c[2], c[3])) + Margin };
  }

  const Scene<Real>& In;
  const Entry& Sorted;
  const DepthPicture* const* Depths;
  const SampleRays& Rays;
  const RayBlocks* Blocks; // of each eye
  std::vector<unsigned char>& Hidden;
  const std::size_t First; // after those that may be anywhere
};
}
}

#endif
