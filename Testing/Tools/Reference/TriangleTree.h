// SPDX-License-Identifier: BSD-3-Clause
// Which triangles a ray may meet: a hierarchy of boxes in double, that no rounding makes lose
// a triangle. Its answers are those of asking for the box of every triangle one by one.
#ifndef WideFoVTriangleTree_h
#define WideFoVTriangleTree_h

#include "TriangleSoup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace wfv
{
namespace reference
{
// The parameter at which a ray meets a plane of a box is a difference times an inverse: three
// roundings of half an epsilon, at either end of the share within the box, and two spare.
constexpr double ShareRounding = 4 * std::numeric_limits<double>::epsilon();

// A hit's distance is a sum of nine products: some twelve roundings of half an epsilon of the
// farthest corner's size, and as many again for the nearest corner and to spare.
constexpr double NearestRounding = 16 * std::numeric_limits<double>::epsilon();

// A direction's component below the least normal number has no finite inverse: it counts as 0.
constexpr double LeastDirection = std::numeric_limits<double>::min();

struct Box
{
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  vec3 Low{ Infinity };
  vec3 High{ -Infinity };

  // A coordinate that is no number changes nothing.
  void Add(const vec3& p);
  void Add(const Box& other);
  static Box OfTriangle(const TriangleSoup& soup, std::size_t triangle);
};

// A ray, prepared for boxes.
class BoxRay
{
public:
  BoxRay(const vec3& origin, const vec3& direction);

  // The share of the ray within the box begins there, as its parameter; infinity where the
  // ray misses it. Rounding widens a box, and the wider of two boxes has the wider share.
  double Enter(const Box& box) const;

  // No point of the box lies less far along the direction.
  double Nearest(const Box& box) const;

private:
  vec3 Origin;
  vec3 Direction;
  vec3 Inverse;              // 1 / Direction
  std::array<bool, 3> Along; // the ray does not leave the slab of this axis
};

inline double BoxRay::Enter(const Box& box) const
{
  double begin = 0;
  double end = Box::Infinity;
  for (int i = 0; i < 3; ++i)
  {
    if (this->Along[i])
    {
      if (!(box.Low[i] <= this->Origin[i] && this->Origin[i] <= box.High[i]))
      {
        return Box::Infinity;
      }
      continue;
    }
    const double a = (box.Low[i] - this->Origin[i]) * this->Inverse[i];
    const double b = (box.High[i] - this->Origin[i]) * this->Inverse[i];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  const bool meets = begin <= end * (1 + ShareRounding) && begin < Box::Infinity;
  return meets ? begin : Box::Infinity;
}

inline double BoxRay::Nearest(const Box& box) const
{
  double least = 0;
  double size = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double a = (box.Low[i] - this->Origin[i]) * this->Direction[i];
    const double b = (box.High[i] - this->Origin[i]) * this->Direction[i];
    least += std::min(a, b);
    size += std::max(std::abs(a), std::abs(b));
  }
  return least - NearestRounding * size;
}

// Neighbouring rays from one place, asked together. Of each factor of what a BoxRay computes the
// least and the largest are taken: rounding keeps products and sums in their order, so a box that
// one of the rays meets these may meet, and is no nearer to it.
class BoxRays
{
public:
  // At least one direction.
  BoxRays(const vec3& origin, const std::vector<vec3>& directions);

  // False: none of the rays meets the box.
  bool MayEnter(const Box& box) const;

  // At most BoxRay::Nearest of each ray.
  double Nearest(const Box& box) const;

private:
  vec3 Origin;
  std::array<vec3, 2> Directions; // least and largest
  std::array<vec3, 2> Inverses;   // 1 / Directions, the largest and the least
  std::array<bool, 3> Free;       // some of the directions may not leave the slab of this axis
};

class TriangleTree
{
public:
  explicit TriangleTree(const TriangleSoup& soup);

  // Calls visit(triangle) for the triangles whose boxes the ray meets, the nearer ones
  // rather first. It returns the distance beyond which triangles do not matter any more.
  template <typename Visitor>
  void Visit(const vec3& origin, const vec3& direction, Visitor&& visit) const;

  // A part of the tree, and a distance at most that of all in it.
  struct Part
  {
    double Nearest;
    std::uint32_t Node;
  };

  // All that any of the rays may meet, the nearest first.
  std::vector<Part> Ahead(const BoxRays& rays) const;

  // As Visit without, by a ray that is one of those that the parts are ahead of.
  template <typename Visitor>
  void Visit(const std::vector<Part>& parts, const vec3& origin, const vec3& direction,
    Visitor&& visit) const;

private:
  // Two children at First and First + 1, or Count > 0 triangles from Order[First] on.
  struct Node
  {
    Box Bounds;
    std::uint32_t First = 0;
    std::uint32_t Count = 0;
  };
  struct Stack // of nodes yet to be looked at
  {
    std::array<std::uint32_t, 128> Nodes;
    std::size_t Size = 0;
  };
  void Push(Stack& stack, const BoxRay& ray, const Node& parent) const;

  // Below a node, if the ray meets it.
  template <typename Visitor>
  void VisitNode(std::uint32_t root, const BoxRay& ray, double& limit, Visitor&& visit) const;

  struct Builder;
  const TriangleSoup& Soup;
  std::vector<Node> Nodes;
  std::vector<std::uint32_t> Order;
  std::vector<Box> Boxes; // of the triangles in their order
};

// The nearer child is looked at first.
inline void TriangleTree::Push(Stack& stack, const BoxRay& ray, const Node& parent) const
{
  const double a = ray.Enter(this->Nodes[parent.First].Bounds);
  const double b = ray.Enter(this->Nodes[parent.First + 1].Bounds);
  const std::uint32_t farther = a <= b ? 1 : 0;
  if (std::max(a, b) < Box::Infinity)
  {
    stack.Nodes[stack.Size++] = parent.First + farther;
  }
  if (std::min(a, b) < Box::Infinity)
  {
    stack.Nodes[stack.Size++] = parent.First + 1 - farther;
  }
}

template <typename Visitor>
void TriangleTree::VisitNode(
  std::uint32_t root, const BoxRay& ray, double& limit, Visitor&& visit) const
{
  Stack stack;
  if (ray.Enter(this->Nodes[root].Bounds) < Box::Infinity)
  {
    stack.Nodes[stack.Size++] = root;
  }
  while (stack.Size > 0)
  {
    const Node& node = this->Nodes[stack.Nodes[--stack.Size]];
    if (ray.Nearest(node.Bounds) > limit)
    {
      continue;
    }
    for (std::uint32_t i = node.First; i < node.First + node.Count; ++i)
    {
      if (ray.Enter(this->Boxes[i]) < Box::Infinity)
      {
        limit = visit(std::size_t(this->Order[i]));
      }
    }
    if (node.Count == 0)
    {
      this->Push(stack, ray, node);
    }
  }
}

template <typename Visitor>
void TriangleTree::Visit(const vec3& origin, const vec3& direction, Visitor&& visit) const
{
  double limit = Box::Infinity;
  if (!this->Nodes.empty())
  {
    this->VisitNode(0, BoxRay(origin, direction), limit, visit);
  }
}

template <typename Visitor>
void TriangleTree::Visit(
  const std::vector<Part>& parts, const vec3& origin, const vec3& direction, Visitor&& visit) const
{
  const BoxRay ray(origin, direction);
  double limit = Box::Infinity;
  for (const Part& part : parts)
  {
    if (part.Nearest > limit)
    {
      return;
    }
    this->VisitNode(part.Node, ray, limit, visit);
  }
}
}
}

#endif
