// SPDX-License-Identifier: BSD-3-Clause
// A mesh of fewer triangles that looks like another one from afar: what is drawn while the view
// moves.
#ifndef WideFoVCoarseMesh_h
#define WideFoVCoarseMesh_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace widefov
{
// All points of a cube of that size become one of them, with its data. Triangles that become lines
// are lines, so that tubes and edges stay; those that become a point go. Cells keep their data.
// vtkBinnedDecimation and vtkQuadricClustering leave out all tubes, and lines.
vtkSmartPointer<vtkPolyData> MakeCoarse(vtkPolyData* mesh, double size);
}

#endif
