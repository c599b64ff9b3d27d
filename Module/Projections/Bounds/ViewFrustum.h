// SPDX-License-Identifier: BSD-3-Clause
// How far away lies what a view shows of a box.
#ifndef WideFoVViewFrustum_h
#define WideFoVViewFrustum_h

#include "Projections/Projection.h"

#include <array>
#include <optional>

namespace wfv
{
// Corner i has the higher end of the box's axis k where i has bit k.
using BoxCorners = std::array<vec3, 8>;

// Distance from the eye to the farthest point of a box, view coordinates, that the projection may
// show, with room for what is wide. Nothing where it shows none of the box, or where its view
// reaches 80 degrees or more from its axis, or is bounded by no one angle: then any may be seen.
WFV_EXPORT std::optional<double> FarthestSeen(
  const Projection& projection, const ViewOptions& options, const BoxCorners& corners);

// The same in a frustum about -z, its tip in the eye; 0 where none of the box is in it. Tangents of
// half its widths, in x and y.
WFV_EXPORT double FarthestInFrustum(const BoxCorners& corners, const vec2& tangents);
}

#endif
