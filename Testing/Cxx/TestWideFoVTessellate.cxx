// SPDX-License-Identifier: BSD-3-Clause
// The technique tessellate on coarse meshes: texture coordinates, scalars, normals and cell
// colours. Only pixels at edges may differ from the technique exact.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkElevationFilter.h"
#include "vtkImageCanvasSource2D.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <cstdlib>
#include <iostream>

namespace
{
// Of 255; and the share of pixels, those at edges, that may differ by more.
constexpr int MostDifference = 8;
constexpr double MostDifferent = 0.01;

vtkSmartPointer<vtkActor> ActorOf(vtkPolyDataMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor> TexturedRoom()
{
  vtkNew<vtkImageCanvasSource2D> checker;
  checker->SetScalarTypeToUnsignedChar();
  checker->SetNumberOfScalarComponents(3);
  checker->SetExtent(0, 63, 0, 63, 0, 0);
  for (int i = 0; i < 64; i++)
  {
    const bool light = (i % 8 + i / 8) % 2 != 0;
    checker->SetDrawColor(light ? 230 : 70, 3 * i + 40, light ? 120 : 160);
    checker->FillBox(8 * (i % 8), 8 * (i % 8) + 7, 8 * (i / 8), 8 * (i / 8) + 7);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputConnection(checker->GetOutputPort());
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(6);
  cube->SetYLength(5);
  cube->SetZLength(7);
  vtkNew<vtkWideFoVPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  auto actor = ActorOf(mapper);
  actor->SetTexture(texture);
  return actor;
}

vtkSmartPointer<vtkSphereSource> Ball(double x, double y, double z)
{
  auto ball = vtkSmartPointer<vtkSphereSource>::New();
  ball->SetRadius(0.8);
  ball->SetCenter(x, y, z);
  ball->SetThetaResolution(7);
  ball->SetPhiResolution(5);
  return ball;
}

vtkSmartPointer<vtkActor> ColoredCells()
{
  auto ball = Ball(-1.6, 0.4, 0.2);
  ball->Update();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < ball->GetOutput()->GetNumberOfCells(); i++)
  {
    colors->InsertNextTuple3(37 * i % 200 + 55, 91 * i % 200 + 55, 53 * i % 200 + 55);
  }
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(ball->GetOutput());
  mesh->GetCellData()->SetScalars(colors);
  vtkNew<vtkWideFoVPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  return ActorOf(mapper);
}

vtkSmartPointer<vtkActor> ColoredPoints()
{
  vtkNew<vtkElevationFilter> height;
  height->SetInputConnection(Ball(1.2, -0.3, 1.5)->GetOutputPort());
  height->SetLowPoint(0, -1.1, 0);
  height->SetHighPoint(0, 0.5, 0);
  vtkNew<vtkWideFoVPolyDataMapper> mapper;
  mapper->SetInputConnection(height->GetOutputPort());
  mapper->InterpolateScalarsBeforeMappingOn();
  auto actor = ActorOf(mapper);
  actor->GetProperty()->SetSpecular(0.6);
  return actor;
}

double ShareOfDifferentPixels(const TestPixels& a, const TestPixels& b)
{
  long different = 0;
  for (int y = 0; y < a.Height; y++)
  {
    for (int x = 0; x < a.Width; x++)
    {
      const unsigned char* p = a.At(x, y);
      const unsigned char* q = b.At(x, y);
      const bool same = std::abs(p[0] - q[0]) <= MostDifference &&
        std::abs(p[1] - q[1]) <= MostDifference && std::abs(p[2] - q[2]) <= MostDifference;
      different += !same;
    }
  }
  return double(different) / (double(a.Width) * a.Height);
}
}

int TestWideFoVTessellate(int argc, char* argv[])
{
  WideFoVTestWindow window("equirectangular", 600, 300);
  window.Renderer->AddActor(TexturedRoom());
  window.Renderer->AddActor(ColoredCells());
  window.Renderer->AddActor(ColoredPoints());
  window.Pass()->SetTechniqueToExact();
  window.Window->Render();
  const TestPixels exact(window.Window);
  window.Pass()->SetTechniqueToTessellate();
  window.Window->Render();
  const double share = ShareOfDifferentPixels(exact, TestPixels(window.Window));
  const int draws = window.Pass()->GetNumberOfTessellateDraws();
  std::cout << "tessellated draws " << draws << ", different pixels " << share << std::endl;
  if (draws != 3 || share > MostDifferent)
  {
    std::cerr << "tessellate is not exact but at edges\n";
    return EXIT_FAILURE;
  }
  return CompareWithBaseline(window.Window, argc, argv);
}
