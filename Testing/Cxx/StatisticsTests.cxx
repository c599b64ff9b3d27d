// SPDX-License-Identifier: BSD-3-Clause
// What the pass counts, and its text on the picture.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVPolyDataMapper.h"
#include "vtkWideFoVStatisticsActor.h"

#include <gtest/gtest.h>

#include <string>

namespace
{
vtkSmartPointer<vtkActor> MakeBall(double x, double y, double z)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(40);
  ball->SetPhiResolution(40);
  vtkNew<vtkWideFoVPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(x, y, z);
  actor->RotateX(90); // runs go along meridians, to poles above and below
  return actor;
}

constexpr int BallTriangles = 2 * 40 + 2 * 40 * 37; // caps, and rows between

// A half of the sphere, with a ball ahead, a ball cut by the border and one behind.
struct Half
{
  Half()
  {
    this->Test.Camera->SetHorizontalFieldOfView(180);
    this->Test.Renderer->AddActor(MakeBall(0, 0, -3));
    this->Test.Renderer->AddActor(MakeBall(3, 0, 0.3));
    this->Test.Renderer->AddActor(MakeBall(0, 0, 5));
  }
  WideFoVTestWindow Test{ "equirectangular", 512, 256 };
};

bool Tells(const std::string& text, const char* what, long long value)
{
  return text.find(what + std::to_string(value)) != std::string::npos;
}

int CountWhite(vtkRenderWindow* window)
{
  const TestPixels pixels(window);
  int white = 0;
  for (int i = 0; i < pixels.Width * pixels.Height; i++)
  {
    const unsigned char* const p = pixels.Data->GetPointer(3 * i);
    white += p[0] > 250 && p[1] > 250 && p[2] > 250;
  }
  return white;
}
}

TEST(Statistics, CountsPropsRunsAndTriangles)
{
  Half half;
  half.Test.Window->Render();
  vtkWideFoVPass* const pass = half.Test.Pass();
  EXPECT_EQ(pass->GetNumberOfDrawnProps(), 2);
  EXPECT_EQ(pass->GetNumberOfCulledProps(), 1);
  EXPECT_EQ(pass->GetNumberOfTriangles(), 2 * BallTriangles);
  EXPECT_EQ(pass->GetNumberOfClusters(), 2 * ((BallTriangles + 127) / 128));
  EXPECT_GT(pass->GetNumberOfCulledClusters(), 4);
  EXPECT_GE(pass->GetNumberOfCulledTriangles(), 128 * (pass->GetNumberOfCulledClusters() - 2));
  EXPECT_LT(pass->GetNumberOfCulledTriangles(), 2 * BallTriangles);
  pass->CullingOff();
  half.Test.Window->Render();
  EXPECT_EQ(pass->GetNumberOfCulledTriangles(), 0);
  EXPECT_EQ(pass->GetNumberOfTriangles(), 3 * BallTriangles);
}

// In haste until a view has been drawn often, then both meshes triangle by triangle.
TEST(Statistics, ViewsAreSortedTriangleByTriangleWhenDrawnOften)
{
  Half half;
  vtkWideFoVPass* const pass = half.Test.Pass();
  const auto sorted = [&](double degrees) {
    half.Test.Camera->Yaw(degrees);
    half.Test.Window->Render();
    return pass->GetNumberOfSortedMeshes();
  };
  const auto frames = [&] {
    int count = 0;
    int meshes = 0;
    for (; count < 100 && meshes == 0; count++)
    {
      meshes = sorted(0);
    }
    EXPECT_EQ(meshes, 2);
    return count;
  };
  EXPECT_EQ(sorted(0), 0);
  EXPECT_GT(pass->GetNumberOfCulledClusters(), 4);
  const int patience = frames();
  EXPECT_GT(patience, 4);
  EXPECT_LT(patience, 30);
  EXPECT_EQ(sorted(0), 0); // known by now
  EXPECT_EQ(sorted(1), 0); // moving
  EXPECT_EQ(sorted(1), 0);
  EXPECT_GT(pass->GetNumberOfCulledClusters(), 4);
  EXPECT_EQ(frames(), patience) << "from the last of those that moved on";
  pass->SortWhileMovingOn();
  EXPECT_EQ(sorted(1), 2);
  EXPECT_EQ(sorted(1), 2);
}

TEST(Statistics, ThePictureTellsOfItsOwnFrame)
{
  Half half;
  vtkWideFoVPass* const pass = half.Test.Pass();
  half.Test.Window->Render();
  const int without = CountWhite(half.Test.Window);
  vtkNew<vtkWideFoVStatisticsActor> actor;
  actor->SetPass(pass);
  half.Test.Renderer->AddActor(actor);
  for (const bool culling : { true, false })
  {
    pass->SetCulling(culling);
    half.Test.Window->Render();
    const std::string text = actor->GetInput();
    EXPECT_TRUE(Tells(text, "props: ", culling ? 3 : 4)) << text; // with the text itself
    EXPECT_TRUE(Tells(text, "their triangles: ", pass->GetNumberOfTriangles())) << text;
    EXPECT_TRUE(Tells(text, "plain ", pass->GetNumberOfPlainDraws())) << text;
    EXPECT_TRUE(Tells(text, "pre-clip ", pass->GetNumberOfPreClipDraws())) << text;
    EXPECT_TRUE(Tells(text, "shaders: ", pass->GetNumberOfMadePrograms())) << text;
    EXPECT_EQ(text.substr(0, text.rfind('\n')), pass->GetStatistics());
    EXPECT_GT(CountWhite(half.Test.Window), without + 500) << "no letters";
  }
}

TEST(Statistics, WithoutAPassThereIsNoText)
{
  Half half;
  half.Test.Window->Render();
  const int without = CountWhite(half.Test.Window);
  vtkNew<vtkWideFoVStatisticsActor> actor;
  half.Test.Renderer->AddActor(actor);
  half.Test.Window->Render();
  EXPECT_EQ(CountWhite(half.Test.Window), without);
  {
    vtkNew<vtkWideFoVPass> other;
    actor->SetPass(other);
  }
  half.Test.Window->Render(); // it is gone
  EXPECT_EQ(actor->GetPass(), nullptr);
  EXPECT_EQ(CountWhite(half.Test.Window), without);
}
