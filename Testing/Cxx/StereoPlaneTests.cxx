// SPDX-License-Identifier: BSD-3-Clause
// Two eyes and what is not in the scene: the frame of the picture, labels, selection, and where
// nothing has parallax.
#include "WideFoVTestScene.h"

#include "vtkCoordinate.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkWideFoVDataPass.h"
#include "vtkWideFoVHardwareSelector.h"
#include "vtkWideFoVStereoWindow.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr int Width = 200;
constexpr int Height = 100;

// Relative: what a depth buffer tells apart where the far plane is 10,000 times the near one.
constexpr double ConvergenceTolerance = 1e-3;

// NDC depth: a sphere of flat pieces, two degrees each.
constexpr double OffsetTolerance = 2e-3;

// Pixels: letters are put on whole ones.
constexpr double LabelTolerance = 1.01;

// Pixels and scene units: VTK's conversions there and back, in double.
constexpr double ConversionTolerance = 1e-6;

TestPixels Draw(WideFoVTestWindow& test, int type)
{
  test.Window->SetStereoType(type);
  test.Window->StereoRenderOn();
  test.Window->Render();
  return TestPixels(test.Window);
}

bool IsBlack(const TestPixels& pixels, int x, int y)
{
  const unsigned char* const p = pixels.At(x, y);
  return p[0] + p[1] + p[2] == 0;
}

// At the origin, looking along -z.
void Look(WideFoVTestWindow& test)
{
  test.Camera->SetPosition(0, 0, 0);
  test.Camera->SetFocalPoint(0, 0, -1);
  test.Renderer->SetBackground(0, 0, 0);
}

// A letter whose place is one of the world.
vtkSmartPointer<vtkTextActor> AddLabel(WideFoVTestWindow& test)
{
  auto label = vtkSmartPointer<vtkTextActor>::New();
  label->SetInput("O");
  label->GetTextProperty()->SetFontSize(16);
  label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  test.Renderer->AddViewProp(label);
  return label;
}

// Mean column of what is lit.
double MiddleOf(const TestPixels& pixels)
{
  double sum = 0;
  double weight = 0;
  for (int y = 0; y < Height; y++)
  {
    for (int x = 0; x < Width; x++)
    {
      const double lit = pixels.At(x, y)[0];
      sum += lit * (x + 0.5);
      weight += lit;
    }
  }
  return weight > 0 ? sum / weight : -1;
}
}

TEST(StereoWindow, BarsAreBesideTheRightSideOfEachEye)
{
  WideFoVTestWindow test("equirectangular", Width, Height);
  test.Window->SetMultiSamples(0);
  test.Renderer->SetBackground(1, 1, 1);
  test.Camera->SetStereoModel("warped");
  vtkNew<vtkWideFoVStereoWindow> window;
  window->SetFloating(0.1);
  window->SetLetterbox(0.2);
  test.Renderer->AddViewProp(window);
  for (const int type : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
  {
    const TestPixels pixels = Draw(test, type);
    const bool left = type == VTK_STEREO_LEFT;
    for (int x = 0; x < Width; x++)
    {
      EXPECT_EQ(IsBlack(pixels, x, 50), left ? x < 20 : x >= 180) << x;
    }
    for (int y = 0; y < Height; y++)
    {
      EXPECT_EQ(IsBlack(pixels, 100, y), y < 20 || y >= 80) << y;
    }
  }
  test.Window->StereoRenderOff();
  test.Window->Render();
  const TestPixels mono(test.Window);
  EXPECT_FALSE(IsBlack(mono, 0, 50) || IsBlack(mono, Width - 1, 50));
  EXPECT_TRUE(IsBlack(mono, 100, 0) && IsBlack(mono, 100, Height - 1));
}

TEST(StereoLabels, StandAtTheDepthOfTheirAnchor)
{
  WideFoVTestWindow test("equirectangular", Width, Height);
  test.Window->SetMultiSamples(0);
  Look(test);
  test.Camera->SetStereoModel("omnidirectional");
  test.Camera->SetInterpupillaryDistance(0.4);
  const auto label = AddLabel(test);
  const double r = 0.2;
  for (const double azimuth : { 0.0, 1.2, 2.5, -2.0 })
  {
    const double d = 1.0;
    label->GetPositionCoordinate()->SetValue(d * std::sin(azimuth), 0.1, -d * std::cos(azimuth));
    const double left = MiddleOf(Draw(test, VTK_STEREO_LEFT));
    const double right = MiddleOf(Draw(test, VTK_STEREO_RIGHT));
    const double expected = 2 * std::asin(r / d) / (2 * 3.14159265358979) * Width;
    EXPECT_GT(left, 0) << azimuth;
    EXPECT_NEAR(left - right, expected, LabelTolerance) << azimuth;
  }
}

TEST(StereoLabels, AreWhereEachOffAxisEyeSeesTheirAnchor)
{
  WideFoVTestWindow test("perspective", Width, Height);
  test.Window->SetMultiSamples(0);
  Look(test);
  test.Camera->SetStereoModel("offaxis");
  test.Camera->SetSeparation(0.1);
  test.Camera->SetConvergence(2);
  test.Camera->SetHorizontalFieldOfView(90);
  test.Camera->SetClipRadii(0.5, 20);
  const auto label = AddLabel(test);
  for (const double depth : { 1.0, 2.0, 6.0 })
  {
    const double at[3] = { 0.1 * depth, -0.1 * depth, -depth };
    label->GetPositionCoordinate()->SetValue(at[0], at[1], at[2]);
    double middle[2];
    double place[2];
    for (const int type : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
    {
      const int eye = type == VTK_STEREO_LEFT ? 0 : 1;
      middle[eye] = MiddleOf(Draw(test, type));
      test.Renderer->SetWorldPoint(at[0], at[1], at[2], 1);
      test.Renderer->WorldToDisplay();
      place[eye] = test.Renderer->GetDisplayPoint()[0];
      test.Renderer->DisplayToWorld();
      const double* const back = test.Renderer->GetWorldPoint();
      for (int i = 0; i < 3; i++)
      {
        EXPECT_NEAR(back[i] / back[3], at[i], ConversionTolerance) << depth << " " << type;
      }
    }
    const double expected = 0.1 * (1 - 2 / depth) * Width;
    EXPECT_NEAR(middle[1] - middle[0], expected, LabelTolerance) << depth;
    EXPECT_NEAR(place[1] - place[0], expected, ConversionTolerance) << depth;
  }
}

namespace
{
vtkSmartPointer<vtkSelection> Select(WideFoVTestWindow& test, unsigned int x, unsigned int y)
{
  vtkNew<vtkWideFoVHardwareSelector> selector;
  selector->SetRenderer(test.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(x, y, x, y);
  return vtkSmartPointer<vtkSelection>::Take(selector->Select());
}
}

TEST(StereoSelection, IsWhatTheLeftEyeSeesUnderThePointer)
{
  WideFoVTestWindow test("equirectangular", Width, Height);
  test.Window->SetMultiSamples(0);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1);
  sphere->SetThetaResolution(37);
  sphere->SetPhiResolution(23);
  auto globe = MakeTestActor(sphere, 1, 1, 1);
  test.Renderer->AddActor(globe);
  test.Camera->SetStereoModel("omnidirectional");
  test.Camera->SetInterpupillaryDistance(0.4);
  vtkRenderPass* const pass = test.Renderer->GetPass();
  vtkNew<vtkWideFoVDataPass> data;
  data->SetDelegatePass(pass);
  data->SetPropIndex(globe, 0);
  test.Renderer->SetPass(data);
  Draw(test, VTK_STEREO_LEFT);
  vtkDataArray* const cells = data->GetOutput()->GetPointData()->GetArray("cell");
  ASSERT_TRUE(cells);
  test.Renderer->SetPass(pass);
  for (const int type : { VTK_STEREO_ANAGLYPH, VTK_STEREO_INTERLACED, VTK_STEREO_RIGHT })
  {
    Draw(test, type);
    for (unsigned int y = 5; y < Height; y += 30)
    {
      for (unsigned int x = 1; x < Width; x += 37)
      {
        const auto selection = Select(test, x, y);
        ASSERT_TRUE(selection && selection->GetNumberOfNodes() == 1)
          << type << " " << x << " " << y;
        auto* const ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
        EXPECT_EQ(ids->GetValue(0) + 1, static_cast<vtkIdType>(cells->GetTuple1(y * Width + x)))
          << type << " " << x << " " << y;
      }
    }
    EXPECT_EQ(test.Window->GetStereoType(), type);
  }
}

TEST(Convergence, IsTheDepthOfThePicture)
{
  for (const int samples : { 0, 4 })
  {
    WideFoVTestWindow test("perspective", Width, Height);
    test.Window->SetMultiSamples(samples);
    Look(test);
    EXPECT_FALSE(test.Camera->ConvergeOnDepth(test.Renderer)); // no stereo
    test.Camera->SetStereoModel("offaxis");
    EXPECT_FALSE(test.Camera->ConvergeOnDepth(nullptr));
    test.Window->Render();
    EXPECT_FALSE(test.Camera->ConvergeOnDepth(test.Renderer)); // nothing is seen
    EXPECT_EQ(test.Camera->GetConvergence(), 10);
    // a wall across the view, seen from its middle
    vtkNew<vtkPlaneSource> wall;
    wall->SetOrigin(-30, -30, -4);
    wall->SetPoint1(30, -30, -4);
    wall->SetPoint2(-30, 30, -4);
    test.Renderer->AddActor(MakeTestActor(wall, 1, 1, 1));
    test.Window->Render();
    EXPECT_TRUE(test.Camera->ConvergeOnDepth(test.Renderer));
    EXPECT_NEAR(test.Camera->GetConvergence(), 4, 4 * ConvergenceTolerance) << samples;
  }
}

TEST(Convergence, OfAWarpedVolumeIsItsMiddle)
{
  WideFoVTestWindow test("equirectangular", Width, Height);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2);
  sphere->SetThetaResolution(180);
  sphere->SetPhiResolution(90);
  test.Renderer->AddActor(MakeTestActor(sphere, 1, 1, 1));
  Look(test);
  test.Camera->SetStereoModel("warped");
  test.Camera->SetClippingRange(1, 3);
  test.Renderer->SetActiveCamera(test.Camera);
  test.Window->Render();
  ASSERT_TRUE(test.Camera->ConvergeOnDepth(test.Renderer));
  double range[2];
  test.Camera->GetClippingRange(range);
  double warped[3];
  test.Camera->GetWarpedStereo(warped);
  EXPECT_NEAR(warped[2], 2 * (2 - range[0]) / (range[1] - range[0]) - 1, OffsetTolerance);
}
