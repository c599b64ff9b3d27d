// SPDX-License-Identifier: BSD-3-Clause
// What the tests ask of direction maps.
#ifndef WideFoVTestSampledMap_h
#define WideFoVTestSampledMap_h

#include "Projections/DirectionMap.h"

#include <optional>

namespace wfv
{
namespace test
{
// Where a cap of the sphere may be seen (wfvCapPlaces).
struct Boxes
{
  vec4 First;
  vec4 Second;
  bool Hold(const vec2& ndc) const;
};

// A cap that one even piece of a map shows: nothing where it is not known to be one.
struct Piece
{
  vec4 Rectangle; // NDC
  double Curvature;
};
std::optional<Piece> PieceOf(const vec3& centre, double angle, const WfvView& view);

// The place of a direction, pixels, sought from the middle of a rectangle, and by how much it is
// missed.
vec3 PlaceIn(const vec4& rectangle, const vec3& direction, const WfvView& view);

// wfvBesideChord
double BesideChord(double chord, double curvature);

Boxes CapBoxes(const vec3& centre, double angle, const WfvView& view);
}
}

#endif
