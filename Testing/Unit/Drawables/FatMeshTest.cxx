// SPDX-License-Identifier: BSD-3-Clause
// Which meshes go without rays in double, and what numbers in two floats keep.
#include "Drawables/FatMesh.h"
#include "Camera/TwoFloats.h"

#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace wfv;

namespace
{
// A matrix that moves the eye to a place.
struct From
{
  double Matrix[16];
  From(double x, double y, double z)
    : Matrix{ 1, 0, 0, -x, 0, 1, 0, -y, 0, 0, 1, -z, 0, 0, 0, 1 }
  {
  }
};

bool IsFatTriangle(const double (&corners)[3][3])
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  triangles->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return IsFat(mesh, From(0, 0, 0).Matrix);
}
}

TEST(FatMesh, ARoomIsFromInside)
{
  vtkNew<vtkCubeSource> room;
  room->SetXLength(2);
  room->SetYLength(2);
  room->SetZLength(2);
  room->Update();
  EXPECT_TRUE(IsFat(room->GetOutput(), From(0, 0, 0).Matrix));
  EXPECT_TRUE(IsFat(room->GetOutput(), From(0.7, -0.6, 0.5).Matrix));
  // a wall seen along it
  EXPECT_FALSE(IsFat(room->GetOutput(), From(0.999, 0, 0).Matrix));
  EXPECT_FALSE(IsFat(room->GetOutput(), From(0, 5, 1.001).Matrix));
}

TEST(FatMesh, ThinAndPointedTrianglesAreNot)
{
  EXPECT_TRUE(IsFatTriangle({ { 0, 0, -1 }, { 0.1, 0, -1 }, { 0, 0.1, -1 } }));
  EXPECT_FALSE(IsFatTriangle({ { 0, 0, -1 }, { 0.1, 0, -1 }, { 0, 1e-4, -1 } }));       // a needle
  EXPECT_FALSE(IsFatTriangle({ { 0, 0, -1 }, { 1e-4, 0, -1 }, { 0, 1e-4, -1 } }));      // a speck
  EXPECT_FALSE(IsFatTriangle({ { 0, 1e-4, -1 }, { 0.1, 1e-4, -1 }, { 0, 1e-4, -2 } })); // edge-on
  EXPECT_FALSE(IsFatTriangle({ { 0, 0, 0 }, { 0.1, 0, -1 }, { 0, 0.1, -1 } })); // at the eye
  EXPECT_FALSE(IsFatTriangle({ { 0, 0, -1 }, { 0, 0, -1 }, { 0, 0.1, -1 } }));  // none
  EXPECT_FALSE(IsFatTriangle({ { 0, 0, -1 }, { std::nan(""), 0, -1 }, { 0, 0.1, -1 } }));
}

// Compilers may take x - float(x) for nothing where several are made at once.
TEST(TwoFloats, AddUpToTheNumber)
{
  const double pi = std::acos(-1.0);
  const double numbers[4] = { pi / 512, 1.0 / 3, 0.25, -pi };
  float high[4];
  float low[4];
  for (int i = 0; i < 4; i++)
  {
    high[i] = static_cast<float>(numbers[i]);
    low[i] = LowPart(numbers[i]);
  }
  for (int i = 0; i < 4; i++)
  {
    EXPECT_NEAR(double(high[i]) + double(low[i]), numbers[i], 1e-14 * std::abs(numbers[i]));
  }
  EXPECT_EQ(low[2], 0);
}
