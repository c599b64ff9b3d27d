// SPDX-License-Identifier: BSD-3-Clause
// A frame in which nothing has changed: nothing is compiled, chosen, classified or
// allocated anew.
#include "OwnAllocations.h"
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "Compat/CompositeMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <gtest/gtest.h>

#include <iostream>

namespace
{
constexpr int Frames = 3;

template <typename Mapper>
vtkSmartPointer<vtkActor> MakeBall(double x, double y, double z, int resolution)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(x, y, z);
  ball->SetThetaResolution(resolution);
  ball->SetPhiResolution(resolution);
  vtkNew<Mapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor> MakeGlyphs()
{
  vtkNew<vtkPointSource> points;
  points->SetNumberOfPoints(20);
  points->SetRadius(3);
  vtkNew<vtkArrowSource> arrow;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(points->GetOutputPort());
  mapper->SetSourceConnection(arrow->GetOutputPort());
  mapper->SetScaleFactor(0.2);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor> MakeBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 3; i++)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(2 * i - 2, 1, -2);
    ball->Update();
    blocks->SetBlock(i, ball->GetOutput());
  }
  vtkNew<vtkWideFoVCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

// Meshes that are classified and others, unseen ones, lines, glyphs, blocks, text.
void AddScene(WideFoVTestWindow& test)
{
  test.Renderer->AddActor(MakeTestRoom());
  AddTestCones(test.Renderer);
  test.Renderer->AddActor(MakeBall<vtkWideFoVPolyDataMapper>(0.3, 0.1, 1.5, 40));
  test.Renderer->AddActor(MakeBall<vtkWideFoVPolyDataMapper>(1, 0.1, -1.5, 40));
  test.Renderer->AddActor(MakeBall<vtkPolyDataMapper>(0, 40, 0, 8));
  vtkNew<vtkPolyDataMapper> lines;
  lines->SetInputData(MakeGraticule(4, 30, false));
  vtkNew<vtkActor> graticule;
  graticule->SetMapper(lines);
  test.Renderer->AddActor(graticule);
  test.Renderer->AddActor(MakeGlyphs());
  test.Renderer->AddActor(MakeBlocks());
  vtkNew<vtkTextActor> text;
  text->SetInput("still");
  test.Renderer->AddActor(text);
}

class Idle : public testing::TestWithParam<int>
{
};
}

TEST_P(Idle, NothingIsMadeAnew)
{
  WideFoVTestWindow test("equirectangular", 256, 128);
  test.Pass()->SetTechnique(GetParam());
  AddScene(test);
  EXPECT_EQ(test.Pass()->GetNumberOfMadePrograms(), 0);
  test.Window->Render();
  const int programs = test.Pass()->GetNumberOfMadePrograms();
  const double time = test.Pass()->GetShaderTime();
  EXPECT_GT(programs, 3);
  EXPECT_GT(time, 0);
  EXPECT_GT(test.Pass()->GetNumberOfChosenProps(), 10);
  std::cout << "first frame: " << programs << " programs in " << 1000 * time << " ms" << std::endl;
  test.Window->Render();
  for (int i = 0; i < Frames; i++)
  {
    const OwnAllocations allocations;
    test.Window->Render();
    EXPECT_EQ(allocations.Count(), 0) << "frame " << i;
    EXPECT_EQ(test.Pass()->GetNumberOfMadePrograms(), programs);
    EXPECT_EQ(test.Pass()->GetShaderTime(), time);
    EXPECT_EQ(test.Pass()->GetNumberOfChosenProps(), 0);
    EXPECT_EQ(test.Pass()->GetNumberOfClassifiedMeshes(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Techniques, Idle,
  testing::Values(
    vtkWideFoVPass::AUTO, vtkWideFoVPass::EXACT, vtkWideFoVPass::PRECLIP, vtkWideFoVPass::VERTEX));

TEST(IdleCamera, ATurnChoosesAndClassifiesButCompilesNothing)
{
  WideFoVTestWindow test("equirectangular", 256, 128);
  AddScene(test);
  test.Window->Render();
  test.Window->Render();
  const int programs = test.Pass()->GetNumberOfMadePrograms();
  test.Camera->Yaw(0.01);
  test.Window->Render();
  EXPECT_EQ(test.Pass()->GetNumberOfMadePrograms(), programs);
  EXPECT_GT(test.Pass()->GetNumberOfChosenProps(), 10);
  EXPECT_GT(test.Pass()->GetNumberOfClassifiedMeshes(), 0);
}

TEST(IdleCamera, AnotherProjectionIsCompiledOnItsFirstUse)
{
  WideFoVTestWindow test("equirectangular", 128, 64);
  AddScene(test);
  test.Window->Render();
  const int first = test.Pass()->GetNumberOfMadePrograms();
  test.Camera->SetProjection("hammer");
  test.Window->Render();
  const int second = test.Pass()->GetNumberOfMadePrograms();
  EXPECT_GT(second, first);
  // and stays in the cache
  test.Camera->SetProjection("equirectangular");
  test.Window->Render();
  EXPECT_EQ(test.Pass()->GetNumberOfMadePrograms(), second);
}

// The count itself: it would be 0 if nothing were counted.
TEST(OwnAllocations, AreFound)
{
  WideFoVTestWindow test("equirectangular", 128, 64);
  AddScene(test);
  test.Window->Render();
  const OwnAllocations allocations;
  test.Camera->Yaw(1); // meshes are classified anew
  test.Window->Render();
  EXPECT_GT(allocations.Count(), 0);
}
