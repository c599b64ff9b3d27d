// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleSoup.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace wfv
{
namespace reference
{
namespace
{
vec3 Apply(const Pose& m, const double p[3])
{
  return vec3(m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3],
    m[4] * p[0] + m[5] * p[1] + m[6] * p[2] + m[7],
    m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11]);
}

void AddTriangle(TriangleSoup& soup, vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell)
{
  const std::vector<vec3>& p = soup.Points;
  if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a])
  {
    return;
  }
  soup.Triangles.push_back({ { a, b, c } });
  soup.CellIds.push_back(cell);
}

void AddCells(
  TriangleSoup& soup, vtkCellArray* cells, bool strips, vtkIdType firstPoint, vtkIdType cell)
{
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      AddTriangle(soup, firstPoint + ids[strips ? i - 1 : 0], firstPoint + ids[i],
        firstPoint + ids[i + 1], cell);
    }
  }
}
}

Pose IdentityPose()
{
  return { { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
}

TriangleSoup Triangulate(vtkPolyData* polyData, const Pose& worldToView)
{
  TriangleSoup soup;
  Append(soup, polyData, worldToView, 0);
  return soup;
}

void Append(TriangleSoup& soup, vtkPolyData* polyData, const Pose& worldToView, vtkIdType firstCell)
{
  const vtkIdType firstPoint = vtkIdType(soup.Points.size());
  const vtkIdType count = polyData->GetNumberOfPoints();
  soup.Points.reserve(firstPoint + count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    polyData->GetPoint(i, p);
    soup.Points.push_back(Apply(worldToView, p));
  }
  // Cell ids count verts, lines, polys, strips, in this order.
  const vtkIdType firstPoly =
    firstCell + polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
  AddCells(soup, polyData->GetPolys(), false, firstPoint, firstPoly);
  AddCells(soup, polyData->GetStrips(), true, firstPoint, firstPoly + polyData->GetNumberOfPolys());
}

TriangleSoup OnlyCell(const TriangleSoup& all, vtkIdType cell)
{
  TriangleSoup own;
  const auto range = std::equal_range(all.CellIds.begin(), all.CellIds.end(), cell);
  for (auto id = range.first; id != range.second; ++id)
  {
    std::array<vtkIdType, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = vtkIdType(own.Points.size());
      own.Points.push_back(all.Points[all.Triangles[id - all.CellIds.begin()][k]]);
    }
    own.Triangles.push_back(corners);
    own.CellIds.push_back(cell);
  }
  return own;
}
}
}
