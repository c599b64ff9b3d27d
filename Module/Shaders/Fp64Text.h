// SPDX-License-Identifier: BSD-3-Clause
// The rays of a projection in double, for the fragment stage.
#ifndef WideFoVFp64Text_h
#define WideFoVFp64Text_h

#include "Projections/Projection.h"

#include <string>

namespace wfv
{
namespace shader
{
// What `float` was is `double`; every name that begins with wfv, Wfv or WFV_ goes on with Fp64.
std::string ToFp64(const std::string& glsl);

// wfvFp64RayOfMap and all that it asks. Made once.
const std::string& Fp64Source(const Projection& projection);
}
}

#endif
