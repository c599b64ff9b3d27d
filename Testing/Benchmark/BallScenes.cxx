// SPDX-License-Identifier: BSD-3-Clause
#include "BallScenes.h"

#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkSphereSource.h>

#include <cmath>

namespace wfv
{
namespace bench
{
namespace
{
constexpr int BallCount = 127;
constexpr double Radius = 0.15; // seen from a distance of 1

// Even in height and turned by the golden angle: evenly over the sphere.
widefov::Vector3 Spiral(int i, int count)
{
  const double height = 1 - (2 * i + 1.0) / count;
  const double turn = i * vtkMath::Pi() * (3 - std::sqrt(5.0));
  const double level = std::sqrt(1 - height * height);
  return { { level * std::sin(turn), height, -level * std::cos(turn) } };
}

// Whether a ball there keeps away from the half plane behind the eye, and so from the poles.
bool KeepsAway(const widefov::Vector3& at)
{
  const double level = at[2] > 0 ? std::abs(at[0]) : std::hypot(at[0], at[2]);
  return level > 1.2 * Radius;
}

widefov::SceneProp MakeBall(const widefov::Vector3& at)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(65);
  ball->SetRadius(Radius);
  ball->SetCenter(at[0], at[1], at[2]);
  ball->Update();
  widefov::SceneProp prop;
  prop.Surface = ball->GetOutput();
  prop.Source = prop.Surface;
  prop.Label = "a ball";
  prop.Color = { { 0.6 + 0.4 * at[0], 0.6 + 0.4 * at[1], 0.6 + 0.4 * at[2] } };
  return prop;
}
}

widefov::Scene MakeBallScene(bool apart)
{
  widefov::Scene scene;
  scene.Eye = widefov::Vector3{ { 0, 0, 0 } };
  for (int count = BallCount; static_cast<int>(scene.Props.size()) < BallCount; count++)
  {
    scene.Props.clear();
    for (int i = 0; i < count; i++)
    {
      const widefov::Vector3 at = Spiral(i, count);
      if (!apart || KeepsAway(at))
      {
        scene.Props.push_back(MakeBall(at));
      }
    }
  }
  return scene;
}
}
}
