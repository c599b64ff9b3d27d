// SPDX-License-Identifier: BSD-3-Clause
// The rays of a projection in double, for the fragment stage.
#ifndef WideFoVWholeText_h
#define WideFoVWholeText_h

#include "Projections/Projection.h"

#include <string>

namespace wfv
{
namespace shader
{
// What `float` was is `double`; every name that begins with wfv, Wfv or WFV_ goes on with Whole.
std::string ToWhole(const std::string& glsl);

// wfvWholeRayOfMap and all that it asks. Made once.
const std::string& WholeSource(const Projection& projection);
}
}

#endif
