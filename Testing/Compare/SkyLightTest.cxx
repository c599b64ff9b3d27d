// SPDX-License-Identifier: BSD-3-Clause
// Light from an environment: a ball that mirrors it, beside stock VTK's picture of it.
#include "SkyScene.h"

#include <vtkCamera.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int Side = 128;        // pixels of stock VTK's picture
constexpr double Angle = 60;     // its field of view, degrees
const vec3 Place(1.2, 0.8, 2.5); // of the ball, whose radius is 1: behind, to the side

void AddMirror(vtkOpenGLRenderer* renderer)
{
  renderer->UseImageBasedLightingOn();
  renderer->SetEnvironmentTexture(SmoothSky(true));
  renderer->GetEnvMapIrradiance()->SetIrradianceSize(16);
  renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(32);
  renderer->AutomaticLightCreationOff();
  const auto ball = YellowBall(Place, 1, 1);
  ball->GetProperty()->LightingOn();
  ball->GetProperty()->SetInterpolationToPBR();
  ball->GetProperty()->SetMetallic(1);
  ball->GetProperty()->SetRoughness(0.1);
  ball->GetProperty()->SetColor(1, 1, 1);
  renderer->AddActor(ball);
}

// Looking at the ball.
SkyPicture DrawStock()
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(Side, Side);
  vtkNew<vtkOpenGLRenderer> renderer;
  window->AddRenderer(renderer);
  AddMirror(renderer);
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 0);
  camera->SetFocalPoint(Place.x, Place.y, Place.z);
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(Angle);
  camera->SetClippingRange(0.5, 10);
  window->Render();
  vtkNew<vtkUnsignedCharArray> colors;
  window->GetPixelData(0, 0, Side - 1, Side - 1, 0, colors);
  SkyPicture picture;
  picture.Width = picture.Height = Side;
  picture.Colors.assign(colors->GetPointer(0), colors->GetPointer(0) + 3 * Side * Side);
  return picture;
}
}

TEST(SkyLight, OfAnEnvironmentIsStockVtks)
{
  const SkyPicture stock = DrawStock();
  SkyWindow window;
  window.Renderer->RemoveActor(window.Sky);
  AddMirror(window.Renderer);
  Shot shot;
  shot.Width = 1024;
  shot.Height = 512;
  shot.Options.Radii = { { 0.5, 10 } };
  const SkyPicture wide = window.Draw(shot);
  window.Keep("environment");
  const View view = window.GetView();
  const vec3 ahead = glm::normalize(Place);
  const vec3 right = glm::normalize(glm::cross(ahead, vec3(0, 1, 0)));
  const vec3 up = glm::cross(right, ahead);
  const double inside = std::cos(0.9 * std::asin(1 / glm::length(Place))); // well inside the ball
  SkyTally t;
  double sum = 0;
  stock.ForEach([&](int x, int y) {
    const vec2 at = std::tan(glm::radians(0.5 * Angle)) * stock.NdcOf(x, y);
    const vec3 direction = glm::normalize(ahead + at.x * right + at.y * up);
    if (glm::dot(direction, ahead) > inside)
    {
      const vec2 ndc(view.Forward(direction).Ndc);
      const vec2 pixel = 0.5 * (ndc + 1.0) * vec2(wide.Width, wide.Height);
      const int i = static_cast<int>(pixel.x);
      const int j = static_cast<int>(pixel.y);
      t.Look(wide, i, j, stock.At(x, y));
      sum += glm::length(stock.At(x, y) - wide.At(i, j));
      t.Inside++;
    }
  });
  EXPECT_GT(t.Inside, 3000);
  EXPECT_LE(sum / t.Inside, 3); // the nearest of pixels a third of a degree apart
  EXPECT_LE(t.Worst, 16);
}
