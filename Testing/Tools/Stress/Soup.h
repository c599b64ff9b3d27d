// SPDX-License-Identifier: BSD-3-Clause
// Triangles on their way to a polydata.
#ifndef WideFoVStressSoup_h
#define WideFoVStressSoup_h

#include "Random.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>

namespace wfv
{
namespace stress
{
using Triangle = std::array<vec3, 3>;

class Soup
{
public:
  // Points are kept as double or as float; the ray caster reads the same numbers.
  explicit Soup(bool asDouble = false)
  {
    this->Points->SetDataType(asDouble ? VTK_DOUBLE : VTK_FLOAT);
  }

  vtkIdType AddPoint(const vec3& p) { return this->Points->InsertNextPoint(p.x, p.y, p.z); }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->Cells->InsertNextCell({ a, b, c });
  }

  void Add(const Triangle& t)
  {
    const vtkIdType a = this->AddPoint(t[0]);
    const vtkIdType b = this->AddPoint(t[1]);
    this->AddTriangle(a, b, this->AddPoint(t[2]));
  }

  vtkSmartPointer<vtkPolyData> Finish()
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Cells);
    return mesh;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
};

// Round the eye at the origin: of that angular size (radians, as a tangent), somewhere
// between the two distances, tilted against the direction of view.
Triangle TriangleAround(Random& random, const vec3& direction, double size, double distance);

// Two unit vectors that make a right-handed frame with the direction.
std::array<vec3, 2> FrameOf(const vec3& direction);
}
}

#endif
