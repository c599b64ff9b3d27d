// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVSorter.h"

#include "vtkWideFoVSortScene.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace wfv;

enum Kind : unsigned char
{
  Unseen = 0,
  Plain = 1,
  Cover = 2, // both: 3
  Aside = 4, // and drawn nevertheless: what is seen does not depend on it
  Calm = 8,  // easy to cover
};

// The side that the eye sees; nearly edge-on, both.
enum Side : unsigned char
{
  Front = 1,
  Back = 2,
  BothSides = Front | Back
};

// Clusters a thread takes at least.
constexpr vtkIdType Grain = 64;

// Points as they were last seen, by their numbers: neighbours share most of theirs.
class LastSeen
{
public:
  template <typename Make>
  const TriangleJudge::Corner& Get(unsigned int point, const Make& make)
  {
    Entry& e = this->Entries[point % Kept];
    if (e.Point != point)
    {
      e.Seen = make();
      e.Point = point;
    }
    return e.Seen;
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
bool IsOutline(const std::vector<unsigned char>& sides, const std::vector<unsigned int>& neighbours,
  unsigned int edge)
{
  const unsigned int other = neighbours[edge];
  const int beside = other == Clusters::NoTriangle ? 0 : sides[other];
  return beside == 0 || (beside | sides[edge / 3]) == BothSides;
}

using Doubts = vtkSMPThreadLocal<std::vector<EdgeDoubts::Doubt>>;

// Finds which sides of triangles are seen, 0 where nothing is: before their edges are looked at. A
// functor for threads.
template <typename Real>
struct FindSides
{
  const Scene<Real>& In;
  std::vector<unsigned char>& Sides;

  void operator()(vtkIdType from, vtkIdType to) const
  {
    for (int c = static_cast<int>(from); c < to; c++)
    {
      const bool unseen = this->In.IsUnseen(c);
      for (vtkIdType i = this->In.GetFirst(c); i < this->In.GetEnd(c); i++)
      {
        this->Sides[i] = unseen ? 0 : this->SidesOf(3 * i);
      }
    }
  }

  unsigned char SidesOf(vtkIdType corner) const
  {
    const int side = TriangleJudge::GetSide(
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
    const std::vector<unsigned int>& neighbours, unsigned char* kinds, float* bends, Doubts& doubts)
    : In(scene)
    , All(scene.All)
    , V(scene.V)
    , Sides(sides)
    , Neighbours(neighbours)
    , Kinds(kinds)
    , Bends(bends)
    , InDoubt(doubts)
  {
  }

  void operator()(vtkIdType from, vtkIdType to) const
  {
    const TriangleJudge judge(this->V);
    LastSeen seen;
    for (vtkIdType c = from; c < to; c++)
    {
      this->Sort(static_cast<int>(c), judge, seen);
    }
  }

private:
  void Sort(int cluster, const TriangleJudge& judge, LastSeen& seen) const
  {
    const vtkIdType first = this->In.GetFirst(cluster);
    const vtkIdType end = this->In.GetEnd(cluster);
    const bool unseen = this->In.IsUnseen(cluster);
    const int aside = unseen ? Aside : 0;
    const bool left = unseen && this->V.Culls;
    this->Bends[cluster] = 0;
    if (left || !this->V.Bends)
    {
      const int kind = left ? Unseen : Cover | aside;
      std::fill(this->Kinds + first, this->Kinds + end, static_cast<unsigned char>(kind));
      return;
    }
    for (vtkIdType i = first; i < end; i++)
    {
      TriangleJudge::Verdict verdict;
      const int kind = this->GetKind(3 * i, aside != 0, judge, seen, verdict);
      this->Kinds[i] = static_cast<unsigned char>(kind | aside);
      this->Bends[cluster] = std::max(this->Bends[cluster], static_cast<float>(verdict.Bend));
    }
  }

  int GetKind(vtkIdType corner, bool aside, const TriangleJudge& judge, LastSeen& seen,
    TriangleJudge::Verdict& verdict) const
  {
    TriangleJudge::Corner corners[3];
    const TriangleJudge::Corner* c[3];
    for (int j = 0; j < 3; j++)
    {
      const unsigned int point = this->All.GetCorners()[corner + j];
      corners[j] = seen.Get(point, [&] { return judge.See(this->In.PlaceOf(corner + j)); });
      c[j] = &corners[j];
    }
    verdict = judge.Judge(c);
    const bool plain = verdict.Plain && this->Sides[corner / 3] != BothSides;
    const int empty = this->V.Culls ? 0 : Cover | Aside;
    const int drawn = verdict.Empty ? empty : plain ? Plain : Cover;
    if (this->V.Plain && !aside && !verdict.Empty)
    {
      this->Doubt(corner, c, judge, verdict);
    }
    return drawn | (verdict.Calm ? Calm : 0);
  }

  // Collects the samples that are in doubt at the edges.
  void Doubt(vtkIdType corner, const TriangleJudge::Corner* const c[3], const TriangleJudge& judge,
    const TriangleJudge::Verdict& verdict) const
  {
    std::vector<EdgeDoubts::Doubt>& doubts = this->InDoubt.Local();
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
  float* Bends;
  Doubts& InDoubt;
};
}

namespace wfv
{
template <typename Real>
void Sorter::SortPoints(
  Clusters& clusters, const Real* points, const double toMap[16], const SortView& view)
{
  const Scene<Real> scene{ clusters, points, Affine(toMap), view };
  const int n = clusters.GetNumberOfClusters();
  this->Sides.resize(view.Plain ? this->Kinds.size() : 0);
  const std::vector<unsigned int>& neighbours = view.Plain ? clusters.GetNeighbours() : this->Order;
  if (view.Plain)
  {
    FindSides<Real> sides{ scene, this->Sides };
    vtkSMPTools::For(0, n, Grain, sides);
  }
  Doubts doubts;
  Work<Real> work(scene, this->Sides, neighbours, this->Kinds.data(), this->Bends.data(), doubts);
  vtkSMPTools::For(0, n, Grain, work);
  if (!view.Plain)
  {
    return;
  }
  EdgeDoubts::Lists lists;
  for (std::vector<EdgeDoubts::Doubt>& some : doubts)
  {
    lists.push_back(std::move(some));
  }
  const TriangleJudge judge(view);
  const EdgeDoubts::Mesh mesh{ clusters,
    [this](unsigned int triangle) { return (this->Kinds[triangle] & Plain) != 0; },
    [&](unsigned int edge) { return IsOutline(this->Sides, neighbours, edge); },
    [&](unsigned int corner) { return judge.See(scene.PlaceOf(corner)).At; },
    [&](unsigned int sample) { return view.Samples.SampleAt(sample); },
    [&](unsigned int sample, unsigned int edge) { return scene.IsInside(sample, edge); },
    [this](unsigned int triangle) { this->CoverTriangle(triangle); }, view.Tolerance };
  EdgeDoubts::Settle(lists, mesh);
  this->SpreadCovered(lists, mesh);
  this->SpreadOverOutlines(lists, mesh);
}

bool Sorter::Sort(
  Clusters& clusters, vtkPoints* points, const double toMap[16], const SortView& view)
{
  const auto n = static_cast<std::size_t>(clusters.GetNumberOfTriangles());
  this->Kinds.resize(n);
  this->Bends.resize(static_cast<std::size_t>(clusters.GetNumberOfClusters()));
  if (auto* singles = vtkFloatArray::SafeDownCast(points->GetData()))
  {
    this->SortPoints(clusters, singles->GetPointer(0), toMap, view);
  }
  else if (auto* doubles = vtkDoubleArray::SafeDownCast(points->GetData()))
  {
    this->SortPoints(clusters, doubles->GetPointer(0), toMap, view);
  }
  else
  {
    return false;
  }
  this->Unseen = 0;
  for (std::size_t i = 0; i < n; i += Clusters::Size)
  {
    this->Unseen += this->Kinds[i] == ::Unseen;
  }
  this->MakeOrder();
  this->LeftOut = std::count_if(this->Kinds.begin(), this->Kinds.end(),
    [](unsigned char kind) { return (kind & (Plain | Cover)) == 0; });
  return true;
}

void Sorter::CoverTriangle(unsigned int triangle)
{
  unsigned char& kind = this->Kinds[triangle];
  kind = static_cast<unsigned char>((kind & ~Plain) | Cover);
}

template <typename Take>
void Sorter::VisitPlain(const EdgeDoubts::Lists& lists, const Take& take) const
{
  for (const std::vector<EdgeDoubts::Doubt>& doubts : lists)
  {
    for (const EdgeDoubts::Doubt& d : doubts)
    {
      if (d.Beside <= d.Width && (this->Kinds[d.Edge / 3] & Plain))
      {
        take(d);
      }
    }
  }
}

// Plain triangles are drawn both ways where a sample is in doubt between one of them and a covered
// one: all that are in doubt there, for the one beside may be thinner than its edges are off.
void Sorter::SpreadCovered(const EdgeDoubts::Lists& lists, const EdgeDoubts::Mesh& mesh)
{
  const std::vector<unsigned int>& neighbours = mesh.Triangles.GetNeighbours();
  std::vector<bool> marked;
  this->VisitPlain(lists, [&](const EdgeDoubts::Doubt& d) {
    const unsigned int other = neighbours[d.Edge];
    if (other != Clusters::NoTriangle && (this->Kinds[other] & (Cover | Plain | Aside)) == Cover &&
      EdgeDoubts::MayBeWrong(d, mesh))
    {
      marked.resize(std::max(marked.size(), std::size_t(d.Sample) + 1));
      marked[d.Sample] = true;
    }
  });
  this->VisitPlain(lists, [&](const EdgeDoubts::Doubt& d) {
    if (d.Sample < marked.size() && marked[d.Sample])
    {
      this->Kinds[d.Edge / 3] |= Cover;
    }
  });
}

// A face that is drawn both ways shows beyond the outline of one that is drawn by its chords alone,
// from behind perhaps: where a sample is in doubt that one is drawn both ways too.
void Sorter::SpreadOverOutlines(const EdgeDoubts::Lists& lists, const EdgeDoubts::Mesh& mesh)
{
  const std::vector<unsigned int>& neighbours = mesh.Triangles.GetNeighbours();
  for (bool changed = true; changed;)
  {
    changed = false;
    this->VisitPlain(lists, [&](const EdgeDoubts::Doubt& d) {
      const unsigned int other = neighbours[d.Edge];
      if ((this->Kinds[d.Edge / 3] & Cover) && other != Clusters::NoTriangle &&
        (this->Kinds[other] & (Plain | Cover)) == Plain && mesh.IsOutline(d.Edge))
      {
        this->Kinds[other] |= Cover;
        changed = true;
      }
    });
  }
}

void Sorter::MakeOrder()
{
  const auto append = [this](int mask, int wanted) {
    const std::size_t before = this->Order.size();
    for (std::size_t i = 0; i < this->Kinds.size(); i++)
    {
      if ((this->Kinds[i] & mask) == wanted)
      {
        this->Order.push_back(static_cast<unsigned int>(i));
      }
    }
    return this->Order.size() - before;
  };
  this->Order.clear();
  this->Covered = append(Cover | ::Calm, Cover);
  this->Calm = append(Cover | ::Calm, Cover | ::Calm);
  append(Plain, Plain);
  this->Bend = this->Bends.empty() ? 0 : *std::max_element(this->Bends.begin(), this->Bends.end());
}
}
