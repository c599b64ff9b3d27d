// SPDX-License-Identifier: BSD-3-Clause
// Setters clamp and warn as VTK's do, and refuse what cannot be.
#include "Overheard.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTestErrorObserver.h"
#include "vtkTransform.h"
#include "vtkWideFoVCamera.h"
#include "Compat/Reports.h"
#include "vtkWideFoVScreenCamera.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{
struct Camera
{
  Camera()
  {
    this->Object->AddObserver(vtkCommand::ErrorEvent, this->Messages);
    this->Object->AddObserver(vtkCommand::WarningEvent, this->Messages);
  }
  vtkNew<vtkWideFoVCamera> Object;
  vtkNew<vtkTest::ErrorObserver> Messages;
};
}

TEST(Camera, StartsAsFullEquirectangular)
{
  Camera c;
  EXPECT_STREQ(c.Object->GetProjection(), "equirectangular");
  EXPECT_EQ(c.Object->GetHorizontalFieldOfView(), 360);
  EXPECT_EQ(c.Object->GetVerticalFieldOfView(), 180);
  EXPECT_TRUE(c.Object->IsWide());
}

TEST(Camera, RefusesAnUnknownProjection)
{
  Camera c;
  c.Object->SetProjection("mercator-of-oz");
  EXPECT_TRUE(c.Messages->GetError());
  EXPECT_NE(c.Messages->GetErrorMessage().find("hammer"), std::string::npos);
  EXPECT_STREQ(c.Object->GetProjection(), "equirectangular");
  Camera d;
  d.Object->SetProjection(nullptr);
  EXPECT_TRUE(d.Messages->GetError());
}

TEST(Camera, ClampsFieldsOfView)
{
  Camera c;
  c.Object->SetHorizontalFieldOfView(400);
  EXPECT_TRUE(c.Messages->GetWarning());
  EXPECT_EQ(c.Object->GetHorizontalFieldOfView(), 360);
  c.Object->SetHorizontalFieldOfView(-3);
  EXPECT_GT(c.Object->GetHorizontalFieldOfView(), 0);
  c.Object->SetHorizontalFieldOfView(std::nan(""));
  EXPECT_TRUE(std::isfinite(c.Object->GetHorizontalFieldOfView()));
  c.Object->SetVerticalFieldOfView(181);
  EXPECT_EQ(c.Object->GetVerticalFieldOfView(), 180);
}

TEST(Camera, ClampsToTheRangeOfANewProjection)
{
  Camera c;
  c.Object->SetProjectionToPerspective();
  EXPECT_LT(c.Object->GetHorizontalFieldOfView(), 180);
  EXPECT_LT(c.Object->GetVerticalFieldOfView(), 180);
  EXPECT_FALSE(c.Object->IsWide());
}

TEST(Camera, ExactPerspectiveIsWideWhereItCanBe)
{
  Camera c;
  c.Object->SetProjectionToPerspective();
  c.Object->SetHorizontalFieldOfView(120);
  c.Object->SetVerticalFieldOfView(90);
  EXPECT_FALSE(c.Object->IsWide());
  c.Object->SetExactPerspective(1);
  EXPECT_TRUE(c.Object->IsWide());
  EXPECT_STREQ(c.Object->GetProjection(), "perspective");
  vtkNew<vtkWideFoVCamera> copy;
  copy->DeepCopy(c.Object);
  EXPECT_TRUE(copy->IsWide());
  c.Object->SetHorizontalFieldOfView(165);
  EXPECT_FALSE(c.Object->IsWide());
  c.Object->SetHorizontalFieldOfView(120);
  c.Object->SetStereoModelToOffAxis();
  EXPECT_FALSE(c.Object->IsWide());
  c.Object->SetStereoModelToMono();
  EXPECT_TRUE(c.Object->IsWide());
  vtkNew<vtkWideFoVScreenCamera> screen; // its head is straight before it
  screen->SetExactPerspective(1);
  EXPECT_FALSE(screen->IsWide());
  c.Object->SetExactPerspective(0);
  EXPECT_FALSE(c.Object->IsWide());
}

TEST(Camera, RefusesALensThatIsNotMonotone)
{
  Camera c;
  c.Object->SetProjectionToAzimuthalEquidistant();
  c.Object->SetFieldOfView(180);
  EXPECT_TRUE(c.Object->SetLens(0.7, 0, -0.02, 0, 0));
  EXPECT_FALSE(c.Object->SetLens(0.7, -0.6, 0, 0, 0));
  EXPECT_TRUE(c.Messages->GetError());
  double lens[5];
  c.Object->GetLens(lens);
  EXPECT_EQ(lens[0], 0.7);
  EXPECT_EQ(lens[1], 0);
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(c.Object->SetLens(inf, 0, 0, 0, 0));
  EXPECT_FALSE(c.Object->SetLens(std::nan(""), 0, 0, 0, 0));
}

TEST(Camera, RemovesALensThatAWiderFieldOfViewBreaks)
{
  Camera c;
  c.Object->SetProjectionToAzimuthalEquidistant();
  c.Object->SetFieldOfView(90);
  ASSERT_TRUE(c.Object->SetLens(1, -0.5, 0, 0, 0)); // slope 1 - t: grows to one radian
  c.Object->SetFieldOfView(180);
  EXPECT_TRUE(c.Messages->GetWarning());
  double lens[5];
  c.Object->GetLens(lens);
  EXPECT_EQ(lens[0], 0);
}

TEST(Camera, RefusesClipSpheresOutOfOrder)
{
  Camera c;
  const double before[2] = { c.Object->GetNearClipRadius(), c.Object->GetFarClipRadius() };
  const double inf = std::numeric_limits<double>::infinity();
  const double bad[][2] = { { 2, 1 }, { 1, 1 }, { 0, 1 }, { -1, 1 }, { 1, inf },
    { std::nan(""), 1 }, { 1, std::nan("") } };
  for (const auto& r : bad)
  {
    c.Messages->Clear();
    c.Object->SetClipRadii(r[0], r[1]);
    EXPECT_TRUE(c.Messages->GetError()) << r[0] << " " << r[1];
    EXPECT_EQ(c.Object->GetNearClipRadius(), before[0]);
    EXPECT_EQ(c.Object->GetFarClipRadius(), before[1]);
  }
  c.Object->SetClipRadii(1, 2);
  EXPECT_FALSE(c.Object->GetAutomaticClipRadii());
}

TEST(Camera, ClipSpheresLeaveOutWhatIsBehind)
{
  Camera c;
  c.Object->SetPosition(0, 0, 0);
  c.Object->SetFocalPoint(1, 0, 0);
  const double bounds[6] = { -50, 4, -2, 2, -2, 2 };
  const double all = std::sqrt(2500.0 + 4 + 4);
  const double ahead = std::sqrt(16.0 + 4 + 4);
  const double room = 2e-3; // relative, that the camera leaves, and more
  c.Object->SetProjectionToEquirectangular();
  c.Object->ResetClipRadii(bounds);
  EXPECT_NEAR(c.Object->GetFarClipRadius(), all, room * all);
  c.Object->SetProjectionToAzimuthalEquidistant();
  c.Object->SetFieldOfView(90);
  c.Object->ResetClipRadii(bounds);
  EXPECT_NEAR(c.Object->GetFarClipRadius(), ahead, room * ahead);
  c.Object->SetProjectionToPerspective();
  c.Object->SetExactPerspective(1);
  c.Object->SetFieldOfView(120);
  c.Object->ResetClipRadii(bounds);
  EXPECT_NEAR(c.Object->GetFarClipRadius(), ahead, room * ahead);
  // nothing of them is seen: they count as they are
  c.Object->SetFocalPoint(0, 1, 0);
  const double aside[6] = { -4, -2, -1, 0, -1, 1 };
  c.Object->ResetClipRadii(aside);
  EXPECT_NEAR(c.Object->GetFarClipRadius(), std::sqrt(18.0), room * std::sqrt(18.0));
}

TEST(Camera, TiltRaisesTheAxis)
{
  Camera c;
  c.Object->SetProjectionToAzimuthalEquidistant();
  c.Object->SetFieldOfView(180);
  c.Object->SetPosition(0, 0, 0);
  c.Object->SetFocalPoint(0, 0, -1);
  c.Object->SetClipRadii(0.1, 10);
  c.Object->SetTilt(90);
  const double zenith[3] = { 0, 1, 0 };
  const double ahead[3] = { 0, 0, -1 };
  double ndc[3];
  EXPECT_TRUE(c.Object->WorldToNDC(zenith, 1, ndc));
  EXPECT_NEAR(ndc[0], 0, 1e-12);
  EXPECT_NEAR(ndc[1], 0, 1e-12);
  c.Object->WorldToNDC(ahead, 1, ndc);
  EXPECT_NEAR(ndc[1], -1, 1e-12); // the front of a dome is at the bottom of its picture
}

TEST(Camera, PrintsWithoutFailing)
{
  Camera c;
  std::ostringstream text;
  c.Object->Print(text);
  EXPECT_NE(text.str().find("Projection: equirectangular"), std::string::npos);
}

TEST(Camera, ViewAngleAndZoomChangeBothFields)
{
  Camera c;
  c.Object->SetViewAngle(90);
  EXPECT_EQ(c.Object->GetVerticalFieldOfView(), 90);
  EXPECT_EQ(c.Object->GetHorizontalFieldOfView(), 180);
  c.Object->Zoom(3);
  EXPECT_EQ(c.Object->GetVerticalFieldOfView(), 30);
  EXPECT_EQ(c.Object->GetHorizontalFieldOfView(), 60);
  c.Object->Zoom(0);
  EXPECT_EQ(c.Object->GetVerticalFieldOfView(), 30);
  c.Object->UseHorizontalViewAngleOn();
  c.Object->SetViewAngle(120);
  EXPECT_EQ(c.Object->GetHorizontalFieldOfView(), 120);
  EXPECT_EQ(c.Object->GetVerticalFieldOfView(), 60);
  c.Object->SetProjectionToAzimuthalEquidistant();
  c.Object->SetFieldOfView(180);
  c.Object->UseHorizontalViewAngleOff();
  c.Object->Zoom(2);
  EXPECT_EQ(c.Object->GetHorizontalFieldOfView(), 90);
  EXPECT_FALSE(c.Messages->GetWarning());
  c.Object->SetViewAngle(1000);
  EXPECT_TRUE(c.Messages->GetWarning());
  EXPECT_EQ(c.Object->GetHorizontalFieldOfView(), 360);
}

// Both fields at their limits are one mistake.
TEST(Camera, ZoomAtItsLimitsWarnsOnce)
{
  for (const char* projection : { "equirectangular", "azimuthal-equidistant", "perspective" })
  {
    for (const double factor : { 0.001, 1e9 })
    {
      vtkNew<vtkWideFoVCamera> camera;
      camera->SetProjection(projection);
      const Overheard said;
      camera->Zoom(factor);
      EXPECT_EQ(said.Count("is outside"), 1)
        << projection << " " << factor << ": " << said.Window->GetOutput();
    }
  }
  vtkNew<vtkWideFoVCamera> high; // of which the vertical field alone is at its limit
  high->SetHorizontalFieldOfView(90);
  const Overheard said;
  high->Zoom(0.5);
  EXPECT_EQ(said.Count("Vertical field of view 360 is outside"), 1) << said.Window->GetOutput();
  EXPECT_EQ(high->GetHorizontalFieldOfView(), 180);
}

// What places a camera by vtkCamera's angle places a wide one where it places an ordinary one.
TEST(Camera, IsResetAsAnOrdinaryOne)
{
  const double bounds[6] = { -1, 2, -3, 4, -5, 6 };
  vtkNew<vtkRenderer> ordinary;
  ordinary->ResetCamera(bounds);
  for (const char* projection : { "equirectangular", "azimuthal-equidistant", "perspective" })
  {
    Camera c;
    c.Object->SetProjection(projection);
    vtkNew<vtkRenderer> renderer;
    renderer->SetActiveCamera(c.Object);
    renderer->ResetCamera(bounds);
    EXPECT_EQ(c.Object->GetDistance(), ordinary->GetActiveCamera()->GetDistance()) << projection;
    vtkCamera* const stock = c.Object;
    EXPECT_EQ(stock->GetViewAngle(), 30) << projection;
  }
}

TEST(Camera, ZoomOfAPerspectiveKeepsTheSidesOfThePicture)
{
  Camera c;
  c.Object->SetProjectionToPerspective();
  c.Object->SetHorizontalFieldOfView(120);
  c.Object->SetVerticalFieldOfView(90);
  const double degree = std::acos(-1.0) / 180;
  const auto sides = [&] {
    return std::tan(0.5 * degree * c.Object->GetHorizontalFieldOfView()) /
      std::tan(0.5 * degree * c.Object->GetVerticalFieldOfView());
  };
  const double before = sides();
  c.Object->Zoom(2);
  EXPECT_NEAR(c.Object->GetVerticalFieldOfView(), 45, 1e-12);
  EXPECT_NEAR(sides(), before, 1e-12);
}

TEST(Camera, EyeSeparationIsTheInterpupillaryDistance)
{
  Camera c;
  vtkCamera* const stock = c.Object;
  stock->SetEyeSeparation(0.2);
  EXPECT_EQ(c.Object->GetInterpupillaryDistance(), 0.2);
  EXPECT_EQ(stock->GetEyeSeparation(), 0.2);
}

// VTK's screenshots change the angle by a rounding and, of several tiles, by much more; none of
// that is a user's.
TEST(Camera, IsNotWarnedOfScreenshots)
{
  for (const int scale : { 1, 2 })
  {
    Camera c;
    vtkNew<vtkRenderer> renderer;
    renderer->SetActiveCamera(c.Object);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetSize(64, 32);
    window->AddRenderer(renderer);
    const Overheard said;
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(window);
    grab->SetScale(scale);
    grab->ReadFrontBufferOff();
    grab->Update();
    EXPECT_EQ(std::string(said.Window->GetOutput()).find("is ignored"), std::string::npos)
      << scale << ": " << said.Window->GetOutput();
  }
}

// What vtkCamera has and no wide view: one warning each, with its name, and the same view.
TEST(Camera, SaysWhatItIgnores)
{
  struct Call
  {
    const char* Name;
    void (*Make)(vtkCamera*);
  };
  const Call calls[] = {
    { "ViewAngle", [](vtkCamera* c) { c->Zoom(2); } },
    { "ParallelProjection", [](vtkCamera* c) { c->ParallelProjectionOn(); } },
    { "UserTransform",
      [](vtkCamera* c) {
        vtkNew<vtkTransform> t;
        c->SetUserTransform(t);
      } },
    { "WindowCenter", [](vtkCamera* c) { c->SetWindowCenter(0.5, 0); } },
    { "ViewShear", [](vtkCamera* c) { c->SetObliqueAngles(30, 45); } },
    { "UseOffAxisProjection", [](vtkCamera* c) { c->UseOffAxisProjectionOn(); } },
    { "ExplicitProjectionTransformMatrix",
      [](vtkCamera* c) { c->SetUseExplicitProjectionTransformMatrix(true); } },
    { "EyeAngle", [](vtkCamera* c) { c->SetEyeAngle(5); } },
  };
  wfv::ForgetReports();
  for (const Call& call : calls)
  {
    Camera c;
    vtkNew<vtkRenderer> renderer;
    renderer->SetActiveCamera(c.Object);
    c.Object->PrepareFrame(renderer);
    ASSERT_FALSE(c.Messages->GetWarning()) << call.Name << ": " << c.Messages->GetWarningMessage();
    call.Make(c.Object);
    c.Object->PrepareFrame(renderer);
    EXPECT_NE(c.Messages->GetWarningMessage().find(call.Name), std::string::npos) << call.Name;
    EXPECT_EQ(c.Object->GetHorizontalFieldOfView(), 360);
    c.Messages->Clear();
    c.Object->PrepareFrame(renderer);
    EXPECT_FALSE(c.Messages->GetWarning()) << call.Name;
  }
}
