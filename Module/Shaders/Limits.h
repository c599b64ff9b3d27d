// SPDX-License-Identifier: BSD-3-Clause
// common/limits.glsl as C++.
#ifndef WideFoVLimits_h
#define WideFoVLimits_h

#include "Projections/ProjectionMath.h" // For WFV_FN

namespace wfv
{
#include "Shaders/common/limits.glsl"
}

#endif
