// SPDX-License-Identifier: BSD-3-Clause
// World and display coordinates go through the view: what VTK's own tools say of a
// point is where the picture shows it.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCoordinate.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkWideFoVCellPicker.h"
#include "vtkWorldPointPicker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
const char* const Wide[] = { "equirectangular", "hammer", "azimuthal-equidistant" };

// A point at this distance in the direction of longitude and latitude, world.
void Place(double lambda, double phi, double distance, double p[3])
{
  const double l = vtkMath::RadiansFromDegrees(lambda);
  const double b = vtkMath::RadiansFromDegrees(phi);
  p[0] = 0.1 + distance * std::cos(b) * std::sin(l);
  p[1] = 0.05 + distance * std::sin(b);
  p[2] = 0.07 - distance * std::cos(b) * std::cos(l);
}

// Centre of the bright pixels.
bool Centroid(vtkRenderWindow* window, double& x, double& y)
{
  const TestPixels pixels(window);
  double n = 0;
  x = y = 0;
  for (int j = 0; j < pixels.Height; j++)
  {
    for (int i = 0; i < pixels.Width; i++)
    {
      if (pixels.At(i, j)[0] > 150)
      {
        x += i + 0.5;
        y += j + 0.5;
        n++;
      }
    }
  }
  x /= n;
  y /= n;
  return n > 0;
}
}

namespace
{
// World to display and back, by vtkCoordinate and by the renderer.
void ExpectInverse(WideFoVTestWindow& test, const double p[3], const std::string& what)
{
  vtkNew<vtkCoordinate> place;
  place->SetCoordinateSystemToWorld();
  place->SetValue(p[0], p[1], p[2]);
  const double* d = place->GetComputedDoubleDisplayValue(test.Renderer);
  const double display[2] = { d[0], d[1] };
  test.Renderer->SetWorldPoint(p[0], p[1], p[2], 1);
  test.Renderer->WorldToDisplay();
  double full[3];
  test.Renderer->GetDisplayPoint(full);
  EXPECT_NEAR(full[0], display[0], 1e-9) << what;
  test.Renderer->SetDisplayPoint(full);
  test.Renderer->DisplayToWorld();
  const double* w = test.Renderer->GetWorldPoint();
  for (int i = 0; i < 3; i++)
  {
    EXPECT_NEAR(w[i], p[i], 1e-9) << what;
  }
}

const int Mappings[] = { vtkWideFoVCamera::LINEAR, vtkWideFoVCamera::LOGARITHMIC,
  vtkWideFoVCamera::REVERSED };
}

TEST(Coordinates, DisplayAndWorldAreInverse)
{
  for (const char* projection : Wide)
  {
    WideFoVTestWindow test(projection, 400, 300);
    test.Camera->SetFieldOfView(300);
    test.Camera->SetClipRadii(0.1, 10);
    for (int mapping : Mappings)
    {
      test.Camera->SetDepthMapping(mapping);
      for (double lambda = -140; lambda < 141; lambda += 35)
      {
        double p[3];
        Place(lambda, lambda / 4, 3, p);
        ExpectInverse(test, p,
          std::string(projection) + " " + std::to_string(lambda) + " mapping " +
            std::to_string(mapping));
      }
    }
  }
}

TEST(Coordinates, APointLandsWhereThePictureShowsIt)
{
  const double places[][2] = { { 0, 0 }, { 100, 20 }, { -150, -30 }, { 170, 10 }, { 30, 70 } };
  for (const char* projection : Wide)
  {
    for (const auto& at : places)
    {
      WideFoVTestWindow test(projection, 600, 300);
      test.Renderer->SetBackground(0, 0, 0);
      double p[3];
      Place(at[0], at[1], 3, p);
      vtkNew<vtkSphereSource> ball;
      ball->SetCenter(p);
      ball->SetRadius(0.05);
      auto actor = MakeTestActor(ball, 1, 1, 1);
      actor->GetProperty()->LightingOff();
      test.Renderer->AddActor(actor);
      test.Camera->SetClipRadii(0.1, 10);
      test.Window->Render();
      double x;
      double y;
      ASSERT_TRUE(Centroid(test.Window, x, y)) << projection << " " << at[0] << " " << at[1];
      double q[3] = { p[0], p[1], p[2] };
      test.Renderer->SetWorldPoint(q[0], q[1], q[2], 1);
      test.Renderer->WorldToDisplay();
      // the ball is a few pixels wide and stretched: half a pixel for its centroid
      EXPECT_NEAR(test.Renderer->GetDisplayPoint()[0], x, 0.5) << projection << " " << at[0];
      EXPECT_NEAR(test.Renderer->GetDisplayPoint()[1], y, 0.5) << projection << " " << at[0];
    }
  }
}

TEST(Coordinates, AWorldPointPickerFindsTheSurface)
{
  for (const char* projection : Wide)
  {
    WideFoVTestWindow test(projection, 400, 300);
    test.Renderer->AddActor(MakeTestRoom());
    vtkNew<vtkWorldPointPicker> picker;
    for (int k = 0; k < 9; k++)
    {
      const int at[3][2] = { { 200, 150 }, { 120, 140 }, { 260, 110 } };
      const auto& xy = at[k % 3];
      test.Camera->SetDepthMapping(Mappings[k / 3]);
      test.Window->Render();
      picker->Pick(xy[0], xy[1], 0, test.Renderer);
      const double* p = picker->GetPickPosition();
      // on one of the walls x = +-2, y = +-1.5, z = +-2.5
      const double off = std::min({ std::abs(std::abs(p[0]) - 2), std::abs(std::abs(p[1]) - 1.5),
        std::abs(std::abs(p[2]) - 2.5) });
      EXPECT_LT(off, 0.03) // half a pixel, three units away
        << projection << " " << xy[0] << "," << xy[1] << " mapping " << Mappings[k / 3];
    }
  }
}

TEST(Coordinates, ACellPickerPicksBehindTheEye)
{
  WideFoVTestWindow test("equirectangular", 400, 200);
  double p[3];
  Place(170, -10, 2, p);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(p);
  ball->SetRadius(0.3);
  auto actor = MakeTestActor(ball, 1, 1, 1);
  test.Renderer->AddActor(actor);
  test.Window->Render();
  test.Renderer->SetWorldPoint(p[0], p[1], p[2], 1);
  test.Renderer->WorldToDisplay();
  double display[3];
  test.Renderer->GetDisplayPoint(display);
  vtkNew<vtkWideFoVCellPicker> picker;
  EXPECT_TRUE(picker->Pick(display[0], display[1], 0, test.Renderer));
  EXPECT_EQ(picker->GetActor(), actor.Get());
  double hit[3];
  picker->GetPickPosition(hit);
  const double d = std::sqrt(vtkMath::Distance2BetweenPoints(hit, p));
  EXPECT_NEAR(d, 0.3, 0.02);                              // on the coarse sphere
  EXPECT_FALSE(picker->Pick(200, 100, 0, test.Renderer)); // nothing straight ahead
}
