// SPDX-License-Identifier: BSD-3-Clause
// A prop that goes without the geometry stage, its edges running away from the eye: depth
// interpolated along them is off by more than what lies between its two layers.
#include "DrawingTest.h"
#include "RayCaster.h"
#include "vtkWideFoVPass.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

using namespace wfv;
using namespace wfv::test;

namespace
{
// A floor ahead, in so many rows of quads.
void AddFloor(vtkPoints* points, vtkCellArray* triangles, double y, int rows)
{
  constexpr int Columns = 40;
  constexpr double Near = 1;
  constexpr double Far = 3;
  const vtkIdType first = points->GetNumberOfPoints();
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= Columns; ++i)
    {
      points->InsertNextPoint(double(i) / Columns - 0.5, y, -Near - (Far - Near) * j / rows);
    }
  }
  for (vtkIdType j = 0; j < rows; ++j)
  {
    for (vtkIdType i = 0; i < Columns; ++i)
    {
      const vtkIdType p = first + j * (Columns + 1) + i;
      const vtkIdType q = p + Columns + 1;
      triangles->InsertNextCell({ p, p + 1, q });
      triangles->InsertNextCell({ p + 1, q + 1, q });
    }
  }
}
}

TEST(Plain, DepthIsThatOfTheSurface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  AddFloor(points, triangles, -0.1, 24); // seen, coarser than the one below it
  AddFloor(points, triangles, -0.1 * (1 + 5e-4), 48);
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  Shot shot;
  shot.Options.Radii = { { 0.5, 4 } };
  constexpr double Tolerance = 1; // pixels
  Drawing picture;
  picture.SetMesh(mesh);
  picture.SetTolerance(Tolerance);
  picture.SetTechnique(vtkWideFoVPass::AUTO);
  const reference::DrawnPicture drawn = picture.Draw(shot);
  EXPECT_EQ(picture.GetNumberOfPlainDraws(), 1);
  EXPECT_EQ(picture.GetNumberOfPreClipDraws(), 0);
  const reference::RayCaster caster(mesh, picture.GetView(), picture.GetPose());
  const reference::Metrics m = reference::Compare(drawn, caster, Tolerance);
  EXPECT_LE(m.MaxPx, Tolerance) << Details(shot, picture.GetView(), m);
  // the check can tell: depth along chords shows the lower floor through the upper one
  picture.SetTechnique(vtkWideFoVPass::VERTEX);
  EXPECT_GT(reference::Compare(picture.Draw(shot), caster, Tolerance).UnexplainedPixels, 50);
}
