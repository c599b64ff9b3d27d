// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a polydata in view coordinates, in double, each with the id of the
// cell it came from.
#ifndef WideFoVTriangleSoup_h
#define WideFoVTriangleSoup_h

#include "vtkWideFoVAbi.h"

#include "Projections/ProjectionMath.h"

#include <vtkType.h>

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace reference
{
// Row-major 4x4, world to view, affine: the last row is 0 0 0 1.
using Pose = std::array<double, 16>;

Pose IdentityPose();

struct TriangleSoup
{
  std::vector<vec3> Points;                        // view coordinates, scene units
  std::vector<std::array<vtkIdType, 3>> Triangles; // indices into Points
  std::vector<vtkIdType> CellIds;                  // of each triangle, in the polydata
};

// Polygons become the fan round their first point, strips their triangles: what VTK's
// mappers draw. Verts and lines are ignored, and so are triangles two of whose points
// coincide. The order of the triangles is that of the cell ids.
TriangleSoup Triangulate(vtkPolyData* polyData, const Pose& worldToView);

// Adds the triangles of a further polydata, for scenes of several. Its cells are numbered
// from firstCell on: give the number of all cells before it.
void Append(
  TriangleSoup& soup, vtkPolyData* polyData, const Pose& worldToView, vtkIdType firstCell);

// The triangles of one cell alone, of a soup whose cells are in order, and their points.
TriangleSoup OnlyCell(const TriangleSoup& all, vtkIdType cell);
}
}

#endif
