// SPDX-License-Identifier: BSD-3-Clause
// Where a ray lies in the plane of an edge, or passes a triangle that is thinner than the
// rounding of the ray, more than one cell is a right answer: each that an exact ray caster sees by
// a ray turned by next to nothing. Whether a cell is one of these is decided in rational numbers.
#ifndef WideFoVRightAnswers_h
#define WideFoVRightAnswers_h

#include "Caster.h"

#include <cmath>

namespace wfv
{
namespace reference
{
// Radians, 9e-13: rays turned by less are one. The rounding of a pixel's ray in double is some
// 1e-15; of a float32 ray, 1e-7, no more is forgiven than that.
const double AnswerAngle = std::ldexp(1.0, -40);

// Whether a ray turned by at most AnswerAngle, about where it begins, sees the cell (-1: nothing)
// in exact arithmetic: over an area, not only along a line. Or whether its own edge is there,
// beside one of what is before it (IsBehindEdges): what is behind a closed mesh is no answer. False
// where the caster has no triangles, or rays are bent.
bool IsRightAnswer(const Caster& caster, vec2 ndc, vtkIdType cell);
}
}

#endif
