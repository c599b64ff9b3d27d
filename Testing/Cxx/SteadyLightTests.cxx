// SPDX-License-Identifier: BSD-3-Clause
// Lights that stand still before the camera are constants of the shaders: the picture is that of
// uniforms, whatever changes, and a fade compiles nothing for each of its steps.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace
{
// Levels of 255: a constant is multiplied out in another order than a uniform.
constexpr int LightRounding = 1;

// A ball round the eye in a headlight and one more.
struct LitBall
{
  LitBall()
    : Test("equirectangular", 128, 64)
  {
    this->Head->SetLightTypeToHeadlight();
    this->Head->SetIntensity(0.3);
    this->Side->SetLightTypeToCameraLight();
    this->Side->SetPosition(1, 0.5, 0.2);
    this->Side->SetFocalPoint(0, 0, 0);
    this->Side->SetColor(1, 0.6, 0.2);
    this->Side->SetIntensity(0.6);
    this->Test.Renderer->AddLight(this->Head);
    this->Test.Renderer->AddLight(this->Side);
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(3);
    ball->SetThetaResolution(24);
    ball->SetPhiResolution(24);
    this->Test.Renderer->AddActor(MakeTestActor(ball, 0.9, 0.9, 0.9));
  }

  std::vector<unsigned char> Draw()
  {
    this->Test.Window->Render();
    const TestPixels pixels(this->Test.Window);
    const unsigned char* const first = pixels.At(0, 0);
    return { first, first + pixels.Data->GetNumberOfValues() };
  }

  int Programs() { return this->Test.Pass()->GetNumberOfMadePrograms(); }

  WideFoVTestWindow Test;
  vtkNew<vtkLight> Head;
  vtkNew<vtkLight> Side;
};

int MostDifferent(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  EXPECT_EQ(a.size(), b.size());
  int most = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); i++)
  {
    most = std::max(most, std::abs(a[i] - b[i]));
  }
  return most;
}
}

TEST(SteadyLights, ConstantsAndUniformsLightAlike)
{
  LitBall ball;
  const auto constants = ball.Draw();
  ball.Side->SetIntensity(0.2);
  EXPECT_GT(MostDifferent(ball.Draw(), constants), 20) << "the light is not seen to change";
  ball.Side->SetIntensity(0.6);
  EXPECT_LE(MostDifferent(ball.Draw(), constants), LightRounding) << "uniforms";
  EXPECT_LE(MostDifferent(ball.Draw(), constants), LightRounding) << "constants again";
}

TEST(SteadyLights, ACameraLightTurnsWithTheCamera)
{
  LitBall still;
  still.Test.Camera->Yaw(70);
  const auto expected = still.Draw();
  LitBall turned;
  turned.Draw();
  const int programs = turned.Programs();
  turned.Test.Camera->Yaw(70);
  EXPECT_EQ(MostDifferent(turned.Draw(), expected), 0);
  EXPECT_EQ(turned.Programs(), programs);
}

TEST(SteadyLights, ASceneLightStaysInTheScene)
{
  LitBall still;
  still.Side->SetLightTypeToSceneLight();
  still.Test.Renderer->LightFollowCameraOff(); // so that none is a constant
  still.Test.Camera->Yaw(70);
  const auto expected = still.Draw();
  LitBall turned;
  turned.Side->SetLightTypeToSceneLight();
  turned.Draw();
  const int programs = turned.Programs();
  turned.Test.Camera->Yaw(70);
  EXPECT_LE(MostDifferent(turned.Draw(), expected), LightRounding);
  EXPECT_EQ(turned.Programs(), programs);
}

TEST(SteadyLights, AFadeCompilesOnce)
{
  LitBall ball;
  ball.Draw();
  ball.Side->SetIntensity(0.59);
  ball.Draw();
  const int programs = ball.Programs();
  for (int i = 1; i < 10; i++)
  {
    ball.Side->SetIntensity(0.59 - 0.05 * i);
    ball.Draw();
    EXPECT_EQ(ball.Programs(), programs) << i;
  }
  ball.Draw();
  EXPECT_GT(ball.Programs(), programs) << "not constant again";
}
