// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVSorter.h"

#include "vtkWideFoVFoldWork.h"
#include "vtkWideFoVHastyWork.h"
#include "vtkWideFoVSortScene.h"
#include "vtkWideFoVSortWork.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
// Clusters a thread takes at least.
constexpr vtkIdType Grain = 64;
}

namespace wfv
{
using namespace sorting;

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
  unsigned int* const reaches = view.Calm ? this->Reaches.data() : nullptr;
  Work<Real> work(scene, this->Sides, neighbours, this->Kinds.data(), reaches, doubts);
  vtkSMPTools::For(0, n, Grain, work);
  if (view.Plain)
  {
    std::vector<EdgeDoubts::Lists> lists;
    for (int i = 0; i < view.GetNumberOfEyes(); i++)
    {
      lists.emplace_back();
      for (std::vector<EdgeDoubts::Doubt>& some : doubts[i])
      {
        lists.back().push_back(std::move(some));
      }
    }
    this->SettleDoubts(scene, clusters, lists);
  }
  if (view.Calm && view.Measures)
  {
    this->CutCovers(scene);
  }
  if (view.Folds)
  {
    this->FindFolds(scene, clusters);
  }
}

template <typename Real>
void Sorter::FindFolds(const Scene<Real>& scene, Clusters& clusters)
{
  this->Folds.resize(this->Kinds.size());
  FoldWork<Real> work(
    scene, clusters.GetNeighbours(), clusters.GetPlaces(), this->Kinds.data(), this->Folds.data());
  vtkSMPTools::For(0, scene.All.GetNumberOfClusters(), Grain, work);
}

// Where samples are in doubt at the edges of plain triangles, those that cannot stay so for some
// eye.
template <typename Real>
void Sorter::SettleDoubts(
  const Scene<Real>& scene, Clusters& clusters, std::vector<EdgeDoubts::Lists>& doubts)
{
  const SortView& view = scene.V;
  const std::vector<unsigned int>& neighbours = clusters.GetNeighbours();
  std::vector<EdgeDoubts::Sight> eyes;
  for (int i = 0; i < view.GetNumberOfEyes(); i++)
  {
    const TriangleJudge judge(view, i);
    eyes.push_back({ std::move(doubts[i]),
      { clusters,
        [this](unsigned int triangle) { return (this->Kinds[triangle] & sorting::Plain) != 0; },
        [&](unsigned int edge) { return IsOutline(this->Sides, neighbours, edge); },
        [&scene, judge](unsigned int corner) { return judge.See(scene.PlaceOf(corner)).At; },
        [&](unsigned int sample) { return view.Samples.SampleAt(sample); },
        [&scene, i](
          const EdgeDoubts::Doubt& d) { return std::abs(scene.GetInside(d.Sample, d.Edge, i)); },
        [this](unsigned int triangle) { this->CoverTriangle(triangle); }, view.Tolerance } });
  }
  EdgeDoubts::Settle(eyes);
  for (const EdgeDoubts::Sight& eye : eyes)
  {
    this->SpreadCovered(eye.Doubts, eye.Seen);
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const EdgeDoubts::Sight& eye : eyes)
    {
      changed |= this->SpreadOverOutlines(eye.Doubts, eye.Seen);
    }
  }
}

template <typename Real>
void Sorter::CutCovers(const Scene<Real>& scene)
{
  ThreadPieces found;
  CutWork<Real> work{ scene, this->Reaches, this->Kinds, found };
  vtkSMPTools::For(0, scene.All.GetNumberOfClusters(), Grain, work);
  for (const std::vector<CoverPiece>& some : found)
  {
    this->Pieces.insert(this->Pieces.end(), some.begin(), some.end());
  }
  // one order, whichever thread took which
  std::stable_sort(this->Pieces.begin(), this->Pieces.end(),
    [](const CoverPiece& a, const CoverPiece& b) { return a.Triangle < b.Triangle; });
}

// sort: takes a pointer to the coordinates, of one kind or the other.
template <typename SortAll>
bool Sorter::SortWith(
  const Clusters& clusters, vtkPoints* points, const SortView& view, const SortAll& sort)
{
  const auto n = static_cast<std::size_t>(clusters.GetNumberOfTriangles());
  this->Kinds.resize(n);
  this->Reaches.resize(view.Calm ? n : 0);
  this->Pieces.clear();
  this->Folds.clear();
  this->Eyes = view.GetNumberOfEyes();
  if (auto* singles = vtkFloatArray::SafeDownCast(points->GetData()))
  {
    sort(singles->GetPointer(0));
  }
  else if (auto* doubles = vtkDoubleArray::SafeDownCast(points->GetData()))
  {
    sort(doubles->GetPointer(0));
  }
  else
  {
    return false;
  }
  this->Finish();
  return true;
}

bool Sorter::Sort(
  Clusters& clusters, vtkPoints* points, const double toMap[16], const SortView& view)
{
  if (view.Plain || view.Folds)
  {
    clusters.GetNeighbours(); // before anything else is kept, for to find them takes the most
  }
  return this->SortWith(
    clusters, points, view, [&](const auto* p) { this->SortPoints(clusters, p, toMap, view); });
}

template <typename Real>
void Sorter::SortPointsInHaste(
  Clusters& clusters, const Real* points, const double toMap[16], const SortView& view)
{
  const Scene<Real> scene{ clusters, points, Affine(toMap), view };
  HastyWork<Real> work(scene, this->Kinds.data(), view.Calm ? this->Reaches.data() : nullptr);
  vtkSMPTools::For(0, clusters.GetNumberOfClusters(), Grain, work);
  if (view.Moving > 0)
  {
    this->CoverBeside(clusters);
  }
  if (view.Calm)
  {
    this->CutCovers(scene);
  }
}

// Plain triangles that share an edge with a covered one are drawn both ways: a sample between the
// edge and its chord may else be in neither.
void Sorter::CoverBeside(Clusters& clusters)
{
  const std::vector<unsigned int>& places = clusters.GetPlaces();
  const Corners& corners = clusters.GetCorners();
  std::vector<bool> covered(places.size());
  for (std::size_t i = 0; i < this->Kinds.size(); i++)
  {
    for (std::size_t j = 3 * i; j < 3 * i + 3 && (this->Kinds[i] & Cover); j++)
    {
      covered[places[corners[j]]] = true;
    }
  }
  for (std::size_t i = 0; i < this->Kinds.size(); i++)
  {
    const auto at = [&](int j) { return static_cast<int>(covered[places[corners[3 * i + j]]]); };
    if ((this->Kinds[i] & sorting::Plain) && at(0) + at(1) + at(2) > 1)
    {
      this->Kinds[i] |= Cover;
    }
  }
}

bool Sorter::SortInHaste(
  Clusters& clusters, vtkPoints* points, const double toMap[16], const SortView& view)
{
  if (!view.Bends || view.Own || view.Cheap)
  {
    // the table says nothing of rays of their own: nothing is measured, so there are neither chords
    // nor pieces; and to look for empty triangles takes longer than to draw them by the vertex
    // stage
    SortView looks = view;
    looks.Plain = looks.Folds = looks.Measures = false;
    looks.Bends = view.Cheap ? nullptr : view.Bends;
    return this->Sort(clusters, points, toMap, looks);
  }
  return this->SortWith(clusters, points, view,
    [&](const auto* p) { this->SortPointsInHaste(clusters, p, toMap, view); });
}

// What has been found, counted and in order.
void Sorter::Finish()
{
  const auto isLeftOut = [](unsigned char kind) { return (kind & (sorting::Plain | Cover)) == 0; };
  const auto end = this->Kinds.end();
  this->Unseen = 0;
  this->LeftOut = 0;
  for (auto first = this->Kinds.begin(); first != end;)
  {
    const auto last = first + std::min<std::ptrdiff_t>(Clusters::Size, end - first);
    const auto left = std::count_if(first, last, isLeftOut);
    this->LeftOut += left;
    this->Unseen += left == last - first;
    first = last;
  }
  this->MakeOrder();
  const auto count = [this](int mask) {
    return std::count_if(this->Kinds.begin(), this->Kinds.end(),
      [mask](unsigned char kind) { return (kind & mask) != 0; });
  };
  this->LeftOutLeft = count(NotLeft);
  this->LeftOutRight = count(NotRight);
}

void Sorter::CoverTriangle(unsigned int triangle)
{
  unsigned char& kind = this->Kinds[triangle];
  kind = static_cast<unsigned char>((kind & ~sorting::Plain) | Cover);
}

template <typename Take>
void Sorter::VisitPlain(const EdgeDoubts::Lists& lists, const Take& take) const
{
  for (const std::vector<EdgeDoubts::Doubt>& doubts : lists)
  {
    for (const EdgeDoubts::Doubt& d : doubts)
    {
      if (d.Beside <= d.Width && (this->Kinds[d.Edge / 3] & sorting::Plain))
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
    if (other != Clusters::NoTriangle &&
      (this->Kinds[other] & (Cover | sorting::Plain | Aside)) == Cover && EdgeDoubts::MayBeWrong(d))
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
// from behind perhaps: where a sample is in doubt that one is drawn both ways too. True where that
// changes anything.
bool Sorter::SpreadOverOutlines(const EdgeDoubts::Lists& lists, const EdgeDoubts::Mesh& mesh)
{
  const std::vector<unsigned int>& neighbours = mesh.Triangles.GetNeighbours();
  bool changed = false;
  this->VisitPlain(lists, [&](const EdgeDoubts::Doubt& d) {
    const unsigned int other = neighbours[d.Edge];
    if ((this->Kinds[d.Edge / 3] & Cover) && other != Clusters::NoTriangle &&
      (this->Kinds[other] & (sorting::Plain | Cover)) == sorting::Plain && mesh.IsOutline(d.Edge))
    {
      this->Kinds[other] |= Cover;
      changed = true;
    }
  });
  return changed;
}

std::size_t Sorter::AppendKind(int mask, int wanted)
{
  const std::size_t before = this->Order.size();
  for (std::size_t i = 0; i < this->Kinds.size(); i++)
  {
    if ((this->Kinds[i] & mask) == wanted)
    {
      this->Order.push_back(static_cast<unsigned int>(i));
    }
  }
  return this->Order.size() - before;
}

// Those for eyes from one to the other, -1 to 1, once a piece.
std::size_t Sorter::AppendPieces(int from, int to)
{
  const std::size_t before = this->Order.size();
  for (const CoverPiece& piece : this->Pieces)
  {
    if (piece.Eye >= from && piece.Eye <= to)
    {
      this->Order.push_back(piece.Triangle);
    }
  }
  return this->Order.size() - before;
}

Sorter::Lot Sorter::AppendLot(int mask, int wanted)
{
  Lot lot;
  const std::size_t before = this->Order.size();
  if (this->Eyes > 1)
  {
    lot.Left = this->AppendKind(mask | NotBoth, wanted | NotRight);
  }
  this->AppendKind(mask | NotBoth, wanted);
  if (this->Eyes > 1)
  {
    lot.Right = this->AppendKind(mask | NotBoth, wanted | NotLeft);
  }
  lot.All = this->Order.size() - before;
  return lot;
}

// Reaches and pieces as the calm triangles are in order, which begin there.
void Sorter::OrderReaches(std::size_t first, std::size_t left)
{
  std::vector<unsigned int> ordered;
  ordered.reserve(this->Calm.All);
  const auto add = [&](int from, int to) {
    for (std::size_t i = 0; i < this->Pieces.size(); i++)
    {
      if (this->Pieces[i].Eye >= from && this->Pieces[i].Eye <= to)
      {
        ordered.push_back(PieceBits | static_cast<unsigned int>(i));
      }
    }
  };
  add(-1, -1);
  const std::size_t whole = this->Calm.All - this->Pieces.size();
  for (std::size_t i = 0; i < whole; i++)
  {
    ordered.push_back(this->Reaches[this->Order[first + left + i]]);
  }
  add(0, 1);
  this->Reaches.swap(ordered);
}

void Sorter::MakeOrder()
{
  const auto add = [](std::size_t sum, unsigned char kind) {
    return sum + ((kind & Cover) != 0) + ((kind & sorting::Plain) != 0);
  };
  this->Order.clear();
  this->Order.reserve(
    std::accumulate(this->Kinds.begin(), this->Kinds.end(), this->Pieces.size(), add));
  this->Covered = this->AppendLot(Cover | sorting::Calm | Cut, Cover);
  const std::size_t first = this->Order.size();
  const std::size_t left = this->AppendPieces(-1, -1);
  this->Calm = this->AppendLot(Cover | sorting::Calm | Cut, Cover | sorting::Calm);
  const std::size_t others = this->AppendPieces(0, 1);
  this->Calm.All += left + others;
  this->Calm.Left += left;
  this->Calm.Right += this->Eyes > 1 ? others : 0;
  this->OrderReaches(first, left);
  this->Plain = this->AppendLot(sorting::Plain, sorting::Plain);
}
}
