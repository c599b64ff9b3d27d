// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that run through one another at so small an angle that a depth buffer tells them apart
// nowhere near: the nearer one is seen, in whichever order they are drawn.
#include "DrawingTest.h"
#include "Poses.h"
#include "RayCaster.h"
#include "SampledShot.h"
#include "vtkWideFoVPass.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Cells along a side: of so many triangles a mesh is classified.
constexpr int Cells = 24;
constexpr vtkIdType OfOne = 2 * Cells * Cells;

// Pixels that show a sheet.
constexpr long LeastSeen = 100;

// Half a side of a sheet and its distance from the eye, whose coordinates all have one exponent: 16
// steps of float32, and as many again, from end to end.
constexpr double Half = 0.5;
constexpr double Ahead = 0.75;
constexpr double Rise = 1e-6;

// Between them a depth buffer of 24 bits has steps of 6e-8: of the two sheets, four pixels or so.
constexpr std::array<double, 2> Radii{ { 0.5, 1.5 } };

// Pixels.
constexpr double Exact = 0.02;

// A sheet across the view, nearer to one side by `rise`, farther to the other.
void AddSheet(vtkPoints* points, vtkCellArray* triangles, double rise)
{
  const vtkIdType first = points->GetNumberOfPoints();
  for (int j = 0; j <= Cells; j++)
  {
    for (int i = 0; i <= Cells; i++)
    {
      const double x = 2.0 * i / Cells - 1;
      const double y = 2.0 * j / Cells - 1;
      points->InsertNextPoint(Half * x, Half * y, -Ahead + rise * x);
    }
  }
  for (int j = 0; j < Cells; j++)
  {
    for (int i = 0; i < Cells; i++)
    {
      const vtkIdType a = first + j * (Cells + 1) + i;
      const vtkIdType b = a + Cells + 1;
      triangles->InsertNextCell({ a, a + 1, b + 1 });
      triangles->InsertNextCell({ a, b + 1, b });
    }
  }
}

// rises: of sheets, in the order they are drawn in.
vtkSmartPointer<vtkPolyData> MakeSheets(const std::vector<double>& rises)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (const double rise : rises)
  {
    AddSheet(points, triangles, rise);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

Shot MakeShotOf(const std::string& projection)
{
  const Projection& p = *FindProjection(projection);
  Shot shot = MakeShot(p.Name, FovsOf(p, { 120.0, 360.0 }).back(), PlainPoses().front());
  shot.Eye = vec3(0);
  shot.Options.Radii = Radii;
  return shot;
}

const std::vector<double> Orders[] = { { 0, Rise }, { Rise, 0 } };

class Order : public DrawingTest
{
protected:
  void SetUp() override { Picture->SetTechnique(vtkWideFoVPass::EXACT); }

  // mesh: of both sheets
  static void Check(const reference::DrawnPicture& drawn, vtkPolyData* mesh)
  {
    const reference::RayCaster caster(mesh, Picture->GetView(), Picture->GetPose());
    const reference::Metrics m = reference::Compare(drawn, caster, Exact);
    EXPECT_EQ(m.UnexplainedPixels, 0);
    EXPECT_LE(m.MaxPx, Exact);
    for (const vtkIdType from : { vtkIdType(0), OfOne })
    {
      EXPECT_GT(std::count_if(drawn.Cell.begin(), drawn.Cell.end(),
                  [from](float cell) { return cell > from && cell <= from + OfOne; }),
        LeastSeen);
    }
  }
};
}

TEST_P(Order, TheNearerIsSeenWhicheverComesFirst)
{
  for (const std::vector<double>& rises : Orders)
  {
    Picture->SetMesh(MakeSheets(rises));
    Check(Picture->Draw(MakeShotOf(this->GetParam())), Picture->GetMesh());
  }
}

INSTANTIATE_TEST_SUITE_P(All, Order, ::testing::ValuesIn(WideNames()), DrawingTest::NameOf);

class OrderOnDirectionMaps : public Order
{
};

// A display that only its directions describe, whose rays are in double between them too.
TEST_P(OrderOnDirectionMaps, TheNearerIsSeenWhicheverComesFirst)
{
  Shot shot = MakeShotOf(this->GetParam());
  UseMapOf(this->GetParam(), shot);
  for (const std::vector<double>& rises : Orders)
  {
    Picture->SetMesh(MakeSheets(rises));
    Check(Picture->Draw(shot), Picture->GetMesh());
  }
}

INSTANTIATE_TEST_SUITE_P(All, OrderOnDirectionMaps,
  ::testing::Values("equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap"),
  DrawingTest::NameOf);

class OrderOfProps : public Order
{
};

// Each is drawn by itself, by a stock mapper.
TEST_P(OrderOfProps, TheNearerIsSeenWhicheverComesFirst)
{
  for (const std::vector<double>& rises : Orders)
  {
    for (int i = 0; i < 2; i++)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(MakeSheets({ rises[i] }));
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      i == 0 ? Picture->SetActor(actor) : Picture->AddActor(actor, i);
    }
    Picture->SetPassTechnique(vtkWideFoVPass::EXACT);
    Picture->Draw(MakeShotOf(this->GetParam()));
    Check(reference::ToDrawnPicture(Picture->GetData(), { 0, OfOne }), MakeSheets(rises));
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, OrderOfProps, ::testing::Values("hammer", "gnomonic"), DrawingTest::NameOf);
