// SPDX-License-Identifier: BSD-3-Clause
// From whatever VTK can hold to what a mapper can draw.
#ifndef WideFoVDatasets_h
#define WideFoVDatasets_h

#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace widefov
{
// The dataset itself, or every dataset of a composite that is not empty.
std::vector<vtkSmartPointer<vtkDataSet>> Leaves(vtkDataObject* data);

// Composite data in parts whose datasets have the same arrays: in one piece an array that a dataset
// lacks would be lost. Anything else is one part.
std::vector<vtkSmartPointer<vtkDataObject>> PartsByArrays(vtkDataObject* data);

// An image, or a grid with places of its own, of rows, columns and layers, each more than one; of a
// composite any part is a grid.
bool IsSpatialImage(vtkDataObject* data);
bool IsSpatialGrid(vtkDataObject* data);

// Cells with an inside, any.
bool FillsSpace(vtkDataObject* data);

// The surface: polydata as it is, the outside of anything else; composites in one
// piece. Points without any cell become vertices. Point and cell arrays are kept.
vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataObject* data);

// The same data with the array at the points (a cell array is averaged).
vtkSmartPointer<vtkDataObject> PointVectors(vtkDataObject* data, const std::string& array);

struct CleanResult
{
  vtkSmartPointer<vtkPolyData> Data;
  vtkIdType Dropped = 0; // cells that used a point that cannot be drawn
};

// Without the cells that use a point with a coordinate that is NaN, infinite or beyond
// 1e18 (whose square leaves a float32). Returns the data itself where there is none.
CleanResult DropUnusableCells(vtkPolyData* data);

// The names of the arrays, points first: for messages.
std::vector<std::string> ArrayNames(vtkDataObject* data);
}

#endif
