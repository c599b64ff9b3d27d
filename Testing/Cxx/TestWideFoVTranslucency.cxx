// SPDX-License-Identifier: BSD-3-Clause
// Nested translucent spheres round the eye and cones behind them, with depth peeling.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <cmath>

int TestWideFoVTranslucency(int argc, char* argv[])
{
  WideFoVTestWindow test("equirectangular", 640, 320);
  test.Renderer->SetUseDepthPeeling(1);
  test.Renderer->SetMaximumNumberOfPeels(8);
  test.Renderer->AddActor(MakeTestRoom());
  AddTestCones(test.Renderer);
  for (int i = 0; i < 6; i++)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.5);
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(24);
    sphere->SetCenter(std::sin(i * 1.05), 0.25 * (i % 3), std::cos(i * 1.05));
    auto actor = MakeTestActor(sphere, i % 2, 0.5, 1 - i % 2);
    actor->GetProperty()->SetOpacity(0.4);
    test.Renderer->AddActor(actor);
  }
  return CompareWithBaseline(test.Window, argc, argv);
}
