// SPDX-License-Identifier: BSD-3-Clause
// What a wrong distance amounts to in the picture: where a surface is seen nearly edge-on, the
// least shift of a pixel changes its distance by much.
#ifndef WideFoVDepthShift_h
#define WideFoVDepthShift_h

#include "Caster.h"

namespace wfv
{
namespace reference
{
// By how many pixels, to first order, the centre of pixel (i, j; rows from the top) must be
// moved for the plane of the triangle `hit`, which it sees, to be at the distance `drawn`.
// Infinite where no shift tells: no triangle, or a plane that is as far all round.
double DepthShift(
  const Caster& caster, int width, int height, int i, int j, const Hit& hit, double drawn);

// By how much, relative, the distance of that plane changes where each component of the ray's
// direction changes by half a step of float32, the worst way: what rounding the direction to
// float32 may make of it, all else being exact. Infinite as above.
double DepthRounding(const Caster& caster, int width, int height, int i, int j, const Hit& hit);
}
}

#endif
