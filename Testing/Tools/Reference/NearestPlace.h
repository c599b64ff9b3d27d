// SPDX-License-Identifier: BSD-3-Clause
// How far from a pixel a cell is seen: not by points on circles, which step over what is
// thinner than they are apart, but along the cell's own picture.
#ifndef WideFoVNearestPlace_h
#define WideFoVNearestPlace_h

#include "Caster.h"

namespace wfv
{
namespace reference
{
// Pixels, from the place (x from the left, y from the top) to the nearest place found where
// the caster sees the cell (-1: nothing); inf where none is found within the limit. A
// distance counts only where a cast ray agrees, so it is never too small; it is too large by
// ApartFromEdge, or where the cell shows through more holes between others than are tried.
double NearestPlace(
  const Caster& caster, int width, int height, vec2 place, vtkIdType cell, double limit);

// Pixels inside of the edge of what may be seen where the ray is cast: beyond the rounding
// of the edge functions by far, and far below every tolerance.
constexpr double ApartFromEdge = 1e-4;
}
}

#endif
