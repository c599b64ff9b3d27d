// SPDX-License-Identifier: BSD-3-Clause
// What VTK's bounds of a scene leave wrong: those of spheres, cylinders, tubes and splats are the
// bounds of their points alone, and one point at infinity makes all others nothing.
#ifndef WideFoVSceneBounds_h
#define WideFoVSceneBounds_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Where the bounds are not finite, they become those of the props that have finite ones: one prop
// with a point at infinity would have all others at the near clip sphere.
void LeaveOutEndless(vtkRenderer* renderer, double bounds[6]);

// Adds the bounds of visible props that draw elsewhere than their own bounds say (PropBounds.h).
void HoldOtherBounds(vtkRenderer* renderer, double bounds[6]);

// Grows the bounds of the renderer's props, in world coordinates, by what its
// actors draw beyond them (not parts of assemblies). The eye tells how large a size in pixels may
// be.
void InflateForQuadrics(vtkRenderer* renderer, const double eye[3], double bounds[6]);
}

#endif
