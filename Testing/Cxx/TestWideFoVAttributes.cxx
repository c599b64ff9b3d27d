// SPDX-License-Identifier: BSD-3-Clause
// Every attribute across the seam and the poles: cell colours, point scalars through a
// texture, a texture by coordinates, clipping planes, wireframe.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkElevationFilter.h"
#include "vtkImageCanvasSource2D.h"
#include "vtkIntArray.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTextureMapToSphere.h"

namespace
{
vtkSmartPointer<vtkActor> CellColors()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(3);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(12);
  sphere->Update();
  vtkNew<vtkIntArray> id;
  id->SetName("id");
  for (vtkIdType i = 0; i < sphere->GetOutput()->GetNumberOfCells(); i++)
  {
    id->InsertNextValue(static_cast<int>(i % 7));
  }
  sphere->GetOutput()->GetCellData()->SetScalars(id);
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputData(sphere->GetOutput());
  mapper->SetScalarRange(0, 6);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor.Get();
}

vtkSmartPointer<vtkActor> Textured()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.5);
  sphere->SetCenter(0.2, 0.1, 1.5);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(16);
  vtkNew<vtkTextureMapToSphere> coordinates;
  coordinates->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkImageCanvasSource2D> checker;
  checker->SetScalarTypeToUnsignedChar();
  checker->SetNumberOfScalarComponents(3);
  checker->SetExtent(0, 63, 0, 63, 0, 0);
  for (int i = 0; i < 64; i++)
  {
    checker->SetDrawColor((i + i / 8) % 2 ? 255 : 40, 60, (i + i / 8) % 2 ? 40 : 255);
    checker->FillBox(8 * (i % 8), 8 * (i % 8) + 7, 8 * (i / 8), 8 * (i / 8) + 7);
  }
  auto actor = MakeTestActor(coordinates, 1, 1, 1);
  vtkNew<vtkTexture> texture;
  texture->SetInputConnection(checker->GetOutputPort());
  actor->SetTexture(texture);
  return actor;
}

vtkSmartPointer<vtkActor> Clipped()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.7);
  sphere->SetCenter(0, 1.2, 0.1);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(24);
  vtkNew<vtkElevationFilter> scalars;
  scalars->SetInputConnection(sphere->GetOutputPort());
  scalars->SetLowPoint(-0.7, 0, 0);
  scalars->SetHighPoint(0.7, 0, 0);
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputConnection(scalars->GetOutputPort());
  mapper->InterpolateScalarsBeforeMappingOn();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.1, 1.2, 0.1);
  plane->SetNormal(1, 0, 0.3);
  mapper->AddClippingPlane(plane);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  return actor.Get();
}

vtkSmartPointer<vtkActor> Wireframe()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.6);
  sphere->SetCenter(0.1, -1.3, 0);
  auto actor = MakeTestActor(sphere, 1, 1, 1);
  actor->GetProperty()->SetRepresentationToWireframe();
  actor->GetProperty()->LightingOff();
  return actor;
}
}

int TestWideFoVAttributes(int argc, char* argv[])
{
  WideFoVTestWindow test("equirectangular", 640, 320);
  test.Renderer->AddActor(CellColors());
  test.Renderer->AddActor(Textured());
  test.Renderer->AddActor(Clipped());
  test.Renderer->AddActor(Wireframe());
  return CompareWithBaseline(test.Window, argc, argv);
}
