// SPDX-License-Identifier: BSD-3-Clause
// How far chords are from the edges that they stand for.
#ifndef WideFoVCurvature_h
#define WideFoVCurvature_h

#include "Projections/Projection.h"

namespace wfv
{
// The figure `curvature` of a view, NDC per squared radian: the largest second derivative of x
// or y along a great circle of unit speed, times the squared sine of the angle to the
// nearest singular point of the family (meridian: the poles; azimuthal: the antipode,
// behind the eye only; others: none), over what the window shows and ten degrees around
// it. A chord of an edge of the angle a (radians), that comes no nearer to a singular point
// than the angle s, is then at most
//   curvature a^2 / (8 sin^2 s)
// away from its edge on each axis, as long as the edge crosses no discontinuity.
//
// Computed from second differences at some 1,700 directions, and kept for the last views
// asked for. The tilt does not matter.
WFV_EXPORT double Curvature(const Projection& projection, const WfvView& view);

// As much for the first derivatives of x and of y, NDC per radian: FirstAt, times the same squared
// sine.
WFV_EXPORT vec2 Stretch(const Projection& projection, const WfvView& view);

// The largest second derivatives of x and of y along great circles of unit speed at a
// direction (unit length, in the map's own frame), NDC per squared radian; 0 where the map is
// discontinuous there.
vec2 SecondAt(const Projection& projection, const WfvView& view, const vec3& direction);

// How fast a place moves along x and y as a direction turns, at the most: NDC per radian; 0 where
// the map is discontinuous there.
vec2 FirstAt(const Projection& projection, const WfvView& view, const vec3& direction);

// Sine of the angle from a direction to the nearest singular point of a family; 1 where there
// is none.
double SineToSingularity(Family family, const vec3& direction);
}

#endif
