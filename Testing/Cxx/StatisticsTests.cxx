// SPDX-License-Identifier: BSD-3-Clause
// What the pass counts, and its text on the picture.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVPolyDataMapper.h"
#include "vtkWideFoVStatisticsActor.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

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
    this->Balls = { MakeBall(0, 0, -3), MakeBall(3, 0, 0.3), MakeBall(0, 0, 5) };
    for (const auto& ball : this->Balls)
    {
      this->Test.Renderer->AddActor(ball);
    }
  }
  WideFoVTestWindow Test{ "equirectangular", 512, 256 };
  std::vector<vtkSmartPointer<vtkActor>> Balls;
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

TEST(Statistics, TimesTheMakingOfClustersOnce)
{
  Half half;
  vtkWideFoVPass* const pass = half.Test.Pass();
  EXPECT_EQ(pass->GetClusterTime(), 0);
  half.Test.Window->Render();
  const double first = pass->GetClusterTime();
  EXPECT_GT(first, 0);
  half.Test.Camera->Yaw(1); // what is seen changes, meshes do not
  half.Test.Window->Render();
  EXPECT_GT(pass->GetNumberOfClassifiedMeshes(), 0);
  EXPECT_LT(pass->GetClusterTime(), 2 * first);
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

// Both meshes in each view that moves, none in one that stands: what a mesh is drawn by hangs on
// where it is seen, and on nothing that it looks like.
TEST(Statistics, MeshesAreClassifiedWhereTheirViewChanges)
{
  Half half;
  vtkWideFoVPass* const pass = half.Test.Pass();
  const auto classified = [&](double degrees) {
    half.Test.Camera->Yaw(degrees);
    half.Test.Window->Render();
    return pass->GetNumberOfClassifiedMeshes();
  };
  EXPECT_EQ(classified(0), 2);
  const vtkIdType projected = pass->GetNumberOfProjectedTriangles();
  EXPECT_GT(projected, BallTriangles / 4);
  EXPECT_LE(projected + pass->GetNumberOfCulledTriangles(), pass->GetNumberOfTriangles());
  EXPECT_EQ(classified(0), 0);
  EXPECT_EQ(pass->GetNumberOfProjectedTriangles(), projected) << "what was found is told again";
  EXPECT_EQ(classified(1), 2);
  EXPECT_EQ(classified(1), 2);
  EXPECT_EQ(classified(0), 0);
  half.Balls[0]->GetProperty()->SetColor(1, 0, 0);
  EXPECT_EQ(classified(0), 0);
  half.Balls[0]->AddPosition(0.1, 0, 0);
  EXPECT_EQ(classified(0), 1);
  half.Test.Camera->SetProjection("hammer");
  EXPECT_EQ(classified(0), 2);
}

TEST(Statistics, NothingIsProjectedWhereAllIsExact)
{
  Half half;
  vtkWideFoVPass* const pass = half.Test.Pass();
  pass->SetTechniqueToExact();
  half.Test.Window->Render();
  EXPECT_EQ(pass->GetNumberOfProjectedTriangles(), 0);
  EXPECT_GT(pass->GetNumberOfCulledClusters(), 4);
  pass->SetTechniqueToAuto();
  half.Test.Window->Render();
  EXPECT_GT(pass->GetNumberOfProjectedTriangles(), 0);
  pass->SetTolerance(0.01);
  half.Test.Window->Render();
  EXPECT_EQ(pass->GetNumberOfProjectedTriangles(), 0);
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
    EXPECT_TRUE(Tells(text, "projected ", pass->GetNumberOfProjectedDraws())) << text;
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
