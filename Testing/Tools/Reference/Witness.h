// SPDX-License-Identifier: BSD-3-Clause
// The search behind RightAnswers.h, for those who want to see the turned ray itself.
#ifndef WideFoVWitness_h
#define WideFoVWitness_h

#include "Rational.h"
#include "TriangleSoup.h"

#include <optional>

namespace wfv
{
namespace reference
{
struct WitnessRequest
{
  vec3 Origin{ 0 };
  vec3 Direction{ 0 }; // of unit length
  vec2 Radii{ 0 };     // of the clip spheres, about the origin of the ray
};

// A direction, not of unit length, next to that of the ray, by which an exact ray caster sees the
// cell (-1: nothing) with some room to all sides. Of triangles at one distance any is seen; a
// triangle whose plane holds the eye is seen by no ray.
std::optional<RationalVector> FindWitness(
  const TriangleSoup& soup, const WitnessRequest& ray, vtkIdType cell);

// Whether the cell ends at the ray, and what is before it leaves a way past there: of edges in one
// plane each triangle's is decided by itself, on whichever side the others are. Where triangles
// that share an edge are before it, there is no way.
bool IsBehindEdges(const TriangleSoup& soup, const WitnessRequest& ray, vtkIdType cell);

// Whether all these directions meet the triangle, by far.
bool IsWellInside(const TriangleSoup& soup, const WitnessRequest& ray, std::size_t triangle);
}
}

#endif
