// SPDX-License-Identifier: BSD-3-Clause
// A graticule round the eye, thin and fine, and a coarse and wide one that crosses the
// seam and passes the poles obliquely; points on the seam.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"

#include <string>

int TestWideFoVLines(int argc, char* argv[])
{
  const std::string projection = argc > 1 ? argv[1] : "equirectangular";
  const bool square = projection == "azimuthal-equidistant";
  WideFoVTestWindow test(projection.c_str(), square ? 512 : 640, square ? 512 : 320);
  test.Camera->SetPosition(0, 0, 0);
  test.Camera->SetFocalPoint(0, 0, -1);

  const struct
  {
    double Radius, Step, Width, Color[3];
    bool Coarse;
    int Representation;
    double Turn;
  } sets[] = { { 2, 30, 1, { 1, 1, 1 }, false, VTK_SURFACE, 0 },
    { 1.5, 90, 5, { 1, 0.5, 0.1 }, true, VTK_SURFACE, 25 },
    { 1.8, 45, 6, { 0.3, 0.8, 1 }, true, VTK_POINTS, 0 } };
  for (const auto& set : sets)
  {
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    mapper->SetInputData(MakeGraticule(set.Radius, set.Step, set.Coarse));
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(set.Color[0], set.Color[1], set.Color[2]);
    actor->GetProperty()->SetLineWidth(set.Width);
    actor->GetProperty()->SetPointSize(set.Width);
    actor->GetProperty()->SetRepresentation(set.Representation);
    actor->RotateX(set.Turn);
    test.Renderer->AddActor(actor);
  }
  return CompareWithBaseline(test.Window, argc, argv);
}
