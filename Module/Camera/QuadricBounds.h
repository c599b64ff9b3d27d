// SPDX-License-Identifier: BSD-3-Clause
// How far what is drawn reaches beyond the bounds that VTK knows: those of balls, sticks,
// tubes and splats are the bounds of their points alone.
#ifndef WideFoVQuadricBounds_h
#define WideFoVQuadricBounds_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Grows the bounds of the renderer's props, in world coordinates, by the reach of its
// actors (not of parts of assemblies). The eye tells how large a size in pixels may be.
void InflateForQuadrics(vtkRenderer* renderer, const double eye[3], double bounds[6]);
}

#endif
