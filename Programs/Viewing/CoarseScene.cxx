// SPDX-License-Identifier: BSD-3-Clause
#include "CoarseScene.h"

#include "CoarseMesh.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
constexpr int FirstCubes = 64; // along the scene's diagonal
constexpr int Tries = 4;
constexpr double Enough = 0.7; // of what is asked for

Scene WithCubes(const Scene& scene, double size)
{
  Scene coarse = scene;
  for (SceneProp& prop : coarse.Props)
  {
    if (prop.Kind == SceneProp::Shape::Mesh && prop.Surface)
    {
      prop.Surface = MakeCoarse(prop.Surface, size);
    }
  }
  return coarse;
}

long long CountCells(const Scene& scene)
{
  const PrimitiveCount count = CountPrimitives(scene);
  return count.Triangles + count.Lines;
}
}

// Cubes that a surface meets grow by the square of their number along an axis.
Scene MakeCoarse(const Scene& scene, long long most)
{
  double bounds[6];
  if (!SceneBounds(scene, bounds) || CountCells(scene) <= most)
  {
    return scene;
  }
  double size =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]) / FirstCubes;
  Scene coarse = WithCubes(scene, size);
  for (int i = 1; i < Tries; i++)
  {
    const long long count = CountCells(coarse);
    if (count <= most && count >= Enough * most)
    {
      break;
    }
    size *= std::sqrt(std::max<double>(count, 1) / (0.5 * (1 + Enough) * most));
    coarse = WithCubes(scene, size);
  }
  return coarse;
}
}
