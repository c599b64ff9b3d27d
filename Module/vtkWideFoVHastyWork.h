// SPDX-License-Identifier: BSD-3-Clause
// What threads do with the clusters of a mesh for a view that may be gone with the next frame: of
// most triangles the table of bends says enough, and nothing of them is projected.
#ifndef vtkWideFoVHastyWork_h
#define vtkWideFoVHastyWork_h

#include "vtkWideFoVSortScene.h"
#include "vtkWideFoVSortWork.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace sorting
{
// Sorts clusters; a functor for threads.
template <typename Real>
class HastyWork
{
public:
  HastyWork(const Scene<Real>& scene, unsigned char* kinds, unsigned int* reaches)
    : In(scene)
    , V(scene.V)
    , HalfPixels(0.5 * scene.V.Pixels)
    , Pad(TriangleJudge::GetPad(scene.V.Pixels))
    , Kinds(kinds)
    , Reaches(reaches)
  {
  }

  void operator()(vtkIdType from, vtkIdType to) const
  {
    const TriangleJudge judge(this->V);
    LastSeen seen;
    for (int c = static_cast<int>(from); c < to; c++)
    {
      const vtkIdType first = this->In.GetFirst(c);
      const vtkIdType end = this->In.GetEnd(c);
      if (this->V.Culls && this->In.IsUnseen(c))
      {
        std::fill(this->Kinds + first, this->Kinds + end, static_cast<unsigned char>(Unseen));
        continue;
      }
      for (vtkIdType i = first; i < end; i++)
      {
        const int kind = this->TakeByTable(i);
        this->Kinds[i] =
          static_cast<unsigned char>(kind != Open ? kind : this->Look(i, judge, seen));
      }
    }
  }

private:
  // Pixels: a triangle that the table moves out by more is looked at.
  static constexpr double MostByTable = 0.5;

  // Pixels: one that is no larger may lie between the samples, and is looked at.
  static constexpr double Small = 4;

  static constexpr int Open = -1; // the table says too little

  // Seen from the eye no edge is longer than it would be at the nearest corner.
  int TakeByTable(vtkIdType triangle) const
  {
    const vec3 p[3] = { this->In.PlaceOf(3 * triangle), this->In.PlaceOf(3 * triangle + 1),
      this->In.PlaceOf(3 * triangle + 2) };
    const double away[3] = { glm::length(p[0]), glm::length(p[1]), glm::length(p[2]) };
    const double nearest = std::min({ away[0], away[1], away[2] });
    const double farthest = std::max({ away[0], away[1], away[2] });
    const vec3 d[3] = { p[0] / away[0], p[1] / away[1], p[2] / away[2] };
    const double angle2 = TriangleJudge::Longest2(p) / (nearest * nearest);
    const int level = LocalBend::LevelOf(angle2);
    if (level >= LocalBend::Levels || !(angle2 > 0) ||
      TriangleJudge::MayTear(this->V.Map->Axis, d, 0) || !TriangleJudge::IsInDomain(this->V, d))
    {
      return Open;
    }
    const LocalBend::Cell& bend = this->V.Bends->At(d[0], level);
    const double off =
      angle2 * std::hypot(bend[0] * this->HalfPixels.x, bend[1] * this->HalfPixels.y) / 8;
    const double stretch = bend[2] * std::max(this->HalfPixels.x, this->HalfPixels.y);
    const double grow = off + this->Pad + this->V.Rounding / nearest * stretch;
    const bool plain = off <= this->V.Moving &&
      angle2 <= TriangleJudge::LongestPlain * TriangleJudge::LongestPlain &&
      TriangleJudge::IsBetweenSpheres(this->V.View, nearest, farthest, angle2);
    const bool calm = this->Reaches && grow <= TriangleJudge::CalmError &&
      (plain || (off <= MostByTable && angle2 * stretch * stretch > Small * Small));
    if (calm)
    {
      const auto reach = static_cast<unsigned int>(std::ceil(TriangleJudge::Reaches * grow));
      this->Reaches[triangle] =
        reach | reach << TriangleJudge::ReachBits | reach << (2 * TriangleJudge::ReachBits);
    }
    return plain && this->V.Moving > 0 ? Plain | (calm ? Calm : 0) : calm ? Cover | Calm : Open;
  }

  // Its edges are measured.
  int Look(vtkIdType triangle, const TriangleJudge& judge, LastSeen& seen) const
  {
    TriangleJudge::Corner corners[3];
    seen.Get(this->In, judge, 3 * triangle, corners);
    const TriangleJudge::Corner* c[3] = { &corners[0], &corners[1], &corners[2] };
    const TriangleJudge::Verdict verdict = judge.Judge(c);
    if (verdict.Empty && this->V.Culls)
    {
      return Unseen;
    }
    if (this->Reaches)
    {
      this->Reaches[triangle] = verdict.Reach;
    }
    const int drawn = verdict.Plain && this->V.Moving > 0 ? Plain : Cover;
    const vec3 d[3] = { corners[0].Direction, corners[1].Direction, corners[2].Direction };
    // shorter ones are small beside a pole, of which there may be many
    const bool cut = this->Reaches &&
      TriangleJudge::Longest2(d) > TriangleJudge::LongestPlain * TriangleJudge::LongestPlain;
    return drawn | (verdict.Calm ? Calm : cut ? Cut : 0);
  }

  const Scene<Real>& In;
  const SortView& V;
  const vec2 HalfPixels;
  const double Pad;
  unsigned char* Kinds;
  unsigned int* Reaches; // with Calm
};
}
}

#endif
