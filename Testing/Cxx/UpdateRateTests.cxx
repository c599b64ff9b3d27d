// SPDX-License-Identifier: BSD-3-Clause
// A pass that keeps the window's update rate: smaller while it has little time, else as without.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"
#include "Compat/Gl.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <vector>

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
  test.Pass()->SetRelaxationRange(vtkWideFoVPass::QUARTER_SIZE, vtkWideFoVPass::QUARTER_SIZE);
  test.Window->Render();
  EXPECT_EQ(test.Pass()->GetRelaxation(), vtkWideFoVPass::QUARTER_SIZE);
  EXPECT_FALSE(Same(TestPixels(test.Window), without));
  test.Window->SetDesiredUpdateRate(Still);
  test.Window->Render();
  EXPECT_EQ(test.Pass()->GetRelaxation(), 0);
  EXPECT_EQ(test.Pass()->GetNumberOfPreClipDraws(), preClip);
  EXPECT_TRUE(Same(TestPixels(test.Window), without));
}

TEST(UpdateRate, TheRangeIsClamped)
{
  const auto clamped = [](int least, int most) {
    vtkNew<vtkWideFoVPass> pass;
    pass->SetRelaxationRange(least, most);
    return std::vector<int>(pass->GetRelaxationRange(), pass->GetRelaxationRange() + 2);
  };
  EXPECT_EQ(clamped(1, 3), (std::vector<int>{ 1, 3 }));
  EXPECT_EQ(clamped(-7, 99), (std::vector<int>{ 0, 4 }));
  EXPECT_EQ(clamped(99, -7), (std::vector<int>{ 4, 4 }));
  EXPECT_EQ(clamped(3, 1), (std::vector<int>{ 3, 3 }));
  vtkNew<vtkWideFoVPass> pass;
  const vtkMTimeType before = pass->GetMTime();
  pass->SetRelaxationRange(-1, 5);
  EXPECT_EQ(pass->GetMTime(), before); // as it was
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
  for (int i = 0; i < 6; i++)
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

namespace
{
// In this step of relaxation, whatever it takes.
void Relax(WideFoVTestWindow& test, int relaxation)
{
  test.Pass()->KeepUpdateRateOn();
  test.Pass()->SetRelaxationRange(relaxation, relaxation);
  test.Window->SetDesiredUpdateRate(Hasty);
}

// A pixel of a picture as large as `to` of a smaller one, between its pixels blended.
double Enlarged(const TestPixels& from, const int to[2], int x, int y, int channel)
{
  double sum = 0;
  const int size[2] = { from.Width, from.Height };
  const int at[2] = { x, y };
  int low[2];
  double share[2];
  for (int i = 0; i < 2; i++)
  {
    const double place = (at[i] + 0.5) * size[i] / to[i] - 0.5;
    low[i] = static_cast<int>(std::floor(place));
    share[i] = place - low[i];
  }
  for (int k = 0; k < 4; k++)
  {
    const int i = std::clamp(low[0] + (k & 1), 0, size[0] - 1);
    const int j = std::clamp(low[1] + (k >> 1), 0, size[1] - 1);
    const double weight = (k & 1 ? share[0] : 1 - share[0]) * (k >> 1 ? share[1] : 1 - share[1]);
    sum += weight * from.At(i, j)[channel];
  }
  return sum;
}

// The largest difference of a channel, in steps of 255, in the part of the picture from that column
// on, to a picture that is enlarged to fill it.
double FarFromEnlarged(const TestPixels& picture, int column, const TestPixels& small)
{
  const int size[2] = { picture.Width - column, picture.Height };
  double worst = 0;
  for (int y = 0; y < size[1]; y++)
  {
    for (int x = 0; x < size[0]; x++)
    {
      for (int c = 0; c < 3; c++)
      {
        const double wanted = Enlarged(small, size, x, y, c);
        worst = std::max(worst, std::abs(wanted - picture.At(column + x, y)[c]));
      }
    }
  }
  return worst;
}

constexpr double Rounding = 2.01; // of both pictures, of an anaglyph, of a texture's weights

// A scene in a window of 240x120, relaxed, and in one that is so many times smaller.
void CheckEnlarged(
  const char* projection, const std::function<void(WideFoVTestWindow&)>& make, int relaxation)
{
  constexpr int factors[] = { 1, 1, 2, 3, 4 };
  WideFoVTestWindow test(projection, 240, 120);
  make(test);
  Relax(test, relaxation);
  test.Window->Render();
  test.Window->Render();
  ASSERT_EQ(test.Pass()->GetRelaxation(), relaxation);
  WideFoVTestWindow small(projection, 240 / factors[relaxation], 120 / factors[relaxation]);
  make(small);
  small.Pass()->SetTolerance(test.Pass()->GetTolerance() / factors[relaxation]);
  small.Window->Render();
  EXPECT_LT(FarFromEnlarged(TestPixels(test.Window), 0, TestPixels(small.Window)), Rounding)
    << projection << ", " << relaxation;
}
}

TEST(UpdateRate, ASmallFrameIsOneOfThatSizeEnlarged)
{
  for (const char* const projection : { "equirectangular", "azimuthal-equidistant" })
  {
    for (int i = vtkWideFoVPass::HALF_SIZE; i <= vtkWideFoVPass::QUARTER_SIZE; i++)
    {
      CheckEnlarged(projection, AddScene, i);
    }
  }
}

TEST(UpdateRate, WhatShinesThroughIsEnlarged)
{
  const auto make = [](WideFoVTestWindow& test) {
    AddScene(test);
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(0.5, 0, -1.5);
    const auto actor = MakeTestActor(ball, 0.2, 0.3, 0.9);
    actor->GetProperty()->SetOpacity(0.5);
    test.Renderer->AddActor(actor);
    test.Renderer->UseDepthPeelingOn();
    test.Renderer->GradientBackgroundOn();
    test.Renderer->SetBackground2(0.5, 0.1, 0.1);
  };
  CheckEnlarged("hammer", make, vtkWideFoVPass::HALF_SIZE);
}

TEST(UpdateRate, BothEyesAreEnlarged)
{
  const auto make = [](WideFoVTestWindow& test) {
    AddScene(test);
    test.Camera->SetStereoModelToOmnidirectional();
    test.Camera->SetInterpupillaryDistance(0.2);
    test.Window->SetStereoTypeToAnaglyph();
    test.Window->SetAnaglyphColorSaturation(0); // each channel of one eye
    test.Window->StereoRenderOn();
  };
  CheckEnlarged("equirectangular", make, vtkWideFoVPass::THIRD_SIZE);
}

TEST(UpdateRate, APartOfAWindowIsEnlargedThere)
{
  WideFoVTestWindow test("equirectangular", 256, 64);
  AddScene(test);
  test.Renderer->SetViewport(0.5, 0, 1, 1);
  vtkNew<vtkRenderer> left;
  left->SetViewport(0, 0, 0.5, 1);
  left->SetBackground(0.2, 0.7, 0.4);
  test.Window->AddRenderer(left);
  Relax(test, vtkWideFoVPass::HALF_SIZE);
  test.Window->Render();
  const TestPixels picture(test.Window);
  WideFoVTestWindow small("equirectangular", 64, 32);
  AddScene(small);
  small.Window->Render();
  EXPECT_LT(FarFromEnlarged(picture, 128, TestPixels(small.Window)), Rounding);
  for (const int x : { 0, 64, 127 })
  {
    EXPECT_NEAR(picture.At(x, 30)[1], 0.7 * 255, 1) << x;
  }
}

TEST(UpdateRate, DepthIsEnlarged)
{
  WideFoVTestWindow test("equirectangular", 240, 120);
  AddScene(test);
  Relax(test, vtkWideFoVPass::THIRD_SIZE);
  test.Window->Render();
  WideFoVTestWindow small("equirectangular", 80, 40);
  AddScene(small);
  small.Window->Render();
  vtkNew<vtkFloatArray> depths;
  vtkNew<vtkFloatArray> wanted;
  test.Window->GetZbufferData(0, 0, 239, 119, depths);
  small.Window->GetZbufferData(0, 0, 79, 39, wanted);
  double worst = 0;
  int seen = 0;
  for (int i = 0; i < 240 * 120; i++)
  {
    const float near = wanted->GetValue(i / 240 / 3 * 80 + i % 240 / 3);
    worst = std::max<double>(worst, std::abs(depths->GetValue(i) - near));
    seen += near < 1;
  }
  EXPECT_GT(seen, 1000);
  EXPECT_LT(worst, 2e-7); // two steps of 24 bits
}

TEST(UpdateRate, WhatLiesUponThePictureIsSharp)
{
  WideFoVTestWindow test("equirectangular", 240, 120);
  vtkNew<vtkTextActor> text;
  text->SetInput("sharp");
  text->SetPosition(20, 30);
  text->GetTextProperty()->SetFontSize(40);
  test.Renderer->AddViewProp(text);
  test.Window->Render();
  const TestPixels still(test.Window);
  Relax(test, vtkWideFoVPass::QUARTER_SIZE);
  test.Window->Render();
  EXPECT_EQ(test.Pass()->GetRelaxation(), vtkWideFoVPass::QUARTER_SIZE);
  EXPECT_EQ(test.Pass()->GetNumberOfDrawnProps(), 1);
  EXPECT_TRUE(Same(TestPixels(test.Window), still));
}

namespace
{
void AddFineBalls(WideFoVTestWindow& test)
{
  for (const double x : { -1.5, 0.0, 1.5 })
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(x, 0.2, x == 0 ? 1.5 : -1); // one is on the seam
    ball->SetThetaResolution(60);
    ball->SetPhiResolution(60);
    vtkNew<vtkWideFoVPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    test.Renderer->AddActor(actor);
  }
  test.Renderer->AddActor(MakeTestRoom());
}

// How often a fragment program runs in a frame; 0 where OpenGL does not count them.
long CountFragments(vtkRenderWindow* window)
{
  if (!WIDEFOV_HAS_GL(ARB_pipeline_statistics_query))
  {
    window->Render();
    return 0;
  }
  GLuint query = 0;
  GLuint64 runs = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB, query);
  window->Render();
  glEndQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &runs);
  glDeleteQueries(1, &query);
  return static_cast<long>(runs);
}
}

TEST(UpdateRate, NothingIsDrawnByADearerTechnique)
{
  for (const int technique : { vtkWideFoVPass::AUTO, vtkWideFoVPass::EXACT })
  {
    WideFoVTestWindow test("equirectangular", 512, 256);
    test.Window->SetMultiSamples(4);
    AddScene(test);
    AddFineBalls(test);
    vtkWideFoVPass* const pass = test.Pass();
    pass->SetTechnique(technique);
    test.Window->Render();
    test.Window->Render();
    const int programs = pass->GetNumberOfMadePrograms();
    const int covering = pass->GetNumberOfExactDraws() + pass->GetNumberOfPreClipDraws();
    long fragments = CountFragments(test.Window);
    ASSERT_GT(pass->GetNumberOfTriangles(), 10000);
    for (int i = vtkWideFoVPass::ONE_SAMPLE; i <= vtkWideFoVPass::QUARTER_SIZE; i++)
    {
      Relax(test, i);
      test.Camera->Yaw(0.1);
      const long runs = CountFragments(test.Window);
      ASSERT_EQ(pass->GetRelaxation(), i);
      EXPECT_EQ(pass->GetNumberOfMadePrograms(), programs) << technique << ", " << i;
      EXPECT_LE(pass->GetNumberOfExactDraws() + pass->GetNumberOfPreClipDraws(), covering);
      // all that is enlarged is drawn once more
      EXPECT_LE(runs, fragments + (i > 1 ? 0 : 512 * 256)) << technique << ", " << i;
      fragments = runs;
    }
  }
}

TEST(UpdateRate, ASelectionIsOfAllPixels)
{
  WideFoVTestWindow test("equirectangular", 240, 120);
  AddScene(test);
  test.Window->Render();
  Relax(test, vtkWideFoVPass::QUARTER_SIZE);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(test.Renderer);
  selector->SetArea(0, 0, 239, 119);
  ASSERT_TRUE(selector->CaptureBuffers());
  EXPECT_EQ(test.Pass()->GetRelaxation(), 0);
}

TEST(UpdateRate, ALayerOverOthersIsNotEnlarged)
{
  WideFoVTestWindow test("equirectangular", 64, 32);
  vtkNew<vtkRenderer> below;
  below->SetBackground(0.2, 0.7, 0.4);
  test.Window->SetNumberOfLayers(2);
  test.Window->AddRenderer(below);
  test.Renderer->SetLayer(1);
  Relax(test, vtkWideFoVPass::QUARTER_SIZE);
  test.Window->Render();
  EXPECT_EQ(test.Pass()->GetRelaxation(), 0);
  EXPECT_NEAR(TestPixels(test.Window).At(30, 15)[1], 0.7 * 255, 1);
}
