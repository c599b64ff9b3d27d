// SPDX-License-Identifier: BSD-3-Clause
// A million small triangles all round.
#include "Scenes.h"

#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkSphereSource.h>

#include <cmath>

namespace widefov
{
namespace
{
constexpr int BallCount = 127;
constexpr double Radius = 0.15; // seen from a distance of 1

// Even in height and turned by the golden angle: evenly over the sphere.
Vector3 Spiral(int i, int count)
{
  const double height = 1 - (2 * i + 1.0) / count;
  const double turn = i * vtkMath::Pi() * (3 - std::sqrt(5.0));
  const double level = std::sqrt(1 - height * height);
  return { { level * std::sin(turn), height, -level * std::cos(turn) } };
}

// Whether a ball there keeps away from the half plane behind the eye, and so from the poles.
bool KeepsAway(const Vector3& at)
{
  const double level = at[2] > 0 ? std::abs(at[0]) : std::hypot(at[0], at[2]);
  return level > 1.2 * Radius;
}

SceneProp MakeBall(const Vector3& at)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(65);
  ball->SetRadius(Radius);
  ball->SetCenter(at[0], at[1], at[2]);
  ball->Update();
  SceneProp prop;
  prop.Surface = ball->GetOutput();
  prop.Source = prop.Surface;
  prop.Label = "a ball";
  prop.Color = { { 0.6 + 0.4 * at[0], 0.6 + 0.4 * at[1], 0.6 + 0.4 * at[2] } };
  return prop;
}
Scene MakeBallScene(bool apart)
{
  Scene scene;
  scene.Eye = Vector3{ { 0, 0, 0 } };
  for (int count = BallCount; static_cast<int>(scene.Props.size()) < BallCount; count++)
  {
    scene.Props.clear();
    for (int i = 0; i < count; i++)
    {
      const Vector3 at = Spiral(i, count);
      if (!apart || KeepsAway(at))
      {
        scene.Props.push_back(MakeBall(at));
      }
    }
  }
  return scene;
}
}

Scene MakeBalls()
{
  return MakeBallScene(false);
}

Scene MakeBallsApart()
{
  return MakeBallScene(true);
}
}
