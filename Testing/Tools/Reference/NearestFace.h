// SPDX-License-Identifier: BSD-3-Clause
// How far from a pixel a cell is, seen or hidden there.
#ifndef WideFoVNearestFace_h
#define WideFoVNearestFace_h

#include "RayCaster.h"

namespace wfv
{
namespace reference
{
// Pixels, from the place (x from the left, y from the top) to the nearest one found where a ray
// would meet the cell, were nothing before it, or where one of its edges is: a triangle that is
// seen edge-on, or has no area, is its edges alone. Between the clip spheres; inf where none is
// found within the limit. Never too small, and too large by what NearestPlace.h says, or where an
// edge is torn.
double NearestFace(
  const RayCaster& caster, int width, int height, vec2 place, vtkIdType cell, double limit);

// Pixels: rasterizers snap the corners of what is projected to such steps.
constexpr double SnapStep = 1.0 / 256;
}
}

#endif
