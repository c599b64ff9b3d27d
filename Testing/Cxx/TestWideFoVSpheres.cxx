// SPDX-License-Identifier: BSD-3-Clause
// The stock sphere mapper round the eye: balls on the seam, at both poles, across the
// antipode, small and large, one of them half through another.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <cmath>

namespace
{
struct Balls
{
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Radii;

  void Add(double x, double y, double z, double radius)
  {
    this->Points->InsertNextPoint(x, y, z);
    this->Radii->InsertNextValue(static_cast<float>(radius));
  }
};

vtkSmartPointer<vtkPolyData> MakeBalls()
{
  Balls balls;
  for (int i = 0; i < 12; i++)
  {
    const double a = vtkMath::RadiansFromDegrees(30.0 * i);
    balls.Add(2 * std::sin(a), 0.4 * (i % 3 - 1), -2 * std::cos(a), 0.1 + 0.03 * i);
  }
  balls.Add(0.1, 2, 0.2, 0.6);   // over the upper pole
  balls.Add(0.5, -2, 0.4, 0.5);  // beside the lower one
  balls.Add(0.3, -0.6, 1, 0.25); // behind, across the seam
  balls.Add(0.55, -0.5, 1.1, 0.15);
  vtkNew<vtkFloatArray> numbers;
  vtkNew<vtkCellArray> verts; // the mapper draws every point, but bounds are those of cells
  for (vtkIdType i = 0; i < balls.Points->GetNumberOfPoints(); i++)
  {
    verts->InsertNextCell(1, &i);
    numbers->InsertNextValue(i);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(balls.Points);
  data->SetVerts(verts);
  balls.Radii->SetName("radius");
  data->GetPointData()->AddArray(balls.Radii);
  data->GetPointData()->SetScalars(numbers);
  return data;
}
}

int TestWideFoVSpheres(int argc, char* argv[])
{
  const std::string projection = argv[1];
  const bool round = projection == "azimuthal-equidistant";
  WideFoVTestWindow test(projection.c_str(), round ? 360 : 640, round ? 360 : 320);
  if (round)
  {
    test.Camera->SetFieldOfView(360);
  }
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(MakeBalls());
  mapper->SetScaleArray("radius");
  mapper->SetScalarRange(0, 15);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetSpecular(0.6);
  actor->GetProperty()->SetSpecularPower(30);
  test.Renderer->AddActor(actor);
  return CompareWithBaseline(test.Window, argc, argv);
}
