// SPDX-License-Identifier: BSD-3-Clause
// What the sources of wfv::DirectionMap and the registry share: direction-map.glsl as C++.
#ifndef WideFoVDirectionTables_h
#define WideFoVDirectionTables_h

#include "Projections/DirectionMap.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
#define float double
namespace wfv
{
namespace tables
{
#include "Projections/library/cube_faces.glsl"
#include "Projections/library/direction_rays.glsl"
#include "Projections/library/direction_places.glsl"

#include "Projections/direction-map.glsl"
#include "Projections/library/unproject.glsl"
}
}
#undef float
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace wfv
{
namespace tables
{
using Texel = DirectionMap::Texel;

inline vec3 DirectionOf(const Texel& t)
{
  return vec3(t[0], t[1], t[2]);
}

// Angle from a pixel's own direction to the farthest that it shows.
double RadiusOf(const DirectionMap& map, int x, int y);
}
}

#endif
