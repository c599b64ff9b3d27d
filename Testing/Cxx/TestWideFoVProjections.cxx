// SPDX-License-Identifier: BSD-3-Clause
// A room of twelve triangles and eight cones all round, in the projection named by the
// first argument.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkProperty.h"

#include <string>

int TestWideFoVProjections(int argc, char* argv[])
{
  const std::string projection = argc > 1 ? argv[1] : "equirectangular";
  const bool square = projection == "azimuthal-equidistant";
  WideFoVTestWindow test(projection == "perspective" ? "equirectangular" : projection.c_str(),
    square ? 512 : 640, square ? 512 : 320);
  if (projection == "perspective")
  {
    test.Camera->SetFieldOfView(100);
    test.Camera->SetVerticalFieldOfView(62);
    test.Camera->SetProjectionToPerspective();
  }
  auto room = MakeTestRoom();
  // stock VTK's own surface edges fail where a triangle reaches behind a flat picture
  room->GetProperty()->SetEdgeVisibility(projection != "perspective");
  room->GetProperty()->SetEdgeColor(1, 1, 1);
  test.Renderer->AddActor(room);
  AddTestCones(test.Renderer);
  return CompareWithBaseline(test.Window, argc, argv);
}
