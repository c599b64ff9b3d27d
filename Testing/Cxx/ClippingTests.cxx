// SPDX-License-Identifier: BSD-3-Clause
// Automatic clip spheres: nothing that depth can tell from the eye is clipped, from 1e-3 to 1e9,
// and a line says what is.
#include "Overheard.h"
#include "WideFoVTestScene.h"

#include "Compat/Reports.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
const char* const Clipped = "is not drawn, and something is";

vtkSmartPointer<vtkActor> MakeBox(double half)
{
  vtkNew<vtkCubeSource> box;
  box->SetXLength(2 * half);
  box->SetYLength(2 * half);
  box->SetZLength(2 * half);
  auto actor = MakeTestActor(box, 0.5, 0.5, 0.5);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> MakeBall(double x, double y, double z, double radius)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(x, y, z);
  ball->SetRadius(radius);
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(32);
  auto actor = MakeTestActor(ball, 1, 0, 0);
  actor->GetProperty()->LightingOff();
  return actor;
}

// A square across the view at this azimuth (degrees), seen under 10 degrees.
vtkSmartPointer<vtkActor> MakeSheet(double azimuth, double distance, double r, double g, double b)
{
  const double half = distance * std::tan(5 * M_PI / 180);
  vtkNew<vtkPlaneSource> sheet;
  sheet->SetOrigin(-half, -half, -distance);
  sheet->SetPoint1(half, -half, -distance);
  sheet->SetPoint2(-half, half, -distance);
  sheet->SetResolution(4, 4);
  auto actor = MakeTestActor(sheet, r, g, b);
  actor->RotateY(-azimuth);
  actor->GetProperty()->LightingOff();
  return actor;
}

int CountRed(vtkRenderWindow* window)
{
  const TestPixels pixels(window);
  int n = 0;
  for (int y = 0; y < pixels.Height; y++)
  {
    for (int x = 0; x < pixels.Width; x++)
    {
      const unsigned char* const p = pixels.At(x, y);
      n += p[0] - p[1] > 100;
    }
  }
  return n;
}

// The eye at the origin.
struct Scene : WideFoVTestWindow
{
  explicit Scene(const char* projection)
    : WideFoVTestWindow(projection, 128, 64)
  {
    wfv::ForgetReports();
    this->Camera->SetPosition(0, 0, 0);
    this->Camera->SetFocalPoint(0, 0, -1);
    this->Window->SetMultiSamples(0);
  }

  int Red()
  {
    this->Window->Render();
    return CountRed(this->Window);
  }
};
}

TEST(Clipping, ABallIsSeenInARoomAMillionTimesAsLarge)
{
  for (const char* projection : { "equirectangular", "azimuthal-equidistant" })
  {
    for (int mapping : { vtkWideFoVCamera::LINEAR, vtkWideFoVCamera::LOGARITHMIC })
    {
      int first = 0;
      for (double half : { 1e2, 1e4, 1e6 })
      {
        Scene scene(projection);
        const Overheard heard;
        scene.Camera->SetDepthMapping(mapping);
        scene.Renderer->AddActor(MakeBox(half));
        scene.Renderer->AddActor(MakeBall(0, 0, -3, 1));
        const int red = scene.Red();
        first = first > 0 ? first : red;
        EXPECT_GT(red, 20) << projection << ", mapping " << mapping << ", room of " << half;
        EXPECT_EQ(red, first) << projection << ", mapping " << mapping << ", room of " << half;
        EXPECT_EQ(heard.Count(Clipped), 0) << heard.All();
      }
    }
  }
}

TEST(Clipping, WhatIsTooNearForLinearDepthIsSaidAndLogarithmicDepthShowsIt)
{
  for (int mapping : { vtkWideFoVCamera::LINEAR, vtkWideFoVCamera::LOGARITHMIC })
  {
    Scene scene("equirectangular");
    const Overheard heard;
    scene.Camera->SetDepthMapping(mapping);
    scene.Renderer->AddActor(MakeBall(0, 1e11, 1e11, 1e9)); // a sun
    scene.Renderer->AddActor(MakeBox(1e3));
    scene.Renderer->AddActor(MakeBall(0, 0, -3, 1));
    const bool shows = mapping == vtkWideFoVCamera::LOGARITHMIC;
    EXPECT_EQ(scene.Red() > 100, shows);
    scene.Window->Render();
    EXPECT_EQ(heard.Count(Clipped), shows ? 0 : 1) << heard.All();
    EXPECT_EQ(heard.Count("something is 2 away"), shows ? 0 : 1) << heard.All();
  }
}

// The nearer of two sheets is drawn first, so that depth decides.
TEST(Clipping, LogarithmicDepthTellsHundredThousandthsApartFromAThousandthToABillion)
{
  constexpr double Apart = 1e-5; // of the distance: five steps of depth
  Scene scene("equirectangular");
  const Overheard heard;
  scene.Camera->SetDepthMappingToLogarithmic();
  const double distances[] = { 1e-3, 1e-1, 1e3, 1e6, 1e9 };
  int azimuth = -120;
  for (double distance : distances)
  {
    scene.Renderer->AddActor(MakeSheet(azimuth, distance, 1, 0, 0));
    scene.Renderer->AddActor(MakeSheet(azimuth, distance * (1 + Apart), 0, 0, 1));
    azimuth += 60;
  }
  scene.Window->Render();
  const TestPixels pixels(scene.Window);
  for (int i = 0; i < 5; i++)
  {
    const int x = static_cast<int>((0.5 + (-120 + 60 * i) / 360.0) * pixels.Width);
    const unsigned char* const p = pixels.At(x, pixels.Height / 2);
    EXPECT_GT(p[0], 200) << distances[i];
    EXPECT_LT(p[2], 50) << distances[i];
  }
  EXPECT_EQ(heard.All(), "");
}

// No vertex is near.
TEST(Clipping, AnEdgelessFloorUnderTheEyeIsSaidToBeClipped)
{
  Scene scene("equirectangular");
  const Overheard heard;
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-1e7, -1.7, 1e7);
  floor->SetPoint1(1e7, -1.7, 1e7);
  floor->SetPoint2(-1e7, -1.7, -1e7);
  scene.Renderer->AddActor(MakeTestActor(floor, 1, 1, 1));
  scene.Renderer->AddActor(MakeBox(1e7)); // or the floor's bounds are farther than nothing
  scene.Window->Render();
  EXPECT_EQ(heard.Count("something is 1.7 away"), 1) << heard.All();
}

TEST(Clipping, AMeshWithAnOutlierIsSaidToBeClipped)
{
  Scene scene("hammer");
  const Overheard heard;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> verts;
  constexpr int Many = 300000; // more than are measured
  for (int i = 0; i < Many; i++)
  {
    const double turn = 0.1 * i;
    const double place[3] = { 2 * std::cos(turn), 1.0 * i / Many, 2 * std::sin(turn) };
    const vtkIdType id = points->InsertNextPoint(place);
    verts->InsertNextCell(1, &id);
  }
  for (double x : { -1e9, 1e9 })
  {
    const vtkIdType id = points->InsertNextPoint(x, x, x);
    verts->InsertNextCell(1, &id);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->SetVerts(verts);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(cloud);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  scene.Window->Render();
  EXPECT_EQ(heard.Count("something is 2"), 1) << heard.All();
}

TEST(Clipping, NothingIsSaidOfWhatIsNotLookedAt)
{
  for (double gaze : { 1.0, -1.0 })
  {
    Scene scene("gnomonic");
    const Overheard heard;
    scene.Camera->SetFieldOfView(60);
    scene.Camera->SetFocalPoint(0, 0, gaze);
    scene.Renderer->AddActor(MakeBox(1e7));
    scene.Renderer->AddActor(MakeBall(0, 0, -3, 1));
    scene.Window->Render();
    EXPECT_EQ(heard.Count(Clipped), gaze < 0 ? 1 : 0) << heard.All();
  }
}

// The eye is in the bounds of the cones, and nothing is near.
TEST(Clipping, NothingIsSaidOfAnOrdinaryScene)
{
  for (const char* projection : { "equirectangular", "perspective" })
  {
    Scene scene(projection);
    const Overheard heard;
    scene.Renderer->AddActor(MakeTestRoom());
    AddTestCones(scene.Renderer);
    scene.Window->Render();
    EXPECT_EQ(heard.All(), "");
  }
}
