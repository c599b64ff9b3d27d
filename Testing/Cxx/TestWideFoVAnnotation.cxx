// SPDX-License-Identifier: BSD-3-Clause
// Text and labels placed in the world land where the picture shows their points.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkLabeledDataMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

int TestWideFoVAnnotation(int argc, char* argv[])
{
  WideFoVTestWindow test("hammer", 640, 320);
  vtkNew<vtkSphereSource> places;
  places->SetRadius(2);
  places->SetThetaResolution(8);
  places->SetPhiResolution(5);
  auto dots = MakeTestActor(places, 1, 0.5, 0.1);
  dots->GetProperty()->SetRepresentationToPoints();
  dots->GetProperty()->SetPointSize(5);
  dots->GetProperty()->LightingOff();
  test.Renderer->AddActor(dots);
  vtkNew<vtkLabeledDataMapper> labels;
  labels->SetInputConnection(places->GetOutputPort());
  vtkNew<vtkActor2D> labelActor;
  labelActor->SetMapper(labels);
  test.Renderer->AddActor(labelActor);
  const struct
  {
    const char* Text;
    double Position[3];
  } texts[] = { { "ahead", { 0, 0, -2 } }, { "behind, left", { -1, 0, 2 } },
    { "right", { 2, 0, 0 } }, { "up", { 0.1, 2, -0.5 } } };
  for (const auto& t : texts)
  {
    vtkNew<vtkTextActor> text;
    text->SetInput(t.Text);
    text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    text->GetPositionCoordinate()->SetValue(t.Position[0], t.Position[1], t.Position[2]);
    text->GetTextProperty()->SetFontSize(14);
    text->GetTextProperty()->SetColor(0.5, 1, 0.6);
    test.Renderer->AddActor(text);
  }
  return CompareWithBaseline(test.Window, argc, argv);
}
