// SPDX-License-Identifier: BSD-3-Clause
// What the tests ask of direction maps.
#ifndef WideFoVTestSampledMap_h
#define WideFoVTestSampledMap_h

#include "DirectionMap.h"

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

Boxes CapBoxes(const vec3& centre, double angle, const WfvView& view);
}
}

#endif
