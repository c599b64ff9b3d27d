// SPDX-License-Identifier: BSD-3-Clause
// Meshes that stock VTK cannot count the indices of: too large for OpenGL, or less than nothing.
#ifndef WideFoVIndexLimit_h
#define WideFoVIndexLimit_h

#include "vtkWideFoVAbi.h"

#include "Projections/Projection.h"
#include "vtkType.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// What stock VTK hands to OpenGL at a time: points are numbered with 32 bits, and a draw counts its
// indices with 31. More come round to small numbers, and other memory is read.
struct IndexCount
{
  vtkTypeInt64 Points = 0;
  vtkTypeInt64 Indices = 0; // of the kind of cells that has most
  // Strips of fewer than two points on average: VTK reckons with less than no triangles, and
  // throws.
  bool ShortStrips = false;

  static constexpr vtkTypeInt64 MostPoints = vtkTypeInt64(1) << 32;
  static constexpr vtkTypeInt64 MostIndices = (vtkTypeInt64(1) << 31) - 1;
};

// Drawn as a surface, as wireframe or as points: VTK_SURFACE...
WFV_EXPORT IndexCount CountIndices(vtkPolyData* mesh, int representation);

// Of all blocks, where there are several, for VTK draws those by one buffer.
IndexCount CountIndices(vtkActor* actor);

// Why so many cannot be drawn, with the remedy; nothing where they can.
WFV_EXPORT std::string FindExcess(const IndexCount& count);

// Takes these for the most in FindExcess, for tests: nobody has memory for more than the true ones.
WFV_EXPORT void SetMostForTests(const IndexCount& most);
}

#endif
