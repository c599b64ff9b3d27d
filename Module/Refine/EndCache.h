// SPDX-License-Identifier: BSD-3-Clause
// Keeps what a view says of the corners and the edges of a mesh, because triangles share them.
#ifndef WideFoVEndCache_h
#define WideFoVEndCache_h

#include "Refine/RefineSpace.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace wfv
{
class EndCache
{
public:
  // points: numbers of corners at the most; the tables of a small mesh are small.
  explicit EndCache(std::uint64_t points)
  {
    std::uint64_t size = 1;
    while (size < points && size < MostEnds)
    {
      size *= 2;
    }
    this->Ends.resize(size);
    this->Edges.resize(EdgesOfEnd * size);
  }

  // point: a number that the corner has alone.
  WfvEnd EndOf(RefineSpace& space, std::uint64_t point, const vec3& place)
  {
    KnownEnd& known = this->Ends[point % this->Ends.size()];
    if (known.Point != point)
    {
      known = KnownEnd{ point, space.wfvEndAt(place) };
    }
    return known.End;
  }

  // Whether an edge between two corners is drawn as it is.
  bool IsShort(
    RefineSpace& space, std::uint64_t p, std::uint64_t q, const WfvEnd& a, const WfvEnd& b)
  {
    const std::uint64_t low = p < q ? p : q;
    const std::uint64_t high = p < q ? q : p;
    KnownEdge& known = this->Edges[(low * 31 + high) % this->Edges.size()];
    if (known.Low != low || known.High != high)
    {
      known = KnownEdge{ low, high, space.IsShort(a, b) };
    }
    return known.Short;
  }

private:
  static constexpr std::uint64_t NoPoint = std::numeric_limits<std::uint64_t>::max();
  static constexpr std::uint64_t MostEnds = 1024;
  static constexpr std::uint64_t EdgesOfEnd = 4;

  struct KnownEnd
  {
    std::uint64_t Point = NoPoint;
    WfvEnd End;
  };
  struct KnownEdge
  {
    std::uint64_t Low = NoPoint;
    std::uint64_t High = NoPoint;
    bool Short = false;
  };

  // Each number has one place in its table, where the last one stays.
  std::vector<KnownEnd> Ends;
  std::vector<KnownEdge> Edges;
};
}

#endif
