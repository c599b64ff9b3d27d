// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Text/Angles.h"

#include <vtkPointData.h>

#include <cmath>

namespace widefov
{
namespace
{
}

Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}

Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

Vector3 operator*(double s, const Vector3& v)
{
  return { { s * v[0], s * v[1], s * v[2] } };
}

Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double Length(const Vector3& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

Vector3 Unit(const Vector3& v)
{
  const double length = Length(v);
  return length > 0 ? (1 / length) * v : Vector3{ { 0, 0, 1 } };
}

MeshBuilder::MeshBuilder()
{
  this->Normals->SetName("Normals");
  this->Normals->SetNumberOfComponents(3);
  this->Colors->SetName("Colors");
  this->Colors->SetNumberOfComponents(3);
}

vtkIdType MeshBuilder::AddPoint(
  const Vector3& position, const Vector3& normal, const Vector3& color)
{
  this->Normals->InsertNextTuple(normal.data());
  this->Colors->InsertNextTuple3(255 * color[0], 255 * color[1], 255 * color[2]);
  return this->Points->InsertNextPoint(position.data());
}

void MeshBuilder::AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
{
  const vtkIdType ids[3] = { a, b, c };
  this->Triangles->InsertNextCell(3, ids);
}

void MeshBuilder::AddQuad(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, const Vector3& color)
{
  const Vector3 normal = Unit(Cross(c - a, d - b));
  const vtkIdType first = this->AddPoint(a, normal, color);
  this->AddPoint(b, normal, color);
  this->AddPoint(c, normal, color);
  this->AddPoint(d, normal, color);
  this->AddTriangle(first, first + 1, first + 2);
  this->AddTriangle(first, first + 2, first + 3);
}

void MeshBuilder::AddGrid(int nu, int nv, const Surface& surface, const Vector3& color)
{
  constexpr double Step = 1e-4; // of the parameters; for the tangents
  const vtkIdType first = this->Points->GetNumberOfPoints();
  for (int j = 0; j <= nv; j++)
  {
    for (int i = 0; i <= nu; i++)
    {
      const double u = double(i) / nu;
      const double v = double(j) / nv;
      const Vector3 du = surface(u + Step, v) - surface(u - Step, v);
      const Vector3 dv = surface(u, v + Step) - surface(u, v - Step);
      this->AddPoint(surface(u, v), Unit(Cross(du, dv)), color);
    }
  }
  for (int j = 0; j < nv; j++)
  {
    for (int i = 0; i < nu; i++)
    {
      const vtkIdType a = first + j * (nu + 1) + i;
      this->AddTriangle(a, a + 1, a + nu + 2);
      this->AddTriangle(a, a + nu + 2, a + nu + 1);
    }
  }
}

void MeshBuilder::AddTiles(int nu, int nv, const Surface& surface, const TileColor& color)
{
  for (int j = 0; j < nv; j++)
  {
    for (int i = 0; i < nu; i++)
    {
      const double u[2] = { double(i) / nu, double(i + 1) / nu };
      const double v[2] = { double(j) / nv, double(j + 1) / nv };
      this->AddQuad(surface(u[0], v[0]), surface(u[1], v[0]), surface(u[1], v[1]),
        surface(u[0], v[1]), color(i, j));
    }
  }
}

void MeshBuilder::AddLathe(const Vector3& foot, int sectors, int rows,
  const std::function<std::array<double, 2>(double)>& profile, const Vector3& color)
{
  this->AddGrid(
    sectors, rows,
    [&](double u, double v) {
      const std::array<double, 2> p = profile(v);
      const double angle = -2 * Pi * u; // so that the normals point outwards
      return foot + Vector3{ { p[0] * std::cos(angle), p[1], p[0] * std::sin(angle) } };
    },
    color);
}

void MeshBuilder::AddRosette(
  const Vector3& center, double radius, int triangles, const Vector3& dark, const Vector3& light)
{
  const Vector3 up{ { 0, 1, 0 } };
  const auto rim = [&](int i) {
    const double angle = 2 * Pi * (i % triangles) / triangles;
    return center + radius * Vector3{ { std::cos(angle), 0, -std::sin(angle) } };
  };
  for (int i = 0; i < triangles; i++)
  {
    const Vector3& color = 24 * i / triangles % 2 == 0 ? dark : light;
    const vtkIdType a = this->AddPoint(center, up, color);
    const vtkIdType b = this->AddPoint(rim(i), up, color);
    const vtkIdType c = this->AddPoint(rim(i + 1), up, color);
    this->AddTriangle(a, b, c);
  }
}

vtkSmartPointer<vtkPolyData> MeshBuilder::Build()
{
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(this->Points);
  mesh->SetPolys(this->Triangles);
  mesh->GetPointData()->SetNormals(this->Normals);
  mesh->GetPointData()->SetScalars(this->Colors);
  return mesh;
}
}
