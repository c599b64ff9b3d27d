// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVEdgeDoubts.h"

#include <algorithm>
#include <cmath>

namespace
{
using namespace wfv;
using Doubt = EdgeDoubts::Doubt;

unsigned int NextCorner(unsigned int edge)
{
  return edge % 3 == 2 ? edge - 2 : edge + 1;
}

// One edge of two triangles.
bool IsSameEdge(Clusters& mesh, unsigned int a, unsigned int b)
{
  const auto place = [&](
                       unsigned int corner) { return mesh.GetPlaces()[mesh.GetCorners()[corner]]; };
  const unsigned int a0 = place(a);
  const unsigned int a1 = place(NextCorner(a));
  const unsigned int b0 = place(b);
  const unsigned int b1 = place(NextCorner(b));
  return (a0 == b0 && a1 == b1) || (a0 == b1 && a1 == b0);
}

// A chord beside a sample.
struct Passing
{
  vec2 Along;      // unit length
  double Rest = 0; // pixels: from the place beside the sample to the nearer end; below 0 beyond it

  Passing(const EdgeDoubts::Mesh& mesh, const Doubt& doubt)
  {
    const vec2 a = mesh.At(doubt.Edge);
    const vec2 b = mesh.At(NextCorner(doubt.Edge));
    const double length = glm::length(b - a);
    this->Along = length > 0 ? (b - a) / length : vec2(0);
    const double at = glm::dot(mesh.SampleAt(doubt.Sample) - a, this->Along);
    this->Rest = std::min(at, length - at);
  }
};

// Two edges that cross beside the sample, well inside both: all that meet there are seen within
// the tolerance, on whichever side of either the sample is drawn.
bool Cross(const EdgeDoubts::Mesh& mesh, const Doubt& a, const Doubt& b)
{
  const Passing first(mesh, a);
  const Passing second(mesh, b);
  const double sine = std::abs(first.Along.x * second.Along.y - first.Along.y * second.Along.x);
  const double reach = double(a.Width) + b.Width + std::max(a.Beside, b.Beside);
  return std::min(first.Rest, second.Rest) >= mesh.Tolerance && sine * mesh.Tolerance >= reach;
}

// Drawn with its chord, which may be wrong about the sample.
bool MayBeWrong(const EdgeDoubts::Mesh& mesh, const Doubt& d)
{
  return EdgeDoubts::MayBeWrong(d) && mesh.IsPlain(d.Edge / 3);
}

// Pixels: as thin as this, a triangle is too coarse for the rasterizer to tell its depth. Radians:
// a ray that is as near to an edge may be beyond it by rounding, twice what one in float32 is
// turned by and an edge in it moved, and meet the face behind first.
constexpr double Thin = 0.25;
constexpr double AtEdge = 1e-6;

// Whether it cannot be told which of two faces that meet at an outline is in front.
bool MayFold(const EdgeDoubts::Mesh& mesh, const Doubt& d)
{
  if (mesh.FromEdge(d) < AtEdge)
  {
    return true;
  }
  const unsigned int first = d.Edge - d.Edge % 3;
  const vec2 a = mesh.At(first);
  const vec2 b = mesh.At(first + 1) - a;
  const vec2 c = mesh.At(first + 2) - a;
  const double longest = std::max({ glm::length(b), glm::length(c), glm::length(c - b) });
  return !(std::abs(b.x * c.y - b.y * c.x) > Thin * longest);
}

// One edge of two triangles that know each other: the chord is the same for both, so at a sample
// both are drawn or neither or, side by side, one of them.
bool AreNeighbours(const EdgeDoubts::Mesh& mesh, const Doubt& a, const Doubt& b)
{
  const std::vector<unsigned int>& neighbours = mesh.Triangles.GetNeighbours();
  return a.Edge == b.Edge ||
    (neighbours[a.Edge] == b.Edge / 3 && IsSameEdge(mesh.Triangles, a.Edge, b.Edge));
}

bool Share(const EdgeDoubts::Mesh& mesh, const Doubt& a, const Doubt& b)
{
  const auto place = [&](unsigned int corner) {
    return mesh.Triangles.GetPlaces()[mesh.Triangles.GetCorners()[corner]];
  };
  const unsigned int a0 = place(a.Edge);
  const unsigned int a1 = place(NextCorner(a.Edge));
  const unsigned int b0 = place(b.Edge);
  const unsigned int b1 = place(NextCorner(b.Edge));
  return a0 == b0 || a0 == b1 || a1 == b0 || a1 == b1;
}

// Drawn with its chord from both sides.
bool IsOneChord(const EdgeDoubts::Mesh& mesh, const Doubt& d)
{
  const unsigned int other = mesh.Triangles.GetNeighbours()[d.Edge];
  return mesh.IsPlain(d.Edge / 3) && (other == Clusters::NoTriangle || mesh.IsPlain(other));
}

// Whether a hidden face may show at a sample beside two edges, the first of which is an outline.
// Round a corner that they share, front and back end at the same chords.
bool MayShowHidden(const EdgeDoubts::Mesh& mesh, const Doubt& outline, const Doubt& other)
{
  if (std::max(outline.Beside, other.Beside) > outline.Width + other.Width ||
    AreNeighbours(mesh, outline, other))
  {
    return false;
  }
  const bool chords = IsOneChord(mesh, outline) && IsOneChord(mesh, other);
  return !(chords && Share(mesh, outline, other)) &&
    (MayBeWrong(mesh, outline) || MayBeWrong(mesh, other)) && !Cross(mesh, outline, other);
}

// Covers it, if it is not; true where that changes anything.
bool Cover(const EdgeDoubts::Mesh& mesh, const Doubt& d)
{
  const bool plain = mesh.IsPlain(d.Edge / 3);
  if (plain)
  {
    mesh.Cover(d.Edge / 3);
  }
  return plain;
}

// The doubts of one sample: covers what is beside an outline, if either edge's chord may be wrong.
// True where that changes anything.
bool SettleSample(const Doubt* first, const Doubt* last, const EdgeDoubts::Mesh& mesh)
{
  bool changed = false;
  for (const Doubt* e = first; e != last; ++e)
  {
    if (!mesh.IsOutline(e->Edge))
    {
      continue;
    }
    const bool folds = e->Beside <= e->Width && mesh.IsPlain(e->Edge / 3) && MayFold(mesh, *e);
    if (folds || MayBeWrong(mesh, *e))
    {
      changed |= Cover(mesh, *e);
    }
    for (const Doubt* g = first; g != last; ++g)
    {
      if (MayShowHidden(mesh, *e, *g))
      {
        changed |= Cover(mesh, *e);
        changed |= Cover(mesh, *g);
      }
    }
  }
  return changed;
}

// Edges at one sample: where more pass, of a mesh much finer than the picture, all are covered, for
// to look at each two would take longer.
constexpr std::size_t MostTogether = 48;

bool CoverAll(const Doubt* first, const Doubt* last, const EdgeDoubts::Mesh& mesh)
{
  bool changed = false;
  for (const Doubt* e = first; e != last; ++e)
  {
    changed |= Cover(mesh, *e);
  }
  return changed;
}

// Those of samples beside an outline, in the order of their samples.
std::vector<Doubt> BesideOutlines(const EdgeDoubts::Lists& lists, const EdgeDoubts::Mesh& mesh)
{
  std::vector<bool> marked;
  for (const std::vector<Doubt>& doubts : lists)
  {
    for (const Doubt& d : doubts)
    {
      if (mesh.IsOutline(d.Edge))
      {
        marked.resize(std::max(marked.size(), std::size_t(d.Sample) + 1));
        marked[d.Sample] = true;
      }
    }
  }
  std::vector<Doubt> kept;
  for (const std::vector<Doubt>& doubts : lists)
  {
    for (const Doubt& d : doubts)
    {
      if (d.Sample < marked.size() && marked[d.Sample])
      {
        kept.push_back(d);
      }
    }
  }
  std::sort(kept.begin(), kept.end(), [](const Doubt& a, const Doubt& b) {
    return a.Sample != b.Sample ? a.Sample < b.Sample : a.Edge < b.Edge;
  });
  return kept;
}

// Each sample in turn. True where that changes anything.
bool SettleOnce(const std::vector<Doubt>& cases, const EdgeDoubts::Mesh& mesh)
{
  bool changed = false;
  for (std::size_t i = 0; i < cases.size();)
  {
    std::size_t j = i;
    while (j < cases.size() && cases[j].Sample == cases[i].Sample)
    {
      j++;
    }
    const Doubt* const first = cases.data() + i;
    const Doubt* const last = cases.data() + j;
    changed |= j - i > MostTogether ? CoverAll(first, last, mesh) : SettleSample(first, last, mesh);
    i = j;
  }
  return changed;
}
}

namespace wfv
{
void EdgeDoubts::Settle(const std::vector<Sight>& eyes)
{
  std::vector<std::vector<Doubt>> cases;
  for (const Sight& eye : eyes)
  {
    cases.push_back(BesideOutlines(eye.Doubts, eye.Seen));
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::size_t i = 0; i < eyes.size(); i++)
    {
      changed |= SettleOnce(cases[i], eyes[i].Seen);
    }
  }
}
}
