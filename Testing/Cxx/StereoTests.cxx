// SPDX-License-Identifier: BSD-3-Clause
// Two eyes through VTK's own stereo types: what each type shows is made of what each eye sees.
#include "WideFoVTestScene.h"

#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkTestErrorObserver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
// NDC, in double: the turn of the eyes and the map.
constexpr double ConvergedRounding = 1e-12;

// A room and cones, nearer to one eye than to the other.
struct Scene : WideFoVTestWindow
{
  explicit Scene(const char* model)
    : WideFoVTestWindow("equirectangular", 96, 48)
  {
    this->Window->SetMultiSamples(0);
    this->Renderer->AddActor(MakeTestRoom());
    AddTestCones(this->Renderer);
    this->Camera->SetStereoModel(model);
    this->Camera->SetInterpupillaryDistance(0.3);
  }

  TestPixels Draw(int type)
  {
    this->Window->SetStereoType(type);
    this->Window->StereoRenderOn();
    this->Window->Render();
    return TestPixels(this->Window);
  }
};

bool Same(const unsigned char* a, const unsigned char* b)
{
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

// How many pixels of two pictures are the same.
int CountSame(const TestPixels& a, const TestPixels& b)
{
  int same = 0;
  for (int y = 0; y < a.Height; y++)
  {
    for (int x = 0; x < a.Width; x++)
    {
      same += Same(a.At(x, y), b.At(x, y));
    }
  }
  return same;
}
}

TEST(Eyes, DifferInEveryModelButMono)
{
  for (const char* model : { "mono", "omnidirectional", "warped" })
  {
    Scene scene(model);
    const TestPixels left = scene.Draw(VTK_STEREO_LEFT);
    EXPECT_EQ(scene.Camera->GetCurrentEye(), -1);
    const TestPixels right = scene.Draw(VTK_STEREO_RIGHT);
    EXPECT_EQ(scene.Camera->GetCurrentEye(), 1);
    const bool mono = std::string(model) == "mono";
    EXPECT_EQ(CountSame(left, right) == 96 * 48, mono) << model;
    scene.Window->StereoRenderOff();
    scene.Window->Render();
    EXPECT_EQ(scene.Camera->GetCurrentEye(), 0);
  }
}

TEST(Eyes, StereoTypesShowWhatEachEyeSees)
{
  Scene scene("omnidirectional");
  const TestPixels left = scene.Draw(VTK_STEREO_LEFT);
  const TestPixels right = scene.Draw(VTK_STEREO_RIGHT);
  const TestPixels redBlue = scene.Draw(VTK_STEREO_RED_BLUE);
  const TestPixels interlaced = scene.Draw(VTK_STEREO_INTERLACED);
  const TestPixels checkers = scene.Draw(VTK_STEREO_CHECKERBOARD);
  const TestPixels dresden = scene.Draw(VTK_STEREO_DRESDEN);
  int rows[2] = { 0, 0 };
  int squares[2] = { 0, 0 };
  int columns[2] = { 0, 0 };
  for (int y = 0; y < 48; y++)
  {
    for (int x = 0; x < 96; x++)
    {
      const unsigned char* const l = left.At(x, y);
      const unsigned char* const r = right.At(x, y);
      // red of the left, blue of the right eye, from the mean of each colour
      EXPECT_NEAR(redBlue.At(x, y)[0], (l[0] + l[1] + l[2]) / 3, 1) << x << " " << y;
      EXPECT_NEAR(redBlue.At(x, y)[2], (r[0] + r[1] + r[2]) / 3, 1) << x << " " << y;
      rows[y % 2] += Same(interlaced.At(x, y), y % 2 ? r : l);
      squares[(x + y) % 2] += Same(checkers.At(x, y), (x + y) % 2 ? r : l);
      columns[x % 2] += Same(dresden.At(x, y), x % 2 ? r : l);
    }
  }
  // whichever of the two eyes VTK gives the even ones
  const int half = 96 * 48 / 2;
  EXPECT_TRUE(rows[0] + rows[1] == 2 * half || CountSame(interlaced, left) < 2 * half);
  for (const int* count : { rows, squares, columns })
  {
    EXPECT_TRUE(count[0] == half || count[1] == half || count[0] + count[1] < half);
  }
}

// Points at the convergence stand at one place in both pictures, in front, beside and behind, and
// in a tilted dome; nearer and farther points have the parallax of the closed form.
TEST(Eyes, ConvergeAllRound)
{
  Scene scene("omnidirectional");
  scene.Draw(VTK_STEREO_LEFT); // tells the camera that there are two eyes
  vtkWideFoVCamera* const camera = scene.Camera;
  camera->SetPosition(0, 0, 1);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetInterpupillaryDistance(0.4);
  camera->SetCircleConvergence(3);
  const double pi = vtkMath::Pi();
  const auto parallax = [&](const double point[3], int axis) {
    double ndc[2][3];
    for (int left = 0; left < 2; left++)
    {
      camera->SetLeftEye(left);
      camera->WorldToNDC(point, 2, ndc[left]);
    }
    return std::remainder(ndc[0][axis] - ndc[1][axis], 2);
  };
  for (const char* const projection : { "equirectangular", "azimuthal-equidistant" })
  {
    camera->SetProjection(projection);
    camera->SetTilt(projection[0] == 'a' ? 90 : 0);
    for (int i = 0; i < 36; i++)
    {
      const double lambda = (10 * i + 3) * pi / 180;
      const double at[3] = { 3 * std::sin(lambda), 1, 1 - 3 * std::cos(lambda) };
      EXPECT_NEAR(std::hypot(parallax(at, 0), parallax(at, 1)), 0, ConvergedRounding) << projection;
    }
  }
  camera->SetProjection("equirectangular");
  camera->SetTilt(0);
  for (const double d : { 0.5, 2., 100. })
  {
    const double at[3] = { 0, 0.3, 1 - d };
    const double expected = 2 * (std::asin(0.2 / 3) - std::asin(0.2 / d)) / pi;
    EXPECT_NEAR(parallax(at, 0), expected, ConvergedRounding) << d;
  }
}

TEST(Eyes, RefuseAConvergenceThatCannotBe)
{
  vtkNew<vtkWideFoVCamera> camera;
  vtkNew<vtkTest::ErrorObserver> messages;
  camera->AddObserver(vtkCommand::ErrorEvent, messages);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double bad : { nan, -1.0 })
  {
    camera->SetCircleConvergence(bad);
    EXPECT_TRUE(messages->GetError());
    EXPECT_EQ(camera->GetCircleConvergence(), 0);
    messages->Clear();
  }
}

TEST(Eyes, RefuseWhatCannotBe)
{
  vtkNew<vtkWideFoVCamera> camera;
  vtkNew<vtkTest::ErrorObserver> messages;
  camera->AddObserver(vtkCommand::ErrorEvent, messages);
  camera->AddObserver(vtkCommand::WarningEvent, messages);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  camera->SetStereoModel("cross-eyed");
  EXPECT_NE(messages->GetErrorMessage().find("omnidirectional"), std::string::npos);
  messages->Clear();
  camera->SetPoleFade(60, 40);
  EXPECT_TRUE(messages->GetError());
  messages->Clear();
  camera->SetConvergence(nan);
  EXPECT_TRUE(messages->GetError());
  messages->Clear();
  camera->SetWarpedStereo(0.5, 0.1, -0.8);
  EXPECT_TRUE(messages->GetError());
  messages->Clear();
  for (double bad : { nan, -1.0 })
  {
    camera->SetInterpupillaryDistance(bad);
    EXPECT_TRUE(messages->GetWarning());
    EXPECT_EQ(camera->GetInterpupillaryDistance(), 0);
    messages->Clear();
    camera->SetSeparation(bad);
    EXPECT_TRUE(messages->GetWarning());
    EXPECT_EQ(camera->GetSeparation(), 0);
    messages->Clear();
  }
  double warped[3];
  camera->GetWarpedStereo(warped);
  EXPECT_EQ(warped[1], 5); // the paper's, unchanged
  EXPECT_EQ(camera->GetConvergence(), 10);
  EXPECT_STREQ(camera->GetStereoModel(), "mono");
}

TEST(Eyes, CoordinatesAreThoseOfTheEyeDrawn)
{
  Scene scene("omnidirectional");
  const double point[3] = { 0.4, 0.1, -0.9 };
  double x[2];
  for (int eye = 0; eye < 2; eye++)
  {
    scene.Draw(eye == 0 ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
    double ndc[3];
    ASSERT_TRUE(scene.Camera->WorldToNDC(point, 2, ndc));
    x[eye] = ndc[0];
    double back[3];
    scene.Camera->NDCToWorld(ndc, 2, back);
    for (int i = 0; i < 3; i++)
    {
      EXPECT_NEAR(back[i], point[i], 1e-9);
    }
  }
  EXPECT_GT(x[0], x[1]);
}
