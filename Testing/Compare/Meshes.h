// SPDX-License-Identifier: BSD-3-Clause
// Closed meshes round the origin, of any fineness.
#ifndef WideFoVTestMeshes_h
#define WideFoVTestMeshes_h

#include "vtkWideFoVAbi.h"

#include "Projections/ProjectionMath.h"
#include "TriangleSoup.h"

#include <vtkSmartPointer.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace test
{
// Where a mesh lies in the world: p -> centre + scale * p. Points are kept as float, so
// that the mapper and the ray caster see the same numbers, or as double.
struct Placement
{
  vec3 Centre{ 0 };
  double Scale = 1;
  bool Double = false;
};

// The unit sphere as an octahedron of n x n triangles a face, pushed outwards: vertices on
// the axes, edges in the planes x = 0, y = 0 and z = 0, and no thin triangle anywhere. The
// vertex k from an axis towards another lies at atan2(k, n - k).
vtkSmartPointer<vtkPolyData> MakeGlobe(int n, const Placement& where = {});

// The cube [-1, 1]^3, n x n cells of two triangles a face, their borders at equal angles
// as seen from its centre; n even puts a vertex into the middle of each face.
vtkSmartPointer<vtkPolyData> MakeRoom(int n, const Placement& where = {});

// The globe of one cell a face with one vertex more: so far beside the meridian x = 0 ahead, to the
// right or, where it is negative, to the left, and so far below the equator (radians). One triangle
// from the equator to the pole is no wider than that.
vtkSmartPointer<vtkPolyData> MakeSplinter(double aside, double below);

// A tube of that many sides and of one row, closed by a cone at either end: triangles as long as
// the tube, and others that meet in a tip. Along y, its tips at -1 and 1, its radius 0.4.
vtkSmartPointer<vtkPolyData> MakeTube(int sides, const Placement& where = {});

// Hills all round: so many rows of triangle strips between two poles, each with twice as many
// steps, at distances from 0.7 to 1; cones of triangles at the poles.
vtkSmartPointer<vtkPolyData> MakeHills(int rows, const Placement& where = {});

// The longest edge of the mesh as seen from the origin of view coordinates, degrees; edges
// that reach inside the given radius do not count.
double LongestEdge(const reference::TriangleSoup& soup, double nearRadius);
}
}

#endif
