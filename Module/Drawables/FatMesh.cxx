// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/FatMesh.h"

#include "Projections/Projection.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{
using wfv::vec3;

// Sines of the angles under which the plane is seen from a corner, and the edges meet there;
// radians that a corner is seen away from the edge opposite to it. A ray that is turned by the
// rounding of float32 (3e-8) meets the plane 6e-6 of the distance off at the first of them.
constexpr double LeastSine = 5e-3;
constexpr double LeastCorner = 5e-3;
constexpr double LeastWidth = 1e-3;

bool IsFatTriangle(const vec3 p[3])
{
  const double volume = std::abs(glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[0]));
  const double plane = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
  double away[3];
  double edges[3];
  for (int i = 0; i < 3; i++)
  {
    away[i] = glm::length(p[i]);
    edges[i] = glm::length(glm::cross(p[(i + 1) % 3], p[(i + 2) % 3])); // opposite to it
  }
  for (int i = 0; i < 3; i++)
  {
    const double corner = edges[(i + 1) % 3] * edges[(i + 2) % 3];
    if (!(volume > LeastSine * plane * away[i] && away[i] * volume > LeastCorner * corner &&
          volume > LeastWidth * edges[i] * away[i]))
    {
      return false;
    }
  }
  return true;
}
}

namespace wfv
{
bool IsFat(vtkPolyData* mesh, const double m[16])
{
  constexpr vtkIdType MostCorners = 4;
  if (mesh->GetNumberOfStrips() > 0 || !mesh->GetPoints())
  {
    return false;
  }
  const auto place = [&](vtkIdType point) {
    double x[3];
    mesh->GetPoint(point, x);
    vec3 seen;
    for (int i = 0; i < 3; i++)
    {
      seen[i] = m[4 * i] * x[0] + m[4 * i + 1] * x[1] + m[4 * i + 2] * x[2] + m[4 * i + 3];
    }
    return seen;
  };
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType n = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(n, corners);
    if (n > MostCorners)
    {
      return false;
    }
    for (vtkIdType i = 2; i < n; i++)
    {
      const vec3 p[3] = { place(corners[0]), place(corners[i - 1]), place(corners[i]) };
      if (!IsFatTriangle(p))
      {
        return false;
      }
    }
  }
  return true;
}
}
