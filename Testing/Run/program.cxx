// SPDX-License-Identifier: BSD-3-Clause
// A program that knows nothing of wide views: draws a box ahead and one behind, and writes the
// picture into FILE.png. The scene is that of test_run.py.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <iostream>

namespace
{
void AddBox(vtkRenderer* renderer, const double bounds[6], double red, double green)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(bounds);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(box->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, 0);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
  std::cout << "classes " << renderer->GetClassName() << " "
            << renderer->GetActiveCamera()->GetClassName() << " " << mapper->GetClassName()
            << std::endl;
}

void Write(vtkRenderWindow* window, const char* file)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(file);
  writer->Write();
}
}

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    return 2;
  }
  const double ahead[6] = { -1, 0.5, -0.5, 1, -3, -2 };
  const double behind[6] = { -1, 1.5, -1.5, 1, 2, 3 };
  vtkNew<vtkRenderer> renderer;
  AddBox(renderer, ahead, 1, 0);
  AddBox(renderer, behind, 0, 1);
  renderer->GetActiveCamera()->SetPosition(0, 0, 8);
  renderer->GetActiveCamera()->SetViewAngle(50);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(400, 200);
  window->AddRenderer(renderer);
  window->Render();
  Write(window, argv[1]);
  return 0;
}
