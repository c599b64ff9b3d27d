// SPDX-License-Identifier: BSD-3-Clause
#include "Camera/PictureScale.h"

#include "Camera/Tile.h"
#include "vtkWideFoVCamera.h"

#include "vtkMath.h"
#include "vtkRenderer.h"

#include <cmath>

namespace wfv
{
void FindStep(vtkWideFoVCamera* camera, double aspect, const double place[3],
  const double direction[3], double way[2])
{
  constexpr double Step = 1e-3; // radians
  double eye[3];
  camera->GetPosition(eye);
  const double step = Step * std::sqrt(vtkMath::Distance2BetweenPoints(place, eye));
  double here[3];
  camera->WorldToNDC(place, aspect, here);
  way[0] = 1 / Step; // more than any way in the picture
  way[1] = 1 / Step;
  for (double sign : { 1.0, -1.0 })
  {
    double next[3];
    double there[3];
    for (int i = 0; i < 3; i++)
    {
      next[i] = place[i] + sign * step * direction[i];
    }
    camera->WorldToNDC(next, aspect, there);
    const double x = sign * 0.5 * (there[0] - here[0]) * aspect / Step;
    const double y = sign * 0.5 * (there[1] - here[1]) / Step;
    if (std::hypot(x, y) < std::hypot(way[0], way[1]))
    {
      way[0] = x;
      way[1] = y;
    }
  }
}

double FindPixelSize(vtkRenderer* renderer, vtkWideFoVCamera* camera, const double place[3])
{
  const double aspect = PictureAspect(renderer);
  double eye[3];
  double sight[3];
  double across[2][3];
  camera->GetPosition(eye);
  vtkMath::Subtract(place, eye, sight);
  const double distance = vtkMath::Normalize(sight);
  vtkMath::Perpendiculars(sight, across[0], across[1], 0);
  double ways[2][2];
  for (int i = 0; i < 2; i++)
  {
    FindStep(camera, aspect, place, across[i], ways[i]);
  }
  const double area = std::abs(ways[0][0] * ways[1][1] - ways[0][1] * ways[1][0]);
  const double pixels = std::sqrt(area) * PixelsOfTile(renderer).Full.y; // of a radian
  return pixels > 0 && std::isfinite(pixels) ? distance / pixels : 0;
}
}
