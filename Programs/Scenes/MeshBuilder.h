// SPDX-License-Identifier: BSD-3-Clause
// Builds triangle meshes with normals and colours.
#ifndef WideFoVMeshBuilder_h
#define WideFoVMeshBuilder_h

#include "Look.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <functional>

namespace widefov
{
Vector3 operator+(const Vector3& a, const Vector3& b);
Vector3 operator-(const Vector3& a, const Vector3& b);
Vector3 operator*(double s, const Vector3& v);
Vector3 Cross(const Vector3& a, const Vector3& b);
double Dot(const Vector3& a, const Vector3& b);
double Length(const Vector3& v);
Vector3 Unit(const Vector3& v); // (0, 0, 1) where v is 0

class MeshBuilder
{
public:
  // A surface over [0, 1] x [0, 1].
  using Surface = std::function<Vector3(double u, double v)>;
  // Colour of the tile (i, j); red, green, blue from 0 to 1.
  using TileColor = std::function<Vector3(int i, int j)>;

  MeshBuilder();

  vtkIdType AddPoint(const Vector3& position, const Vector3& normal, const Vector3& color);
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c);

  // Two triangles with points of their own.
  void AddQuad(
    const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, const Vector3& color);

  // 2 nu nv triangles that share points: a smooth surface of one colour.
  void AddGrid(int nu, int nv, const Surface& surface, const Vector3& color);

  // 2 nu nv triangles; every tile has points, a normal and a colour of its own.
  void AddTiles(int nu, int nv, const Surface& surface, const TileColor& color);

  // The profile (x: radius, y: height; 0 to 1 along it) turned round the vertical axis
  // through `foot`: 2 sectors rows triangles.
  void AddLathe(const Vector3& foot, int sectors, int rows,
    const std::function<std::array<double, 2>(double)>& profile, const Vector3& color);

  // A flat disc, facing up, of exactly that many triangles.
  void AddRosette(
    const Vector3& center, double radius, int triangles, const Vector3& dark, const Vector3& light);

  vtkIdType GetNumberOfTriangles() const { return this->Triangles->GetNumberOfCells(); }

  // Point arrays "Normals" and "Colors" (red, green, blue, 0 to 255).
  vtkSmartPointer<vtkPolyData> Build();

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkUnsignedCharArray> Colors;
  vtkNew<vtkCellArray> Triangles;
};
}

#endif
