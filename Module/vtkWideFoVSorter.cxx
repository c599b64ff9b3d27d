// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVSorter.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
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
  Front = 8, // the side that the eye sees; nearly edge-on, both
  Back = 16,
  Calm = 32, // easy to cover
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

// An affine map.
struct Affine
{
  vec3 Columns[3];
  vec3 Shift;

  explicit Affine(const double m[16])
    : Columns{ vec3(m[0], m[4], m[8]), vec3(m[1], m[5], m[9]), vec3(m[2], m[6], m[10]) }
    , Shift(m[3], m[7], m[11])
  {
  }

  vec3 Of(double x, double y, double z) const
  {
    return this->Columns[0] * x + this->Columns[1] * y + this->Columns[2] * z + this->Shift;
  }
};

// Sorts clusters; a functor for threads.
template <typename Real>
class Work
{
public:
  Work(const Clusters& clusters, const Real* points, const double toMap[16], const SortView& view,
    unsigned char* kinds, float* bends)
    : All(clusters)
    , Points(points)
    , ToMap(toMap)
    , V(view)
    , Kinds(kinds)
    , Bends(bends)
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
  Box BoxOf(int cluster) const
  {
    const std::array<double, 6>& b = this->All.GetBounds(cluster);
    Box box;
    for (int i = 0; i < 8; i++)
    {
      box.Add(this->ToMap.Of(b[i & 1], b[2 + ((i >> 1) & 1)], b[4 + ((i >> 2) & 1)]));
    }
    box.Grow(this->V.Reach);
    return box;
  }

  void Sort(int cluster, const TriangleJudge& judge, LastSeen& seen) const
  {
    const vtkIdType first = static_cast<vtkIdType>(cluster) * Clusters::Size;
    const vtkIdType end =
      std::min<vtkIdType>(first + Clusters::Size, this->All.GetNumberOfTriangles());
    const bool unseen = IsUnseen(*this->V.Map, this->V.View, this->BoxOf(cluster), this->V.Part);
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
      const Real* p = this->Points + 3 * static_cast<std::size_t>(point);
      corners[j] = seen.Get(point, [&] { return judge.See(this->ToMap.Of(p[0], p[1], p[2])); });
      c[j] = &corners[j];
    }
    const int side = judge.GetSide(c);
    const int sides = aside ? 0 : side == 0 ? BothSides : side < 0 ? Front : Back;
    verdict = judge.Judge(c);
    const bool plain = verdict.Plain && sides != BothSides;
    const int empty = this->V.Culls ? 0 : Cover | Aside;
    const int drawn = verdict.Empty ? empty : plain ? Plain : Cover;
    return drawn | sides | (verdict.Calm ? Calm : 0);
  }

  const Clusters& All;
  const Real* Points;
  Affine ToMap;
  const SortView& V;
  unsigned char* Kinds;
  float* Bends;
};

template <typename Real>
void SortAll(const Clusters& clusters, const Real* points, const double toMap[16],
  const SortView& view, unsigned char* kinds, float* bends)
{
  Work<Real> work(clusters, points, toMap, view, kinds, bends);
  vtkSMPTools::For(0, clusters.GetNumberOfClusters(), Grain, work);
}
}

namespace wfv
{
bool Sorter::Sort(
  Clusters& clusters, vtkPoints* points, const double toMap[16], const SortView& view)
{
  const auto n = static_cast<std::size_t>(clusters.GetNumberOfTriangles());
  this->Kinds.resize(n);
  this->Bends.resize(static_cast<std::size_t>(clusters.GetNumberOfClusters()));
  if (auto* singles = vtkFloatArray::SafeDownCast(points->GetData()))
  {
    SortAll(clusters, singles->GetPointer(0), toMap, view, this->Kinds.data(), this->Bends.data());
  }
  else if (auto* doubles = vtkDoubleArray::SafeDownCast(points->GetData()))
  {
    SortAll(clusters, doubles->GetPointer(0), toMap, view, this->Kinds.data(), this->Bends.data());
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
  if (view.Plain)
  {
    this->CoverOutlines(clusters);
    this->SpreadCovered(clusters.GetNeighbours());
  }
  this->MakeOrder();
  return true;
}

// What is in front of what is decided at the outlines of surfaces: where front meets back, or the
// mesh ends. There a hidden face shows beside an edge that is off by however little, which is
// wrong by more than any tolerance. So all that touches an outline is covered.
void Sorter::CoverOutlines(Clusters& clusters)
{
  const std::vector<unsigned int>& neighbours = clusters.GetNeighbours();
  const std::vector<unsigned int>& places = clusters.GetPlaces();
  const std::vector<unsigned int>& corners = clusters.GetCorners();
  const auto mark = [&](
                      std::size_t i) -> unsigned char& { return this->Marks[places[corners[i]]]; };
  this->Marks.assign(places.size(), 0);
  for (std::size_t i = 0; i < corners.size(); i++)
  {
    mark(i) |= this->Kinds[i / 3] & BothSides;
    if (neighbours[i] == Clusters::NoTriangle)
    {
      mark(i) |= BothSides;
      mark(i % 3 == 2 ? i - 2 : i + 1) |= BothSides;
    }
  }
  for (std::size_t i = 0; i < corners.size(); i++)
  {
    unsigned char& kind = this->Kinds[i / 3];
    if ((kind & Plain) && (mark(i) & BothSides) == BothSides)
    {
      kind = static_cast<unsigned char>((kind & ~Plain) | Cover);
    }
  }
}

// Plain triangles beside a covered one are drawn both ways.
void Sorter::SpreadCovered(const std::vector<unsigned int>& neighbours)
{
  for (std::size_t i = 0; i < this->Kinds.size(); i++)
  {
    for (int j = 0; j < 3 && (this->Kinds[i] & Plain); j++)
    {
      const unsigned int other = neighbours[3 * i + j];
      if (other != Clusters::NoTriangle && (this->Kinds[other] & (Cover | Plain | Aside)) == Cover)
      {
        this->Kinds[i] |= Cover;
      }
    }
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
