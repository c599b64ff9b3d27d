// SPDX-License-Identifier: BSD-3-Clause
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkElevationFilter.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

WideFoVTestWindow::WideFoVTestWindow(const char* projection, int width, int height)
{
  this->Camera->SetProjection(projection);
  this->Camera->SetPosition(0.1, 0.05, 0.07);
  this->Camera->SetFocalPoint(0.1, 0.05, -1);
  this->Renderer->SetActiveCamera(this->Camera);
  this->Renderer->SetBackground(0.1, 0.1, 0.12);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
}

vtkSmartPointer<vtkActor> MakeTestActor(vtkAlgorithm* source, double r, double g, double b)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  return actor;
}

vtkSmartPointer<vtkActor> MakeTestRoom()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(4);
  cube->SetYLength(3);
  cube->SetZLength(5);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkElevationFilter> height;
  height->SetInputConnection(triangles->GetOutputPort());
  height->SetLowPoint(-2, -1.5, -2.5);
  height->SetHighPoint(2, 1.5, 2.5);
  return MakeTestActor(height, 1, 1, 1);
}

void AddTestCones(vtkRenderer* renderer)
{
  for (int i = 0; i < 8; i++)
  {
    const double a = i * vtkMath::Pi() / 4 + 0.1;
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(40);
    cone->SetHeight(0.8);
    cone->SetRadius(0.3);
    cone->SetCenter(1.5 * std::cos(a), 0.3 * (i % 3) - 0.3, 1.5 * std::sin(a));
    renderer->AddActor(MakeTestActor(cone, 1, i / 8.0, 0.2));
  }
}

vtkSmartPointer<vtkPolyData> MakeGraticule(double radius, double step, bool coarse)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const double fine = coarse ? 45 : 2;
  const auto add = [&](double lambda, double phi) {
    const double l = vtkMath::RadiansFromDegrees(lambda);
    const double p = vtkMath::RadiansFromDegrees(phi);
    lines->InsertCellPoint(points->InsertNextPoint(radius * std::cos(p) * std::sin(l),
      radius * std::sin(p), -radius * std::cos(p) * std::cos(l)));
  };
  for (double lambda = -180; lambda < 180; lambda += step)
  {
    const int n = static_cast<int>(180 / fine);
    lines->InsertNextCell(n + 1);
    for (int i = 0; i <= n; i++)
    {
      add(lambda, -90 + i * fine);
    }
  }
  for (double phi = -90 + step; phi < 90; phi += step)
  {
    const int n = static_cast<int>(360 / fine);
    lines->InsertNextCell(n + 1);
    for (int i = 0; i <= n; i++)
    {
      add(i * fine + 7, phi); // not symmetric to the seam
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

int CompareWithBaseline(vtkRenderWindow* window, int argc, char* argv[])
{
  window->Render();
  return vtkRegressionTestImage(window) == vtkRegressionTester::PASSED ? EXIT_SUCCESS
                                                                       : EXIT_FAILURE;
}

TestPixels::TestPixels(vtkRenderWindow* window)
  : Width(window->GetSize()[0])
  , Height(window->GetSize()[1])
  , Data(vtkSmartPointer<vtkUnsignedCharArray>::New())
{
  window->GetPixelData(0, 0, this->Width - 1, this->Height - 1, 0, this->Data);
}

const unsigned char* TestPixels::At(int x, int y) const
{
  return this->Data->GetPointer(3 * (static_cast<vtkIdType>(y) * this->Width + x));
}
