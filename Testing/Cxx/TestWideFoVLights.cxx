// SPDX-License-Identifier: BSD-3-Clause
// A headlight, a scene light and a positional spot at once: the headlight must shine
// in every direction, the others stay as in VTK.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

int TestWideFoVLights(int argc, char* argv[])
{
  WideFoVTestWindow test("equirectangular", 640, 320);
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  head->SetIntensity(0.4);
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(0, 0, 0);
  sun->SetFocalPoint(1, -0.5, 0);
  sun->SetColor(1, 0.8, 0.3);
  sun->SetIntensity(0.5);
  vtkNew<vtkLight> spot;
  spot->SetLightTypeToSceneLight();
  spot->PositionalOn();
  spot->SetConeAngle(30);
  spot->SetPosition(0, 0, 0);
  spot->SetFocalPoint(0, 0.3, 1);
  spot->SetColor(0.3, 0.5, 1);
  test.Renderer->AddLight(head);
  test.Renderer->AddLight(sun);
  test.Renderer->AddLight(spot);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(3);
  sphere->SetThetaResolution(96);
  sphere->SetPhiResolution(48);
  auto actor = MakeTestActor(sphere, 0.9, 0.9, 0.9);
  actor->GetProperty()->SetSpecular(0.3);
  actor->GetProperty()->SetSpecularPower(20);
  test.Renderer->AddActor(actor);
  AddTestCones(test.Renderer);
  return CompareWithBaseline(test.Window, argc, argv);
}
