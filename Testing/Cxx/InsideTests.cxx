// SPDX-License-Identifier: BSD-3-Clause
// Where the renderer puts the eye: inside of what there is to see, or outside, with a word.
#include "Compat/Reports.h"
#include "Overheard.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkSphereSource.h"
#include "vtkWideFoVRenderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
// Balls of radius 0.5 at places along x.
struct Balls
{
  explicit Balls(const std::vector<double>& places)
  {
    for (const double x : places)
    {
      vtkNew<vtkSphereSource> sphere;
      sphere->SetRadius(1);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(sphere->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->SetScale(0.5);
      actor->SetPosition(x, 0, 0);
      this->Renderer->AddActor(actor);
    }
    this->Window->SetSize(200, 100);
    this->Window->AddRenderer(this->Renderer);
  }
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};
}

TEST(Inside, GoesInsideToTheMiddle)
{
  Balls balls({ -4, 4 });
  vtkCamera* const camera = balls.Renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 0);
  camera->SetFocalPoint(2, 0, 1);
  double before[3];
  camera->GetDirectionOfProjection(before);
  balls.Renderer->ResetCameraInside();
  for (int i = 0; i < 3; i++)
  {
    EXPECT_NEAR(camera->GetPosition()[i], 0, 1e-6);
    EXPECT_NEAR(camera->GetDirectionOfProjection()[i], before[i], 1e-12);
  }
}

// The middle is in a ball: the free place is at a distance from all three.
TEST(Inside, GoesInsideToWhereThereIsRoom)
{
  Balls balls({ -4, 0.4, 4 });
  balls.Renderer->ResetCameraInside();
  const double* const eye = balls.Renderer->GetActiveCamera()->GetPosition();
  for (const double x : { -4., 0.4, 4. })
  {
    EXPECT_GT(std::hypot(eye[0] - x, eye[1], eye[2]), 1.5) << x;
  }
  EXPECT_LE(std::abs(eye[0]), 4.5);
  EXPECT_LE(std::abs(eye[1]), 0.5);
}

TEST(Inside, StaysWhereThereIsNothingToBeInsideOf)
{
  vtkNew<vtkWideFoVRenderer> renderer;
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->SetPosition(1, 2, 3);
  renderer->ResetCameraInside();
  EXPECT_EQ(camera->GetPosition()[2], 3);
}

TEST(Inside, SaysOnceThatASceneIsTiny)
{
  wfv::ForgetReports();
  Balls balls({ -4, 4 });
  balls.Renderer->GetActiveCamera();
  const Overheard said;
  balls.Renderer->ResetCamera();
  balls.Renderer->GetActiveCamera()->SetPosition(0, 0, 3); // who places it is told nothing
  balls.Window->Render();
  EXPECT_EQ(said.Count("of the picture"), 0) << said.All();
  for (int i = 0; i < 3; i++)
  {
    balls.Renderer->ResetCamera();
    balls.Window->Render();
  }
  EXPECT_EQ(said.Count("of the picture"), 1) << said.All();
  wfv::ForgetReports();
  balls.Renderer->ResetCameraInside();
  balls.Window->Render();
  EXPECT_EQ(said.Count("of the picture"), 1) << said.All();
}
