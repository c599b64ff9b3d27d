// SPDX-License-Identifier: BSD-3-Clause
// Scenes of a few large triangles: what bends and tears most.
#include "MeshBuilder.h"
#include "Scenes.h"

#include <cmath>

namespace widefov
{
namespace
{
const Vector3 White{ { 0.85, 0.83, 0.78 } };
const Vector3 Red{ { 0.75, 0.12, 0.10 } };
const Vector3 Green{ { 0.15, 0.55, 0.18 } };
const Vector3 Blue{ { 0.20, 0.35, 0.75 } };

// The six walls of the cube [-h, h]^3: left, right, floor, ceiling, back (-z), front.
void AddWalls(MeshBuilder& mesh, double h, const std::array<Vector3, 6>& colors)
{
  const auto at = [h](int x, int y, int z) { return Vector3{ { h * x, h * y, h * z } }; };
  mesh.AddQuad(at(-1, -1, 1), at(-1, -1, -1), at(-1, 1, -1), at(-1, 1, 1), colors[0]);
  mesh.AddQuad(at(1, -1, -1), at(1, -1, 1), at(1, 1, 1), at(1, 1, -1), colors[1]);
  mesh.AddQuad(at(-1, -1, 1), at(1, -1, 1), at(1, -1, -1), at(-1, -1, -1), colors[2]);
  mesh.AddQuad(at(-1, 1, -1), at(1, 1, -1), at(1, 1, 1), at(-1, 1, 1), colors[3]);
  mesh.AddQuad(at(-1, -1, -1), at(1, -1, -1), at(1, 1, -1), at(-1, 1, -1), colors[4]);
  mesh.AddQuad(at(1, -1, 1), at(-1, -1, 1), at(-1, 1, 1), at(1, 1, 1), colors[5]);
}

// A block on the floor without its bottom (10 triangles), turned round the vertical.
void AddBlock(MeshBuilder& mesh, const Vector3& foot, double side, double height, double turn)
{
  std::array<Vector3, 8> corner;
  for (int i = 0; i < 4; i++)
  {
    constexpr double Quarter = 1.57079632679489661923;
    const double angle = turn + i * Quarter;
    const double r = side / std::sqrt(2.);
    corner[i] = foot + Vector3{ { r * std::cos(angle), 0, -r * std::sin(angle) } };
    corner[i + 4] = corner[i] + Vector3{ { 0, height, 0 } };
  }
  for (int i = 0; i < 4; i++)
  {
    const int next = (i + 1) % 4;
    mesh.AddQuad(corner[i], corner[next], corner[next + 4], corner[i + 4], White);
  }
  mesh.AddQuad(corner[4], corner[5], corner[6], corner[7], White);
}
}

Scene MakeCornell()
{
  MeshBuilder mesh;
  AddWalls(mesh, 1, { { Red, Green, White, White, White, Blue } });
  AddBlock(mesh, { { -0.45, -1, -0.45 } }, 0.6, 1.2, 1.1);
  AddBlock(mesh, { { 0.4, -1, 0.1 } }, 0.55, 0.6, 0.5);
  const double y = 0.999; // just under the ceiling
  mesh.AddQuad({ { -0.3, y, -0.3 } }, { { 0.3, y, -0.3 } }, { { 0.3, y, 0.3 } },
    { { -0.3, y, 0.3 } }, { { 1, 1, 0.9 } });
  return ColoredScene("cornell", mesh.Build());
}

Scene MakeRoom()
{
  MeshBuilder mesh;
  AddWalls(
    mesh, 1, { { Red, Green, { { 0.45, 0.32, 0.20 } }, { { 0.75, 0.85, 0.95 } }, White, Blue } });
  return ColoredScene("room", mesh.Build());
}
}
