// SPDX-License-Identifier: BSD-3-Clause
// Meshes of which float32 decides all that is seen.
#ifndef WideFoVFatMesh_h
#define WideFoVFatMesh_h

#include "Projections/Projection.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// True where no triangle of a mesh, seen from the origin, is so thin, so pointed or so nearly
// edge-on that a ray or an edge turned by the rounding of float32, some 1e-7 radians, decides about
// more than what is as near to its edges. Of polygons of more than four corners, and strips, that
// is not said. toView: row-major, affine. The time it takes is that of a few products a triangle.
WFV_EXPORT bool IsFat(vtkPolyData* mesh, const double toView[16]);
}

#endif
