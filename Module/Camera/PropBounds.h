// SPDX-License-Identifier: BSD-3-Clause
// Bounds of what props draw, where GetBounds says others.
#ifndef WideFoVPropBounds_h
#define WideFoVPropBounds_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Finds the bounds of all that a prop draws (xmin, xmax, .., zmax; world). If the prop turns to the
// viewer, they hold it whichever way it is turned. False if the prop has none.
bool FindBounds(vtkProp* prop, double bounds[6]);

// Tests whether these may be others than GetBounds says.
bool HasOtherBounds(vtkProp* prop);

// The same as FindBounds from the last answer of GetBounds, if the prop is VTK's own actor: to ask
// an actor anew runs its pipeline, which takes about as long as to draw a small one.
bool FindLastBounds(vtkProp* prop, double bounds[6]);

// Returns the distance from a point to a box; 0 inside of it.
double DistanceToBox(const double point[3], const double bounds[6]);
}

#endif
