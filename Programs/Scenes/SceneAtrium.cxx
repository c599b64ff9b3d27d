// SPDX-License-Identifier: BSD-3-Clause
// A two-storey hall, closed all round, in as many triangles as a well-known one.
#include "MeshBuilder.h"
#include "Scenes.h"
#include "Text/Angles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
constexpr vtkIdType AtriumTriangles = 225839;

// Metres; the origin is the middle of the hall, where the eye is.
constexpr double HalfLength = 20; // along x
constexpr double HalfWidth = 10;  // along z
constexpr double HalfHeight = 7;  // along y
constexpr double RowZ = 5;        // the two rows of columns stand at z = +-5
constexpr int Bays = 8;           // between the columns of a row
constexpr double Bay = 2 * HalfLength / (Bays + 2);
constexpr double LowerFoot = -HalfHeight;
constexpr double GalleryY = -0.5;
constexpr double ColumnHeight = 3.6;
constexpr double StoreyHeight = GalleryY - LowerFoot - 0.3;
constexpr double ColumnRadius = 0.38;

const Vector3 Stone{ { 0.78, 0.70, 0.58 } };
const Vector3 PaleStone{ { 0.86, 0.80, 0.70 } };
const Vector3 DarkStone{ { 0.55, 0.47, 0.38 } };

double ColumnX(int i)
{
  return -0.5 * Bays * Bay + i * Bay;
}

// A share in [0, 1) that looks random and is the same everywhere.
double Scatter(int i, int j)
{
  const unsigned int h =
    static_cast<unsigned int>(i) * 73856093U ^ static_cast<unsigned int>(j) * 19349663U;
  return (h * 2654435761U >> 8) / double(1U << 24);
}

MeshBuilder::Surface Plane(const Vector3& corner, const Vector3& u, const Vector3& v)
{
  return [=](double s, double t) { return corner + s * u + t * v; };
}

MeshBuilder::TileColor Bricks(const Vector3& color)
{
  return [color](int i, int j) { return (0.82 + 0.18 * Scatter(i + j % 2, j)) * color; };
}

void AddFloor(MeshBuilder& mesh)
{
  mesh.AddTiles(120, 60,
    Plane({ { -HalfLength, -HalfHeight, HalfWidth } }, { { 2 * HalfLength, 0, 0 } },
      { { 0, 0, -2 * HalfWidth } }),
    [](int i, int j) {
      const Vector3& color = (i / 2 + j / 2) % 2 == 0 ? PaleStone : DarkStone;
      return (0.9 + 0.1 * Scatter(i, j)) * color;
    });
}

void AddWalls(MeshBuilder& mesh)
{
  const double h = 2 * HalfHeight;
  for (const int side : { -1, 1 })
  {
    mesh.AddTiles(160, 56,
      Plane({ { -side * -HalfLength, -HalfHeight, side * HalfWidth } },
        { { -side * 2 * HalfLength, 0, 0 } }, { { 0, h, 0 } }),
      Bricks(Stone));
    mesh.AddTiles(80, 56,
      Plane({ { side * HalfLength, -HalfHeight, side * -HalfWidth } },
        { { 0, 0, side * 2 * HalfWidth } }, { { 0, h, 0 } }),
      Bricks(side < 0 ? Vector3{ { 0.72, 0.55, 0.45 } } : Vector3{ { 0.55, 0.62, 0.66 } }));
  }
}

void AddRoof(MeshBuilder& mesh)
{
  mesh.AddTiles(120, 40,
    Plane({ { -HalfLength, HalfHeight, -HalfWidth } }, { { 2 * HalfLength, 0, 0 } },
      { { 0, 0, 2 * HalfWidth } }),
    [](int i, int j) {
      const bool open = j >= 12 && j < 28 && i % 10 != 0 && j % 8 != 4;
      return open ? Vector3{ { 0.62, 0.78, 0.95 } } : (0.9 + 0.1 * Scatter(i, j)) * DarkStone;
    });
}

void AddGallery(MeshBuilder& mesh, int side)
{
  const double depth = HalfWidth - RowZ + 0.5;
  const double z = side * (RowZ - 0.5);
  const Vector3 along{ { 2 * HalfLength, 0, 0 } };
  const Vector3 across{ { 0, 0, side * depth } };
  for (const double y : { GalleryY, GalleryY - 0.3 })
  {
    mesh.AddTiles(120, 12, Plane({ { -HalfLength, y, z } }, along, across), Bricks(PaleStone));
  }
  mesh.AddTiles(
    20, 1, Plane({ { -HalfLength, GalleryY - 0.3, z } }, along, { { 0, 0.3, 0 } }), Bricks(Stone));
}

// Radius and height of a column: plinth, base, shaft with a swelling, capital.
std::array<double, 2> ColumnProfile(double t)
{
  const double base = 0.45 * ColumnRadius * std::exp(-t / 0.035);
  const double capital = 0.55 * ColumnRadius * std::exp(-(1 - t) / 0.05);
  const double shaft = ColumnRadius * (0.85 + 0.08 * std::sin(Pi * t));
  return { { shaft + base + capital, ColumnHeight * t } };
}

// The wall above an arch between two columns, both faces and the underside.
void AddArch(MeshBuilder& mesh, double x, double foot, double z)
{
  const double springing = foot + ColumnHeight;
  const double top = foot + StoreyHeight;
  const double thickness = 0.35;
  const auto arc = [=](double u) {
    const double angle = Pi * (1 - u);
    return Vector3{ { x + 0.5 * Bay * std::cos(angle), springing + 0.42 * Bay * std::sin(angle),
      z } };
  };
  const auto face = [=](double dz) {
    return [=](double u, double v) {
      const Vector3 low = arc(u);
      const Vector3 high{ { low[0], top, z } };
      return (1 - v) * low + v * high + Vector3{ { 0, 0, dz } };
    };
  };
  mesh.AddGrid(24, 3, face(thickness), Stone);
  mesh.AddGrid(24, 3, face(-thickness), Stone);
  mesh.AddGrid(
    24, 4,
    [=](double u, double v) {
      return arc(u) + Vector3{ { 0, 0, thickness * (1 - 2 * v) } };
    },
    PaleStone);
}

void AddDrape(MeshBuilder& mesh, int bay, int side)
{
  static const std::array<Vector3, 3> cloth{ { { { 0.62, 0.10, 0.10 } }, { { 0.12, 0.40, 0.16 } },
    { { 0.12, 0.18, 0.50 } } } };
  const double left = ColumnX(bay) + 0.55;
  const double width = Bay - 1.1;
  const double top = GalleryY + ColumnHeight - 0.2;
  mesh.AddGrid(
    40, 40,
    [=](double u, double v) {
      const double fold = 0.12 * (0.25 + 0.75 * v) * std::sin(2 * Pi * (5 * u + 0.3 * bay));
      const double sag = 0.25 * std::sin(Pi * u) * (1 - v);
      return Vector3{ { left + width * u * (1 - 0.06 * v), top - sag - 2.4 * v,
        side * (RowZ - 0.1) + fold } };
    },
    cloth[static_cast<std::size_t>(bay + (side + 1) / 2) % cloth.size()]);
}

void AddBalusters(MeshBuilder& mesh, int bay, int side)
{
  constexpr int Count = 6;
  for (int i = 0; i < Count; i++)
  {
    const Vector3 foot{ { ColumnX(bay) + Bay * (i + 0.5) / Count, GalleryY, side * (RowZ - 0.4) } };
    mesh.AddLathe(
      foot, 10, 6,
      [](double t) {
        return std::array<double, 2>{ { 0.05 + 0.05 * std::sin(Pi * t) * std::sin(2 * Pi * t + 1),
          0.9 * t } };
      },
      PaleStone);
  }
}

void AddRow(MeshBuilder& mesh, int side)
{
  for (const double foot : { LowerFoot, GalleryY })
  {
    for (int i = 0; i <= Bays; i++)
    {
      mesh.AddLathe({ { ColumnX(i), foot, side * RowZ } }, 24, 28, ColumnProfile, PaleStone);
    }
    for (int i = 0; i < Bays; i++)
    {
      AddArch(mesh, ColumnX(i) + 0.5 * Bay, foot, side * RowZ);
    }
  }
  for (int i = 0; i < Bays; i++)
  {
    AddDrape(mesh, i, side);
    AddBalusters(mesh, i, side);
  }
  AddGallery(mesh, side);
}
}

Scene MakeAtrium()
{
  MeshBuilder mesh;
  AddFloor(mesh);
  AddWalls(mesh);
  AddRoof(mesh);
  AddRow(mesh, -1);
  AddRow(mesh, 1);
  // the rosette in the floor takes what is left of the budget; not right below the eye,
  // where a hundred slivers would meet in the pole of the picture
  const vtkIdType left = AtriumTriangles - mesh.GetNumberOfTriangles();
  if (left < 24)
  {
    Fail("the atrium has " + std::to_string(-left) + " triangles too many for its rosette");
  }
  mesh.AddRosette({ { 6, -HalfHeight + 0.02, 0 } }, 2.5, static_cast<int>(left),
    { { 0.45, 0.15, 0.12 } }, { { 0.92, 0.85, 0.65 } });
  return ColoredScene("atrium", mesh.Build());
}
}
