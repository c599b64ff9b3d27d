// SPDX-License-Identifier: BSD-3-Clause
// What stock VTK fakes in the plane of the picture, each by the ray of the pixel: the
// stick mapper, lines as tubes, points as spheres and point gaussians. Some lie across
// the seam, over a pole or beside the eye.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
vtkSmartPointer<vtkFloatArray> NamedArray(const char* name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

// Sticks across a ring round the eye: one over the upper pole, one looked at along its axis.
vtkSmartPointer<vtkActor> MakeSticks()
{
  const struct
  {
    double Centre[3], Axis[3], Length, Radius;
  } sticks[] = { { { 0, 1.5, 0 }, { 1, 0, 0.3 }, 2, 0.2 },
    { { 1.2, 0.5, -1.2 }, { 1, 0, -1 }, 0.9, 0.25 }, { { -1.3, 0.4, -1 }, { 0, 1, 0.3 }, 1, 0.15 },
    { { 0.2, 0.7, 1.6 }, { 1, 0.3, 0 }, 1.4, 0.2 } };
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> verts;
  auto axes = NamedArray("axis", 3);
  auto sizes = NamedArray("size", 3);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (const auto& s : sticks)
  {
    const vtkIdType id = points->InsertNextPoint(s.Centre);
    verts->InsertNextCell(1, &id);
    double axis[3] = { s.Axis[0], s.Axis[1], s.Axis[2] };
    vtkMath::Normalize(axis);
    axes->InsertNextTuple(axis);
    sizes->InsertNextTuple3(s.Length, s.Radius, 0);
    colors->InsertNextTuple3(230, 90 + 40 * id, 60);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(verts);
  data->GetPointData()->AddArray(axes);
  data->GetPointData()->AddArray(sizes);
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetOrientationArray("axis");
  mapper->SetScaleArray("size");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  return actor.Get();
}

// A coarse graticule of a sphere, its lines as tubes or its points as spheres.
vtkSmartPointer<vtkActor> MakeGrid(double radius, bool tubes)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeGraticule(radius, 90, true));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetRepresentation(tubes ? VTK_SURFACE : VTK_POINTS);
  property->SetRenderLinesAsTubes(tubes);
  property->SetRenderPointsAsSpheres(!tubes);
  property->SetLineWidth(8);
  property->SetPointSize(20);
  property->SetColor(tubes ? 0.4 : 0.9, 0.7, tubes ? 1 : 0.3);
  actor->RotateX(25);
  return actor.Get();
}

vtkSmartPointer<vtkActor> MakeSplats()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> verts;
  for (int i = 0; i < 9; i++)
  {
    const double a = vtkMath::RadiansFromDegrees(40.0 * i + 20);
    const vtkIdType id =
      points->InsertNextPoint(1.5 * std::sin(a), -0.5 - 0.1 * i, 1.5 * -std::cos(a));
    verts->InsertNextCell(1, &id);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(verts);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleFactor(0.12);
  mapper->EmissiveOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.5, 1, 0.6);
  return actor.Get();
}
}

int TestWideFoVSticks(int argc, char* argv[])
{
  const std::string projection = argv[1];
  const bool round = projection == "azimuthal-equidistant";
  WideFoVTestWindow test(projection.c_str(), round ? 480 : 720, round ? 480 : 360);
  if (round)
  {
    test.Camera->SetFieldOfView(360);
  }
  test.Renderer->AddActor(MakeSticks());
  test.Renderer->AddActor(MakeGrid(2, true));
  test.Renderer->AddActor(MakeGrid(2, false));
  test.Renderer->AddActor(MakeSplats());
  return CompareWithBaseline(test.Window, argc, argv);
}
