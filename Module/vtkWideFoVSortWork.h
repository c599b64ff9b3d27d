// SPDX-License-Identifier: BSD-3-Clause
// What threads do with the clusters of a mesh while its triangles are sorted.
#ifndef vtkWideFoVSortWork_h
#define vtkWideFoVSortWork_h

#include "vtkWideFoVEdgeDoubts.h"
#include "vtkWideFoVSortScene.h"
#include "vtkWideFoVTrianglePieces.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace wfv
{
namespace sorting
{
enum Kind : unsigned char
{
  Unseen = 0,
  Plain = 1,
  Cover = 2, // both: 3
  Aside = 4, // and drawn nevertheless: what is seen does not depend on it
  Calm = 8,  // easy to cover
  Cut = 16,  // better covered in pieces, if it has to be

  // Of two eyes that triangles are sorted for, one sees none of it.
  NotLeft = 32,
  NotRight = 64,
  NotBoth = NotLeft | NotRight,
};

// The side that the eye sees; nearly edge-on, both.
enum Side : unsigned char
{
  Front = 1,
  Back = 2,
  BothSides = Front | Back
};

// Points as they were last seen, by their numbers: neighbours share most of theirs.
class LastSeen
{
public:
  // The corners of a triangle, from its first one on.
  template <typename Real>
  void Get(const Scene<Real>& scene, const TriangleJudge& judge, vtkIdType first,
    TriangleJudge::Corner corners[3])
  {
    for (int j = 0; j < 3; j++)
    {
      const unsigned int point = scene.All.GetCorners()[first + j];
      Entry& e = this->Entries[point % Kept];
      if (e.Point != point)
      {
        e.Seen = judge.See(scene.PlaceOf(first + j));
        e.Point = point;
      }
      corners[j] = e.Seen;
    }
  }

private:
  static constexpr unsigned int Kept = 512;
  struct Entry
  {
    unsigned int Point = ~0u;
    TriangleJudge::Corner Seen;
  };
  std::array<Entry, Kept> Entries;
};

// Where front meets back, or the mesh ends, or goes on where it is not looked at.
inline bool IsOutline(const std::vector<unsigned char>& sides,
  const std::vector<unsigned int>& neighbours, unsigned int edge)
{
  const unsigned int other = neighbours[edge];
  const int beside = other == Clusters::NoTriangle ? 0 : sides[other];
  return beside == 0 || (beside | sides[edge / 3]) == BothSides;
}

using Doubts = std::array<vtkSMPThreadLocal<std::vector<EdgeDoubts::Doubt>>, SortView::MostEyes>;

// Of all eyes that triangles are sorted for: what each does its share of the work with.
template <typename Eye>
std::vector<Eye> AllEyes(const SortView& view)
{
  std::vector<Eye> eyes;
  eyes.reserve(SortView::MostEyes);
  for (int i = 0; i < view.GetNumberOfEyes(); i++)
  {
    eyes.emplace_back(view, i);
  }
  return eyes;
}

// One of the eyes that triangles are sorted for.
struct Looker
{
  Looker(const SortView& view, int eye)
    : Not(view.GetViewOf(eye).stereo.x < 0 ? NotLeft : NotRight)
    , Judge(view, eye)
  {
  }

  int Not; // the kind of what it sees none of
  TriangleJudge Judge;
  LastSeen Seen;
};

// What all of them say of a triangle. One that covers no sample for an eye may be drawn in whatever
// way there.
struct Common
{
  bool Empty = true;
  int Not = 0; // kinds: for whom it is empty
  bool Plain = true;
  bool Calm = true;
  bool Large = false; // the shape that covers it is, for some eye
  unsigned int Reach = 0;

  void Add(const Looker& eye, const TriangleJudge::Verdict& verdict,
    const TriangleJudge::Corner* const corners[3])
  {
    if (verdict.Empty)
    {
      this->Not |= eye.Not;
      return;
    }
    this->Empty = false;
    this->Plain = this->Plain && verdict.Plain;
    this->Calm = this->Calm && verdict.Calm;
    this->Reach = TriangleJudge::JoinReaches(this->Reach, verdict.Reach);
    this->Large = this->Large || !verdict.Calm ||
      TriangleJudge::GetCalmArea(corners, verdict.Reach) > TrianglePieces::LeastArea;
  }

  // Of one that is empty for all nothing more is known.
  void Finish()
  {
    this->Not = this->Empty ? 0 : this->Not;
    this->Plain = this->Plain && !this->Empty;
    this->Calm = this->Calm && !this->Empty;
    this->Large = this->Large || this->Empty;
  }
};

// Finds which sides of triangles are seen, 0 where nothing is: before their edges are looked at. A
// functor for threads.
template <typename Real>
struct FindSides
{
  const Scene<Real>& In;
  std::vector<unsigned char>& Sides;

  void operator()(vtkIdType from, vtkIdType to) const
  {
    const TriangleJudge judge(this->In.V);
    for (int c = static_cast<int>(from); c < to; c++)
    {
      const bool unseen = this->In.IsUnseen(c);
      for (vtkIdType i = this->In.GetFirst(c); i < this->In.GetEnd(c); i++)
      {
        this->Sides[i] = unseen ? 0 : this->SidesOf(judge, 3 * i);
      }
    }
  }

  unsigned char SidesOf(const TriangleJudge& judge, vtkIdType corner) const
  {
    const int side = judge.GetSide(
      this->In.PlaceOf(corner), this->In.PlaceOf(corner + 1), this->In.PlaceOf(corner + 2));
    return side == 0 ? BothSides : side < 0 ? Front : Back;
  }
};

// Sorts clusters; a functor for threads.
template <typename Real>
class Work
{
public:
  Work(const Scene<Real>& scene, const std::vector<unsigned char>& sides,
    const std::vector<unsigned int>& neighbours, unsigned char* kinds, unsigned int* reaches,
    Doubts& doubts)
    : In(scene)
    , All(scene.All)
    , V(scene.V)
    , Sides(sides)
    , Neighbours(neighbours)
    , Kinds(kinds)
    , Reaches(reaches)
    , InDoubt(doubts)
  {
  }

  void operator()(vtkIdType from, vtkIdType to) const
  {
    std::vector<Looker> eyes = AllEyes<Looker>(this->V);
    for (vtkIdType c = from; c < to; c++)
    {
      this->Sort(static_cast<int>(c), eyes);
    }
  }

private:
  void Sort(int cluster, std::vector<Looker>& eyes) const
  {
    const vtkIdType first = this->In.GetFirst(cluster);
    const vtkIdType end = this->In.GetEnd(cluster);
    const bool unseen = this->In.IsUnseen(cluster);
    const int aside = unseen ? Aside : 0;
    const bool left = unseen && this->V.Culls;
    if (left || !this->V.Bends)
    {
      const int kind = left ? Unseen : Cover | aside;
      std::fill(this->Kinds + first, this->Kinds + end, static_cast<unsigned char>(kind));
      return;
    }
    for (vtkIdType i = first; i < end; i++)
    {
      const Common found = this->Ask(3 * i, aside != 0, eyes);
      this->Kinds[i] = static_cast<unsigned char>(this->GetKind(i, found) | aside);
      if (this->Reaches)
      {
        this->Reaches[i] = found.Reach;
      }
    }
  }

  // What all eyes say.
  Common Ask(vtkIdType corner, bool aside, std::vector<Looker>& eyes) const
  {
    Common found;
    for (std::size_t i = 0; i < eyes.size(); i++)
    {
      TriangleJudge::Corner corners[3];
      eyes[i].Seen.Get(this->In, eyes[i].Judge, corner, corners);
      const TriangleJudge::Corner* c[3] = { &corners[0], &corners[1], &corners[2] };
      TriangleJudge::Verdict verdict = eyes[i].Judge.Judge(c);
      verdict.Plain = verdict.Plain && !this->PartsSamples(corner, c, verdict, static_cast<int>(i));
      found.Add(eyes[i], verdict, c);
      if (this->V.Plain && !aside && !verdict.Empty)
      {
        this->Doubt(corner, c, eyes[i].Judge, verdict, this->InDoubt[i].Local());
      }
    }
    found.Finish();
    return found;
  }

  // Whether a sample is on different sides of an edge and its chord, to an eye.
  bool PartsSamples(vtkIdType corner, const TriangleJudge::Corner* const c[3],
    const TriangleJudge::Verdict& verdict, int eye) const
  {
    bool parts = false;
    for (int j = 0; j < 3 && !parts; j++)
    {
      const vec2 from = c[j]->At;
      const vec2 chord = c[(j + 1) % 3]->At - from;
      const auto side = [&](const vec2& at) {
        return chord.x * (at.y - from.y) - chord.y * (at.x - from.x);
      };
      const double inner = side(c[(j + 2) % 3]->At);
      const auto edge = static_cast<unsigned int>(corner + j);
      const auto look = [&](unsigned int sample, double) {
        const bool inside = side(this->V.Samples.SampleAt(sample)) * inner > 0;
        parts = parts || inside != (this->In.GetInside(sample, edge, eye) > 0);
      };
      this->V.Samples.ForEachNear(from, from + chord, verdict.Widths[j] - verdict.Sure, look);
    }
    return parts;
  }

  int GetKind(vtkIdType triangle, const Common& found) const
  {
    const bool plain = found.Plain && this->Sides[triangle] != BothSides;
    const int empty = this->V.Culls ? 0 : Cover | Aside;
    const int drawn = found.Empty ? empty : plain ? Plain : Cover;
    const bool large = this->V.Calm && this->V.Measures && found.Large;
    const int whose = this->V.Culls ? found.Not : 0;
    return drawn | (found.Calm ? Calm : 0) | (large ? Cut : 0) | whose;
  }

  // Collects the samples that are in doubt at the edges.
  void Doubt(vtkIdType corner, const TriangleJudge::Corner* const c[3], const TriangleJudge& judge,
    const TriangleJudge::Verdict& verdict, std::vector<EdgeDoubts::Doubt>& doubts) const
  {
    for (int j = 0; j < 3; j++)
    {
      const auto edge = static_cast<unsigned int>(corner + j);
      const double beyond = IsOutline(this->Sides, this->Neighbours, edge)
        ? SortView::PlainError + verdict.Sure
        : EdgeDoubts::OutlineWidth;
      const auto look = [&](const vec2& from, const vec2& to, double width, double sure) {
        this->V.Samples.ForEachNear(
          from, to, width + beyond, [&](unsigned int sample, double beside) {
            doubts.push_back({ sample, edge, static_cast<float>(beside), static_cast<float>(width),
              static_cast<float>(sure) });
          });
      };
      const TriangleJudge::Corner& next = *c[(j + 1) % 3];
      if (verdict.Known)
      {
        look(c[j]->At, next.At, verdict.Widths[j], verdict.Sure);
      }
      else
      {
        judge.ForEachPiece(*c[j], next, look);
      }
    }
  }

  const Scene<Real>& In;
  const Clusters& All;
  const SortView& V;
  const std::vector<unsigned char>& Sides; // with Plain
  const std::vector<unsigned int>& Neighbours;
  unsigned char* Kinds;
  unsigned int* Reaches; // with Calm
  Doubts& InDoubt;
};

using ThreadPieces = vtkSMPThreadLocal<std::vector<CoverPiece>>;

// What one of the eyes sees of a triangle, and cuts it by.
struct Cutter
{
  Cutter(const SortView& view, int eye)
    : Judge(view, eye)
    , Pieces(view, eye)
  {
  }

  TriangleJudge Judge;
  TrianglePieces Pieces;
};

// Finds pieces that cover triangles; those that have none are no longer said to be better so. A
// functor for threads.
template <typename Real>
struct CutWork
{
  const Scene<Real>& In;
  const std::vector<unsigned int>& Reaches;
  std::vector<unsigned char>& Kinds;
  ThreadPieces& Found;

  void operator()(vtkIdType from, vtkIdType to) const
  {
    const std::vector<Cutter> eyes = AllEyes<Cutter>(this->In.V);
    std::vector<CoverPiece>& found = this->Found.Local();
    for (vtkIdType i = this->In.GetFirst(static_cast<int>(from));
         i < this->In.GetEnd(static_cast<int>(to) - 1); i++)
    {
      if ((this->Kinds[i] & (Cover | Cut)) == (Cover | Cut) && !this->CutOne(i, eyes, found))
      {
        this->Kinds[i] &= static_cast<unsigned char>(~Cut);
      }
    }
  }

  // For all eyes or none.
  bool CutOne(vtkIdType i, const std::vector<Cutter>& eyes, std::vector<CoverPiece>& found) const
  {
    const std::size_t before = found.size();
    for (const Cutter& eye : eyes)
    {
      TriangleJudge::Corner corners[3];
      const TriangleJudge::Corner* c[3];
      for (int j = 0; j < 3; j++)
      {
        corners[j] = eye.Judge.See(this->In.PlaceOf(3 * i + j));
        c[j] = &corners[j];
      }
      const double most = (this->Kinds[i] & Calm) ? TriangleJudge::GetCalmArea(c, this->Reaches[i])
                                                  : std::numeric_limits<double>::infinity();
      if (!eye.Pieces.Cover(static_cast<unsigned int>(i), c, most, found))
      {
        found.resize(before);
        return false;
      }
    }
    return true;
  }
};
}
}

#endif
