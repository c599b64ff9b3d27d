// SPDX-License-Identifier: BSD-3-Clause
// Meshes of fewer triangles: where they are, what they keep, and how many are left.
#include "Viewing/CoarseMesh.h"
#include "Viewing/CoarseScene.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>
#include <vtkTubeFilter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
constexpr double Size = 0.05; // of a cube, scene units

vtkSmartPointer<vtkPolyData> Sphere(int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->Update();
  return sphere->GetOutput();
}

// Twice the area that it would cover without holes, counted by the side that its normals are on.
double AreaOutside(vtkPolyData* mesh)
{
  double area = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetPolys()->GetNumberOfCells(); i++)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    double p[3][3];
    for (int k = 0; k < 3; k++)
    {
      mesh->GetPoint(ids->GetId(k), p[k]);
    }
    // the volume of the tetrahedron to the centre: of a ball a third of its surface
    area += (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
              p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
              p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
      2;
  }
  return area;
}

TEST(Coarse, ASphereStaysOne)
{
  const vtkSmartPointer<vtkPolyData> sphere = Sphere(300);
  vtkNew<vtkStripper> strips;
  strips->SetInputData(sphere);
  strips->Update();
  for (vtkPolyData* const mesh : { sphere.Get(), strips->GetOutput() })
  {
    const vtkSmartPointer<vtkPolyData> coarse = widefov::MakeCoarse(mesh, Size);
    EXPECT_LT(coarse->GetNumberOfPolys(), sphere->GetNumberOfPolys() / 10);
    EXPECT_EQ(coarse->GetNumberOfLines(), 0);
    EXPECT_NEAR(AreaOutside(coarse), 4 * 3.14159, 0.2) << "holes, or sides that are turned";
    const auto* const normals = vtkFloatArray::SafeDownCast(coarse->GetPointData()->GetNormals());
    ASSERT_NE(normals, nullptr);
    for (vtkIdType i = 0; i < coarse->GetNumberOfPoints(); i++)
    {
      double p[3];
      coarse->GetPoint(i, p);
      EXPECT_NEAR(normals->GetTypedComponent(i, 0), p[0], 0.02);
    }
  }
}

TEST(Coarse, ATubeIsALine)
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(0, 0, 0);
  line->SetPoint2(3, 2, 1);
  line->SetResolution(100);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(line->GetOutputPort());
  tube->SetRadius(0.001);
  tube->SetNumberOfSides(6);
  tube->Update();
  const vtkSmartPointer<vtkPolyData> coarse = widefov::MakeCoarse(tube->GetOutput(), Size);
  // which hundredths of its length there is something of
  std::array<bool, 100> covered{};
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < coarse->GetNumberOfCells(); i++)
  {
    coarse->GetCellPoints(i, ids);
    double least = 1;
    double most = 0;
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); k++)
    {
      double p[3];
      coarse->GetPoint(ids->GetId(k), p);
      least = std::min(least, p[0] / 3);
      most = std::max(most, p[0] / 3);
    }
    std::fill(covered.begin() + static_cast<int>(std::max(0., 100 * least)),
      covered.begin() + static_cast<int>(std::clamp(100 * most, 0., 100.)), true);
  }
  EXPECT_GT(coarse->GetNumberOfLines(), 20);
  EXPECT_GE(std::count(covered.begin(), covered.end(), true), 98);
  EXPECT_LT(coarse->GetNumberOfCells(), 400);
}

// Two points beside each other, two others, and one that is nowhere; cells with numbers.
vtkSmartPointer<vtkPolyData> OneOfEach()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const double x : { 0., 0.001, 1., 2. })
  {
    points->InsertNextPoint(x, x * x, 0);
  }
  points->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  verts->InsertNextCell({ 1 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 2, 3 });
  lines->InsertNextCell({ 0, 4 });
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 1, 2, 3 });
  mesh->SetVerts(verts);
  mesh->SetLines(lines);
  mesh->SetPolys(polys);
  vtkNew<vtkFloatArray> numbers;
  numbers->SetName("number");
  for (int i = 0; i < 5; i++)
  {
    numbers->InsertNextValue(static_cast<float>(i));
  }
  mesh->GetCellData()->AddArray(numbers);
  return mesh;
}

TEST(Coarse, CellsOfEveryKindKeepTheirData)
{
  const vtkSmartPointer<vtkPolyData> coarse = widefov::MakeCoarse(OneOfEach(), Size);
  EXPECT_EQ(coarse->GetNumberOfVerts(), 1);
  EXPECT_EQ(coarse->GetNumberOfLines(), 2);
  EXPECT_EQ(coarse->GetNumberOfPolys(), 1);
  auto* const kept = vtkFloatArray::SafeDownCast(coarse->GetCellData()->GetArray("number"));
  ASSERT_EQ(kept->GetNumberOfTuples(), 4);
  const float wanted[4] = { 0, 2, 2, 4 };
  for (int i = 0; i < 4; i++)
  {
    EXPECT_EQ(kept->GetValue(i), wanted[i]);
  }
}

TEST(Coarse, AsFewAsAsked)
{
  widefov::Scene scene;
  for (const int resolution : { 30, 300 })
  {
    widefov::SceneProp prop;
    prop.Surface = Sphere(resolution);
    scene.Props.push_back(prop);
  }
  const widefov::Scene coarse = widefov::MakeCoarse(scene, 20000);
  ASSERT_EQ(coarse.Props.size(), 2u);
  const long long left = widefov::CountPrimitives(coarse).Triangles;
  EXPECT_LE(left, 20000);
  EXPECT_GT(left, 10000);
  EXPECT_EQ(widefov::MakeCoarse(scene, 1000000).Props[1].Surface, scene.Props[1].Surface);
}
}
