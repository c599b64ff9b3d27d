// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace wfv
{
namespace reference
{
namespace
{
// Triangles that are not worth two more boxes.
constexpr std::uint32_t LeafSize = 2;

// Places at which a node may be cut in two, along the longest side of its centres.
constexpr int Slots = 16;

// From this depth on nodes are halved, so that a path has at most that many and 32 nodes.
constexpr int MostUneven = 64;

// Parts that are kept for rays that are asked together: each of them looks at all.
constexpr std::size_t MostParts = 256;

double Area(const Box& b)
{
  const vec3 s = b.High - b.Low;
  return s.x < 0 ? 0 : s.x * s.y + s.y * s.z + s.z * s.x;
}

double SizeAlong(const Box& b, int axis)
{
  return b.High[axis] - b.Low[axis];
}

int LongestAxis(const Box& b)
{
  const int xy = SizeAlong(b, 1) > SizeAlong(b, 0) ? 1 : 0;
  return SizeAlong(b, 2) > SizeAlong(b, xy) ? 2 : xy;
}
}

void Box::Add(const vec3& p)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Low[i] = p[i] < this->Low[i] ? p[i] : this->Low[i];
    this->High[i] = p[i] > this->High[i] ? p[i] : this->High[i];
  }
}

void Box::Add(const Box& other)
{
  this->Low = glm::min(this->Low, other.Low);
  this->High = glm::max(this->High, other.High);
}

Box Box::OfTriangle(const TriangleSoup& soup, std::size_t triangle)
{
  Box box;
  for (const vtkIdType id : soup.Triangles[triangle])
  {
    box.Add(soup.Points[std::size_t(id)]);
  }
  return box;
}

BoxRay::BoxRay(const vec3& origin, const vec3& direction)
  : Origin(origin)
  , Direction(direction)
  , Inverse(1.0 / direction)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Along[i] = std::abs(direction[i]) < LeastDirection;
  }
}

BoxRays::BoxRays(const vec3& origin, const std::vector<vec3>& directions)
  : Origin(origin)
  , Directions{ { directions.front(), directions.front() } }
{
  for (const vec3& d : directions)
  {
    this->Directions[0] = glm::min(this->Directions[0], d);
    this->Directions[1] = glm::max(this->Directions[1], d);
  }
  this->Inverses = { { 1.0 / this->Directions[0], 1.0 / this->Directions[1] } };
  for (int i = 0; i < 3; ++i)
  {
    this->Free[i] =
      this->Directions[0][i]<LeastDirection&& this->Directions[1][i]> - LeastDirection;
  }
}

bool BoxRays::MayEnter(const Box& box) const
{
  double begin = 0;
  double end = Box::Infinity;
  for (int i = 0; i < 3; ++i)
  {
    if (!this->Free[i])
    {
      const double low = box.Low[i] - this->Origin[i];
      const double high = box.High[i] - this->Origin[i];
      const double all[4] = { low * this->Inverses[0][i], low * this->Inverses[1][i],
        high * this->Inverses[0][i], high * this->Inverses[1][i] };
      begin = std::max(begin, std::min(std::min(all[0], all[1]), std::min(all[2], all[3])));
      end = std::min(end, std::max(std::max(all[0], all[1]), std::max(all[2], all[3])));
    }
  }
  return begin <= end * (1 + ShareRounding) && begin < Box::Infinity;
}

double BoxRays::Nearest(const Box& box) const
{
  double least = 0;
  double size = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double low = box.Low[i] - this->Origin[i];
    const double high = box.High[i] - this->Origin[i];
    const double all[4] = { low * this->Directions[0][i], low * this->Directions[1][i],
      high * this->Directions[0][i], high * this->Directions[1][i] };
    const double first = std::min(std::min(all[0], all[1]), std::min(all[2], all[3]));
    const double last = std::max(std::max(all[0], all[1]), std::max(all[2], all[3]));
    least += first;
    size += std::max(std::abs(first), std::abs(last));
  }
  return least - NearestRounding * size;
}

// Cuts nodes in two where the areas of the halves' boxes, times their triangles, are least.
struct TriangleTree::Builder
{
  TriangleTree& Tree;
  std::vector<Box> Boxes; // of the triangles
  struct Work
  {
    std::uint32_t Node;
    std::uint32_t Begin;
    std::uint32_t End;
    int Depth;
  };

  explicit Builder(TriangleTree& tree)
    : Tree(tree)
  {
    const std::size_t count = tree.Soup.Triangles.size();
    for (std::size_t n = 0; n < count; ++n)
    {
      this->Boxes.push_back(Box::OfTriangle(tree.Soup, n));
    }
    tree.Order.resize(count);
    std::iota(tree.Order.begin(), tree.Order.end(), 0);
    tree.Nodes.reserve(count);
  }

  double Centre(std::uint32_t triangle, int axis) const
  {
    const Box& b = this->Boxes[triangle];
    const double centre = 0.5 * b.Low[axis] + 0.5 * b.High[axis];
    return std::isfinite(centre) ? centre : 0;
  }

  void Run()
  {
    std::vector<Work> todo;
    if (!this->Boxes.empty())
    {
      this->Tree.Nodes.emplace_back();
      todo.push_back({ 0, 0, std::uint32_t(this->Boxes.size()), 0 });
    }
    while (!todo.empty())
    {
      const Work w = todo.back();
      todo.pop_back();
      Box centres;
      Box bounds;
      for (std::uint32_t i = w.Begin; i < w.End; ++i)
      {
        const std::uint32_t t = this->Tree.Order[i];
        bounds.Add(this->Boxes[t]);
        centres.Add(vec3(this->Centre(t, 0), this->Centre(t, 1), this->Centre(t, 2)));
      }
      this->Tree.Nodes[w.Node].Bounds = bounds;
      if (w.End - w.Begin <= LeafSize)
      {
        this->Tree.Nodes[w.Node].First = w.Begin;
        this->Tree.Nodes[w.Node].Count = w.End - w.Begin;
        continue;
      }
      const std::uint32_t middle = this->Cut(w, centres);
      const std::uint32_t child = std::uint32_t(this->Tree.Nodes.size());
      this->Tree.Nodes[w.Node].First = child;
      this->Tree.Nodes.resize(child + 2);
      todo.push_back({ child, w.Begin, middle, w.Depth + 1 });
      todo.push_back({ child + 1, middle, w.End, w.Depth + 1 });
    }
  }

  // Puts the triangles of the first half first.
  std::uint32_t Cut(const Work& w, const Box& centres)
  {
    const int axis = LongestAxis(centres);
    const auto first = this->Tree.Order.begin();
    std::uint32_t middle = w.Begin;
    const int slot = w.Depth < MostUneven ? this->BestSlot(w, centres, axis) : -1;
    if (slot >= 0)
    {
      const auto half = std::partition(first + w.Begin, first + w.End,
        [&](std::uint32_t t) { return this->SlotOf(t, centres, axis) < slot; });
      middle = std::uint32_t(half - first);
    }
    if (middle == w.Begin || middle == w.End)
    {
      middle = w.Begin + (w.End - w.Begin) / 2;
      std::nth_element(
        first + w.Begin, first + middle, first + w.End, [&](std::uint32_t a, std::uint32_t b) {
          return this->Centre(a, axis) < this->Centre(b, axis);
        });
    }
    return middle;
  }

  int SlotOf(std::uint32_t triangle, const Box& centres, int axis) const
  {
    const double s =
      (this->Centre(triangle, axis) - centres.Low[axis]) / SizeAlong(centres, axis) * Slots;
    return s > 0 ? int(std::min(s, double(Slots - 1))) : 0;
  }

  // The first slot of the second half; -1 where no cut is better than another.
  int BestSlot(const Work& w, const Box& centres, int axis) const
  {
    if (!(SizeAlong(centres, axis) > 0))
    {
      return -1;
    }
    std::array<Box, Slots> boxes;
    std::array<std::uint32_t, Slots> counts{};
    for (std::uint32_t i = w.Begin; i < w.End; ++i)
    {
      const int slot = this->SlotOf(this->Tree.Order[i], centres, axis);
      boxes[slot].Add(this->Boxes[this->Tree.Order[i]]);
      ++counts[slot];
    }
    std::array<double, Slots> costs{};
    const auto sweep = [&](int from, int to, int step, int offset) {
      Box box;
      double count = 0;
      for (int s = from; s != to; s += step)
      {
        box.Add(boxes[s]);
        count += counts[s];
        costs[s + offset] += count * Area(box);
      }
    };
    sweep(0, Slots - 1, 1, 1); // a cut before slot s: what lies before
    sweep(Slots - 1, 0, -1, 0);
    const auto least = std::min_element(costs.begin() + 1, costs.end());
    return std::isfinite(*least) ? int(least - costs.begin()) : -1;
  }
};

TriangleTree::TriangleTree(const TriangleSoup& soup)
  : Soup(soup)
{
  Builder(*this).Run();
  this->Boxes.reserve(this->Order.size());
  for (const std::uint32_t triangle : this->Order)
  {
    this->Boxes.push_back(Box::OfTriangle(soup, triangle));
  }
}

std::vector<TriangleTree::Part> TriangleTree::Ahead(const BoxRays& rays) const
{
  const auto farther = [](const Part& a, const Part& b) { return a.Nearest > b.Nearest; };
  std::vector<Part> leaves;
  std::vector<Part> open; // a heap, the nearest in front
  const auto add = [&](std::uint32_t n) {
    const Node& node = this->Nodes[n];
    if (rays.MayEnter(node.Bounds))
    {
      std::vector<Part>& to = node.Count > 0 ? leaves : open;
      to.push_back({ rays.Nearest(node.Bounds), n });
      if (node.Count == 0)
      {
        std::push_heap(open.begin(), open.end(), farther);
      }
    }
  };
  if (!this->Nodes.empty())
  {
    add(0);
  }
  while (!open.empty() && open.size() + leaves.size() < MostParts)
  {
    std::pop_heap(open.begin(), open.end(), farther);
    const std::uint32_t first = this->Nodes[open.back().Node].First;
    open.pop_back();
    add(first);
    add(first + 1);
  }
  leaves.insert(leaves.end(), open.begin(), open.end());
  std::sort(leaves.begin(), leaves.end(),
    [](const Part& a, const Part& b) { return a.Nearest < b.Nearest; });
  return leaves;
}
}
}
