// SPDX-License-Identifier: BSD-3-Clause
// A tilted dome with a lens, and a fisheye of 235 degrees beside it in the same window.
#include "WideFoVTestScene.h"

#include "vtkActor.h"

int TestWideFoVDome(int argc, char* argv[])
{
  WideFoVTestWindow test("azimuthal-equidistant", 640, 320);
  test.Camera->SetFieldOfView(180);
  test.Camera->SetTilt(75);
  test.Camera->SetLens(0.75, 0, -0.0464, 0, 0);
  test.Renderer->SetViewport(0, 0, 0.5, 1);

  vtkNew<vtkWideFoVRenderer> right;
  vtkNew<vtkWideFoVCamera> camera;
  camera->SetProjectionToAzimuthalEquidistant();
  camera->SetFieldOfView(235);
  camera->SetPosition(0.1, 0.05, 0.07);
  camera->SetFocalPoint(0.1, 0.05, -1);
  right->SetActiveCamera(camera);
  right->SetViewport(0.5, 0, 1, 1);
  right->SetBackground(0.2, 0.1, 0.1);
  test.Window->AddRenderer(right);

  for (vtkRenderer* renderer :
    { static_cast<vtkRenderer*>(test.Renderer), static_cast<vtkRenderer*>(right) })
  {
    renderer->AddActor(MakeTestRoom());
    AddTestCones(renderer);
  }
  return CompareWithBaseline(test.Window, argc, argv);
}
