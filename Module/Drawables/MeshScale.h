// SPDX-License-Identifier: BSD-3-Clause
// How coarse the data of a prop are: the longest edge, found once a change of the data.
// With the nearest distance of the prop it bounds how far any edge curves in the picture.
#ifndef WideFoVMeshScale_h
#define WideFoVMeshScale_h

#include "vtkWideFoVAbi.h"

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <unordered_map>

VTK_ABI_NAMESPACE_BEGIN
class vtkMapper;
class vtkPolyData;
class vtkProp;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Longest edge of the polygons, strips and lines of a polydata, in its own units.
double LongestEdge(vtkPolyData* data);

class MeshScale
{
public:
  // Longest edge of what the prop draws, scene units; infinite where that cannot be told
  // (glyphs, volumes, mappers of other kinds).
  double Get(vtkProp* prop);

private:
  struct Entry
  {
    vtkWeakPointer<vtkMapper> Mapper;
    vtkPolyData* Data = nullptr; // compared, never used
    vtkMTimeType Time = 0;
    double Longest = 0;
  };

  std::unordered_map<vtkMapper*, Entry> Entries;
};
}

#endif
