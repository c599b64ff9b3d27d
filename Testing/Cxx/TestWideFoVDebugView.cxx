// SPDX-License-Identifier: BSD-3-Clause
// The debug view of a scene that holds every kind of primitive: a room of twelve
// triangles, fine balls ahead and behind, and lines.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <string>

int TestWideFoVDebugView(int argc, char* argv[])
{
  const std::string projection = argc > 1 ? argv[1] : "equirectangular";
  const bool square = projection == "azimuthal-equidistant";
  WideFoVTestWindow test(projection.c_str(), square ? 512 : 640, square ? 512 : 320);
  test.Pass()->DebugViewOn();
  test.Renderer->AddActor(MakeTestRoom());
  for (double z : { -1.0, 1.0 })
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(0.14, 0.1, z); // its edges cross the seam
    ball->SetRadius(0.4);
    ball->SetThetaResolution(24);
    ball->SetPhiResolution(24);
    auto actor = MakeTestActor(ball, 1, 0, 0);
    actor->GetProperty()->SetSpecular(0);
    test.Renderer->AddActor(actor);
  }
  vtkNew<vtkSphereSource> wires;
  wires->SetCenter(1, 0, 0);
  wires->SetRadius(0.3);
  auto actor = MakeTestActor(wires, 1, 0, 0);
  actor->GetProperty()->SetRepresentationToWireframe();
  test.Renderer->AddActor(actor);
  return CompareWithBaseline(test.Window, argc, argv);
}
