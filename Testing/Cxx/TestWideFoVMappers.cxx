// SPDX-License-Identifier: BSD-3-Clause
// Stock mappers under the pass (composite, glyphs, an assembly) and the mapper of our
// own without any pass, side by side.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "Compat/CompositeMapper.h"
#include "vtkConeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <cmath>

namespace
{
vtkSmartPointer<vtkActor> Composite()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 6; i++)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.35);
    sphere->SetCenter(1.6 * std::sin(i * 1.05), 0.8, 1.6 * std::cos(i * 1.05));
    sphere->Update();
    blocks->SetBlock(i, sphere->GetOutput());
  }
  vtkNew<vtkWideFoVCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.4, 0.8, 1);
  return actor.Get();
}

vtkSmartPointer<vtkActor> Glyphs()
{
  vtkNew<vtkSphereSource> places;
  places->SetRadius(2);
  places->SetThetaResolution(12);
  places->SetPhiResolution(7);
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(0.4);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(places->GetOutputPort());
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetOrientationArray("Normals");
  mapper->SetScaleFactor(0.5);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1, 0.7, 0.2);
  return actor.Get();
}

vtkSmartPointer<vtkAssembly> Parts()
{
  auto assembly = vtkSmartPointer<vtkAssembly>::New();
  for (int i = 0; i < 2; i++)
  {
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(24);
    cone->SetCenter(i * 0.8 - 0.4, -0.8, 1.4);
    assembly->AddPart(MakeTestActor(cone, 0.9, 0.3, 0.3 + 0.6 * i));
  }
  return assembly;
}
}

int TestWideFoVMappers(int argc, char* argv[])
{
  WideFoVTestWindow test("hammer", 640, 320);
  test.Renderer->AddActor(Composite());
  test.Renderer->AddActor(Glyphs());
  test.Renderer->AddActor(Parts());
  test.Renderer->SetViewport(0, 0, 0.5, 1);

  // no pass here: the mapper does it alone, in an ordinary renderer
  vtkNew<vtkRenderer> plain;
  plain->SetActiveCamera(test.Camera);
  plain->SetViewport(0.5, 0, 1, 1);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2);
  vtkNew<vtkWideFoVPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.5, 1, 0.5);
  actor->GetProperty()->EdgeVisibilityOn();
  plain->AddActor(actor);
  test.Window->AddRenderer(plain);
  return CompareWithBaseline(test.Window, argc, argv);
}
