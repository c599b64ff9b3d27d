// SPDX-License-Identifier: BSD-3-Clause
#include "ScaleStage.h"

#include "InteractiveRate.h"

#include "System/Display.h"
#include "System/MessageCatcher.h"
#include "Text/Messages.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkWideFoVRenderer.h>

#include <chrono>

namespace wfv
{
namespace scale
{
namespace
{
constexpr int WarmUps = 2;

void AddAll(vtkRenderer* renderer, const Actors& actors)
{
  for (const vtkSmartPointer<vtkActor>& actor : actors)
  {
    renderer->AddActor(actor);
  }
}
}

vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height, bool moves)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  widefov::OpenWindow(window);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  if (moves)
  {
    window->SetDesiredUpdateRate(bench::InteractiveRate);
  }
  return window;
}

ScaleRun MakeWideRun(const std::string& name, const Actors& actors, const std::string& projection,
  double horizontal, double vertical)
{
  ScaleRun run;
  run.Name = name;
  run.Renderer = vtkSmartPointer<vtkWideFoVRenderer>::New();
  run.Pass = vtkSmartPointer<vtkWideFoVPass>::New();
  run.Renderer->SetPass(run.Pass);
  run.Camera = vtkSmartPointer<vtkWideFoVCamera>::New();
  run.Camera->SetProjection(projection.c_str());
  run.Camera->SetHorizontalFieldOfView(horizontal);
  run.Camera->SetVerticalFieldOfView(vertical);
  run.Camera->SetPosition(0, 0, 0);
  run.Camera->SetFocalPoint(0, 0, -1);
  run.Renderer->SetActiveCamera(run.Camera);
  AddAll(run.Renderer, actors);
  return run;
}

ScaleRun MakeStockRun(const std::string& name, const Actors& actors, double verticalAngle)
{
  ScaleRun run;
  run.Name = name;
  run.Renderer = vtkSmartPointer<vtkRenderer>::New();
  AddAll(run.Renderer, actors);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, verticalAngle > 0 ? 0 : 10);
  camera->SetFocalPoint(0, 0, -1);
  if (verticalAngle > 0)
  {
    camera->SetViewAngle(verticalAngle);
  }
  else
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(2.2);
  }
  run.Renderer->SetActiveCamera(camera);
  run.Renderer->ResetCameraClippingRange();
  return run;
}

void DrawInTurn(vtkRenderWindow* window, std::vector<ScaleRun>& runs, int frames, const Move& move)
{
  for (const ScaleRun& run : runs)
  {
    run.Renderer->DrawOff();
    window->AddRenderer(run.Renderer);
  }
  for (int frame = -WarmUps; frame < frames; frame++)
  {
    for (ScaleRun& run : runs)
    {
      run.Renderer->DrawOn();
      move(run, frame);
      const auto start = std::chrono::steady_clock::now();
      window->Render();
      window->WaitForCompletion();
      const std::chrono::duration<double, std::milli> time =
        std::chrono::steady_clock::now() - start;
      run.Renderer->DrawOff();
      if (frame >= 0)
      {
        run.Milliseconds.push_back(time.count());
      }
      const std::string error = widefov::MessageCatcher::TakeFirstError();
      if (!error.empty())
      {
        widefov::Fail("drawing " + run.Name + " failed: " + error);
      }
    }
  }
  for (const ScaleRun& run : runs)
  {
    window->RemoveRenderer(run.Renderer);
  }
}
}
}
