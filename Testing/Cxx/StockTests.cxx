// SPDX-License-Identifier: BSD-3-Clause
// With a perspective camera the pass and the mapper are stock VTK, to the pixel.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{
enum class Way
{
  Stock,
  Pass,
  Mapper,
  PerspectiveCamera
};

void AddStockScene(vtkRenderer* renderer, bool own)
{
  for (int i = 0; i < 6; i++)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(i - 2.5, 0.2 * i, -4);
    vtkSmartPointer<vtkPolyDataMapper> mapper;
    mapper.TakeReference(own ? vtkWideFoVPolyDataMapper::New() : vtkOpenGLPolyDataMapper::New());
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.2 * i, 1, 0.5);
    actor->GetProperty()->SetOpacity(i % 2 ? 0.5 : 1);
    actor->GetProperty()->SetEdgeVisibility(i == 2);
    actor->GetProperty()->SetRepresentation(i == 4 ? VTK_WIREFRAME : VTK_SURFACE);
    actor->GetProperty()->SetLineWidth(i == 4 ? 4 : 1);
    renderer->AddActor(actor);
  }
}

vtkSmartPointer<vtkUnsignedCharArray> Picture(Way way)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(300, 200);
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkCamera> stock;
  vtkNew<vtkWideFoVCamera> wide;
  wide->SetProjectionToPerspective();
  // the wide camera takes its angles as they are; the stock one from the aspect
  wide->SetVerticalFieldOfView(40);
  wide->SetHorizontalFieldOfView(
    2 * vtkMath::DegreesFromRadians(std::atan(1.5 * std::tan(vtkMath::RadiansFromDegrees(20.0)))));
  vtkCamera* camera = way == Way::PerspectiveCamera ? wide.Get() : stock.Get();
  camera->SetViewAngle(40);
  camera->SetPosition(0, 0.5, 4);
  camera->SetFocalPoint(0, 0.3, -4);
  camera->SetClippingRange(1, 20);
  renderer->SetActiveCamera(camera);
  vtkNew<vtkWideFoVPass> pass;
  if (way == Way::Pass)
  {
    renderer->SetPass(pass);
  }
  AddStockScene(renderer, way == Way::Mapper);
  window->AddRenderer(renderer);
  window->Render();
  return TestPixels(window).Data;
}

// Number of bytes that differ by more than the tolerance.
int Differences(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b, int tolerance)
{
  EXPECT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
  int n = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); i++)
  {
    n += std::abs(a->GetValue(i) - b->GetValue(i)) > tolerance;
  }
  return n;
}
}

TEST(Stock, PassAndMapperChangeNothing)
{
  auto stock = Picture(Way::Stock);
  EXPECT_EQ(Differences(stock, Picture(Way::Pass), 0), 0);
  EXPECT_EQ(Differences(stock, Picture(Way::Mapper), 0), 0);
  // and the test can fail: another scene is another picture
  int colored = 0;
  for (vtkIdType i = 0; i < stock->GetNumberOfValues(); i++)
  {
    colored += stock->GetValue(i) != 0;
  }
  EXPECT_GT(colored, 1000);
}

TEST(Stock, ThePerspectiveProjectionIsThePerspectiveCamera)
{
  // the same frustum by another way round: edges may differ in their last bit
  const int n = Differences(Picture(Way::Stock), Picture(Way::PerspectiveCamera), 2);
  EXPECT_LE(n, 3 * 300 * 200 / 1000);
}
