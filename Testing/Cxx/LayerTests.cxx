// SPDX-License-Identifier: BSD-3-Clause
// Renderers of one window that are drawn with one depth buffer (PreserveDepthBuffer).
#include "Overheard.h"
#include "WideFoVTestScene.h"

#include "Compat/Reports.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCubeSource.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

namespace
{
const char* const Kinds = "have depths of different kinds";

vtkSmartPointer<vtkActor> MakeBall(double radius, double z, double r, double g, double b)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0, 0, z);
  ball->SetRadius(radius);
  ball->SetThetaResolution(48);
  ball->SetPhiResolution(48);
  auto actor = MakeTestActor(ball, r, g, b);
  actor->GetProperty()->LightingOff();
  return actor;
}

// Below, a room of 40 and a red ball; above, a smaller blue ball before it. The eye is at the
// origin.
struct Layers : WideFoVTestWindow
{
  explicit Layers(const char* projection)
    : WideFoVTestWindow(projection, 256, 128)
  {
    wfv::ForgetReports();
    this->Window->SetMultiSamples(0);
    this->Window->SetNumberOfLayers(2);
    this->Place(this->Camera);
    this->Upper->SetLayer(1);
    this->Upper->PreserveDepthBufferOn();
    this->Upper->SetActiveCamera(this->Camera);
    this->Window->AddRenderer(this->Upper);
    vtkNew<vtkCubeSource> room;
    room->SetXLength(40);
    room->SetYLength(40);
    room->SetZLength(40);
    this->Renderer->AddActor(MakeTestActor(room, 0.5, 0.4, 0.1));
    this->Renderer->AddActor(MakeBall(0.6, -2, 1, 0, 0));
    this->Upper->AddActor(MakeBall(0.3, -1.2, 0, 0, 1));
  }

  static void Place(vtkCamera* camera)
  {
    camera->SetPosition(0, 0, 0);
    camera->SetFocalPoint(0, 0, -1);
  }

  int CountBlue()
  {
    this->Window->Render();
    const TestPixels pixels(this->Window);
    int n = 0;
    for (int y = 0; y < pixels.Height; y++)
    {
      for (int x = 0; x < pixels.Width; x++)
      {
        n += pixels.At(x, y)[2] - pixels.At(x, y)[0] > 128;
      }
    }
    return n;
  }

  void ShowLower(bool shown)
  {
    vtkActorCollection* const actors = this->Renderer->GetActors();
    for (int i = 0; i < actors->GetNumberOfItems(); i++)
    {
      vtkProp::SafeDownCast(actors->GetItemAsObject(i))->SetVisibility(shown);
    }
  }

  // All of the blue ball is seen.
  void ExpectBlueBefore(const char* what)
  {
    this->ShowLower(false);
    const int alone = this->CountBlue();
    this->ShowLower(true);
    const int seen = this->CountBlue();
    EXPECT_GT(alone, 50) << what;
    EXPECT_EQ(seen, alone) << what;
  }

  vtkNew<vtkWideFoVRenderer> Upper;
};
}

TEST(Layers, WhatIsNearerInAnUpperLayerIsSeen)
{
  for (const char* projection : { "equirectangular", "azimuthal-equidistant", "perspective" })
  {
    Layers layers(projection);
    if (std::string(projection) == "perspective")
    {
      layers.Camera->SetHorizontalFieldOfView(90);
      layers.Camera->SetVerticalFieldOfView(60);
    }
    const Overheard heard;
    layers.ExpectBlueBefore(projection);
    EXPECT_EQ(heard.All(), "");
  }
}

TEST(Layers, CamerasOfTheirOwnShareClipSpheres)
{
  Layers layers("hammer");
  const Overheard heard;
  vtkNew<vtkWideFoVCamera> other;
  other->SetProjection("hammer");
  Layers::Place(other);
  layers.Upper->SetActiveCamera(other);
  layers.ExpectBlueBefore("automatic");
  layers.Camera->SetClipRadii(0.2, 90);
  layers.ExpectBlueBefore("the lower one's are set");
  EXPECT_EQ(other->GetNearClipRadius(), 0.2);
  EXPECT_EQ(other->GetFarClipRadius(), 90);
  layers.Camera->AutomaticClipRadiiOn();
  other->SetClipRadii(0.3, 80);
  layers.ExpectBlueBefore("the upper one's are set");
  EXPECT_EQ(layers.Camera->GetFarClipRadius(), 80);
  EXPECT_EQ(heard.All(), "");
}

// Without PreserveDepthBuffer, and side by side.
TEST(Layers, OthersKeepClipSpheresOfTheirOwn)
{
  for (bool beside : { false, true })
  {
    Layers layers("equirectangular");
    vtkNew<vtkWideFoVCamera> other;
    Layers::Place(other);
    layers.Upper->SetActiveCamera(other);
    layers.Upper->SetPreserveDepthBuffer(beside);
    if (beside)
    {
      layers.Renderer->SetViewport(0, 0, 0.5, 1);
      layers.Upper->SetViewport(0.5, 0, 1, 1);
    }
    layers.Window->Render();
    EXPECT_LT(other->GetFarClipRadius(), 2);
    EXPECT_GT(layers.Camera->GetFarClipRadius(), 20);
  }
}

TEST(Layers, DepthsOfDifferentKindsAreSaidOnce)
{
  for (const char* kind : { "mapping", "radii", "stock" })
  {
    Layers layers("equirectangular");
    const Overheard heard;
    vtkNew<vtkWideFoVCamera> other;
    Layers::Place(other);
    layers.Upper->SetActiveCamera(other);
    if (std::string(kind) == "mapping")
    {
      other->SetDepthMappingToLogarithmic();
    }
    else if (std::string(kind) == "radii")
    {
      other->SetClipRadii(0.1, 50);
      layers.Camera->SetClipRadii(0.2, 50);
    }
    else
    {
      layers.Renderer->SetActiveCamera(vtkNew<vtkCamera>());
    }
    layers.Window->Render();
    layers.Window->Render();
    EXPECT_EQ(heard.Count(Kinds), 1) << kind << ": " << heard.All();
  }
}
