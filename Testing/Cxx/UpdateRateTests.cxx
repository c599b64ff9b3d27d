// SPDX-License-Identifier: BSD-3-Clause
// A pass that keeps the window's update rate: coarser while it has little time, else as without.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
constexpr double Hasty = 1e9; // frames a second: nothing is that fast
constexpr double Still = 1e-4;

void AddScene(WideFoVTestWindow& test)
{
  AddTestCones(test.Renderer);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.3, 0.1, 1.5);
  ball->SetThetaResolution(40);
  ball->SetPhiResolution(40);
  test.Renderer->AddActor(MakeTestActor(ball, 0.8, 0.6, 0.2));
}

bool Same(const TestPixels& a, const TestPixels& b)
{
  return a.Data->GetNumberOfValues() == b.Data->GetNumberOfValues() &&
    std::equal(a.Data->GetPointer(0), a.Data->GetPointer(0) + a.Data->GetNumberOfValues(),
      b.Data->GetPointer(0));
}
}

TEST(UpdateRate, StandingStillIsAsWithout)
{
  WideFoVTestWindow test("equirectangular", 256, 128);
  AddScene(test);
  test.Window->Render();
  const TestPixels without(test.Window);
  const int preClip = test.Pass()->GetNumberOfPreClipDraws();
  test.Pass()->KeepUpdateRateOn();
  test.Window->SetDesiredUpdateRate(Hasty);
  for (int i = 0; i < 4; i++)
  {
    test.Window->Render();
  }
  EXPECT_EQ(test.Pass()->GetRelaxation(), 2);
  test.Window->SetDesiredUpdateRate(Still);
  test.Window->Render();
  EXPECT_EQ(test.Pass()->GetRelaxation(), 0);
  EXPECT_EQ(test.Pass()->GetNumberOfPreClipDraws(), preClip);
  EXPECT_TRUE(Same(TestPixels(test.Window), without));
}

TEST(UpdateRate, WithTimeToSpareNothingIsRelaxed)
{
  WideFoVTestWindow test("hammer", 256, 128);
  AddScene(test);
  test.Pass()->KeepUpdateRateOn();
  test.Window->SetDesiredUpdateRate(Hasty);
  for (int i = 0; i < 4; i++)
  {
    test.Window->Render();
  }
  // a share of a second, of which it needs little
  test.Window->SetDesiredUpdateRate(1);
  for (int i = 0; i < 4; i++)
  {
    test.Window->Render();
  }
  EXPECT_EQ(test.Pass()->GetRelaxation(), 0);
}

TEST(UpdateRate, IsNotKeptUnlessAsked)
{
  WideFoVTestWindow test("equirectangular", 64, 32);
  AddScene(test);
  test.Window->SetDesiredUpdateRate(Hasty);
  for (int i = 0; i < 4; i++)
  {
    test.Window->Render();
  }
  EXPECT_EQ(test.Pass()->GetRelaxation(), 0);
}
