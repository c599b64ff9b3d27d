// SPDX-License-Identifier: BSD-3-Clause
#include "ScaleScenes.h"

#include <vtkAppendPolyData.h>
#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>

#include <array>
#include <cmath>

namespace wfv
{
namespace scale
{
namespace
{
// Direction number i of n, evenly spread (a Fibonacci spiral).
std::array<double, 3> Spiral(int i, int n)
{
  const double z = 1 - (2 * i + 1.0) / n;
  const double turn = i * vtkMath::Pi() * (3 - std::sqrt(5.0));
  const double r = std::sqrt(1 - z * z);
  return { { r * std::cos(turn), r * std::sin(turn), z } };
}

// Place number i of n within 40 degrees of -z, 1 to 2 away.
std::array<double, 3> Ahead(int i, int n)
{
  const double angle = vtkMath::RadiansFromDegrees(40.0) * std::sqrt((i + 0.5) / n);
  const double turn = i * vtkMath::Pi() * (3 - std::sqrt(5.0));
  const double rho = 1 + (i % 7) / 7.0;
  return { { rho * std::sin(angle) * std::cos(turn), rho * std::sin(angle) * std::sin(turn),
    -rho * std::cos(angle) } };
}
}

vtkSmartPointer<vtkActor> MakeSurface(vtkPolyData* data, const MakeMapper& mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  const vtkSmartPointer<vtkPolyDataMapper> drawn = mapper();
  drawn->SetInputData(data);
  actor->SetMapper(drawn);
  return actor;
}

Actors MakeBalls(int count, const MakeMapper& mapper)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.5 / std::sqrt(static_cast<double>(count)));
  ball->Update();
  Actors actors;
  for (int i = 0; i < count; i++)
  {
    const std::array<double, 3> d = Spiral(i, count);
    const double rho = 1 + (i % 5) / 5.0;
    actors.push_back(MakeSurface(ball->GetOutput(), mapper));
    actors.back()->SetPosition(rho * d[0], rho * d[1], rho * d[2]);
    actors.back()->GetProperty()->SetColor(0.5 + 0.5 * d[0], 0.5 + 0.5 * d[1], 0.5 + 0.5 * d[2]);
  }
  return actors;
}

vtkSmartPointer<vtkPolyData> MakeSphere(long triangles)
{
  // by hand: vtkSphereSource has at most 1024 of anything
  const long rows = std::lround(std::ceil(std::sqrt(triangles / 4.0)));
  const long columns = 2 * rows;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints((rows + 1) * columns);
  for (long j = 0; j <= rows; j++)
  {
    const double phi = vtkMath::Pi() * (static_cast<double>(j) / rows - 0.5);
    for (long i = 0; i < columns; i++)
    {
      const double lambda = 2 * vtkMath::Pi() * i / columns;
      points->SetPoint(j * columns + i, std::cos(phi) * std::cos(lambda), std::sin(phi),
        std::cos(phi) * std::sin(lambda));
    }
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(2 * rows * columns, 6 * rows * columns);
  for (long j = 0; j < rows; j++)
  {
    for (long i = 0; i < columns; i++)
    {
      const vtkIdType a = j * columns + i;
      const vtkIdType b = j * columns + (i + 1) % columns;
      cells->InsertNextCell({ a, b, a + columns });
      cells->InsertNextCell({ b, b + columns, a + columns });
    }
  }
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->SetPoints(points);
  sphere->SetPolys(cells);
  return sphere;
}

Actors MakeArrowsAndLines(int count, const MakeMapper& mapper)
{
  vtkNew<vtkArrowSource> arrow;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(arrow->GetOutputPort());
  vtkNew<vtkAppendPolyData> arrows;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (int i = 0; i < count; i++)
  {
    const std::array<double, 3> p = Ahead(i, count);
    vtkNew<vtkTransform> transform;
    transform->Translate(p.data());
    transform->RotateWXYZ(37.0 * i, 1, 0.3 * (i % 3), 0.2);
    transform->Scale(0.02, 0.02, 0.02);
    vtkNew<vtkTransformPolyDataFilter> placed;
    placed->SetInputConnection(triangles->GetOutputPort());
    placed->SetTransform(transform);
    placed->Update();
    arrows->AddInputData(placed->GetOutput());
    const std::array<double, 3> q = Ahead(i + 1, count);
    lines->InsertNextCell({ points->InsertNextPoint(p.data()),
      points->InsertNextPoint(
        0.98 * p[0] + 0.02 * q[0], 0.98 * p[1] + 0.02 * q[1], 0.98 * p[2] + 0.02 * q[2]) });
  }
  arrows->Update();
  vtkNew<vtkPolyData> segments;
  segments->SetPoints(points);
  segments->SetLines(lines);
  return { MakeSurface(arrows->GetOutput(), mapper), MakeSurface(segments, mapper) };
}
}
}
