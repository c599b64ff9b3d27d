// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/IndexLimit.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <initializer_list>

namespace wfv
{
namespace
{
IndexCount& Most()
{
  static IndexCount most{ IndexCount::MostPoints, IndexCount::MostIndices };
  return most;
}

// Corners of cells, less so many of each.
vtkTypeInt64 CountCorners(vtkCellArray* cells, int less)
{
  return std::max<vtkTypeInt64>(
    0, cells->GetNumberOfConnectivityIds() - less * vtkTypeInt64(cells->GetNumberOfCells()));
}
}

IndexCount CountIndices(vtkPolyData* mesh, int representation)
{
  const bool surface = representation == VTK_SURFACE;
  // three corners a triangle, two ends an edge: of a strip each triangle has two of its own
  const vtkTypeInt64 each = surface ? 3 : representation == VTK_WIREFRAME ? 2 : 1;
  const vtkTypeInt64 inStrips = surface ? 3 : representation == VTK_WIREFRAME ? 4 : 1;
  const int less = surface ? 2 : 0;
  IndexCount count;
  count.Points = mesh->GetNumberOfPoints();
  count.Indices = std::max({ CountCorners(mesh->GetVerts(), 0),
    2 * CountCorners(mesh->GetLines(), 0), each * CountCorners(mesh->GetPolys(), less),
    inStrips * CountCorners(mesh->GetStrips(), less) });
  vtkCellArray* const strips = mesh->GetStrips();
  count.ShortStrips = strips->GetNumberOfConnectivityIds() < 2 * strips->GetNumberOfCells();
  return count;
}

IndexCount CountIndices(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  vtkDataObject* const data = mapper && mapper->GetNumberOfInputConnections(0) > 0
    ? mapper->GetInputDataObject(0, 0)
    : nullptr;
  const int representation = actor->GetProperty()->GetRepresentation();
  if (auto* const mesh = vtkPolyData::SafeDownCast(data))
  {
    return CountIndices(mesh, representation);
  }
  IndexCount all;
  if (auto* const blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (auto* const mesh = vtkPolyData::SafeDownCast(it->GetCurrentDataObject()))
      {
        const IndexCount count = CountIndices(mesh, representation);
        all.Points += count.Points;
        all.Indices += count.Indices;
        all.ShortStrips = all.ShortStrips || count.ShortStrips;
      }
    }
  }
  return all;
}

std::string FindExcess(const IndexCount& count)
{
  const IndexCount& most = Most();
  const auto excess = [](vtkTypeInt64 found, const char* what, vtkTypeInt64 limit) {
    return "it has " + std::to_string(found) + what + std::to_string(limit) +
      " is the most that OpenGL counts at a time; draw it in parts, an actor each";
  };
  if (count.ShortStrips)
  {
    return "its triangle strips have fewer than two points each; leave them out";
  }
  if (count.Points > most.Points)
  {
    return excess(count.Points, " points, and ", most.Points);
  }
  return count.Indices > most.Indices
    ? excess(
        count.Indices, " corners of triangles, ends of lines or points to draw, and ", most.Indices)
    : "";
}

void SetMostForTests(const IndexCount& most)
{
  Most() = most;
}
}
