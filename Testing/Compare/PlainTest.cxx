// SPDX-License-Identifier: BSD-3-Clause
// Meshes that are drawn by their chords: a large one, and a prop that goes without the geometry
// stage, its edges running away from the eye: depth interpolated along them is off by more than
// what lies between its two layers.
#include "DrawingTest.h"
#include "Meshes.h"
#include "RayCaster.h"
#include "vtkWideFoVPass.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int Columns = 40;

// Rows of quads, whose points are there already. turned: wound to show the other side.
void AddQuads(vtkCellArray* triangles, vtkIdType first, vtkIdType rows, bool turned = false)
{
  for (vtkIdType j = 0; j < rows; ++j)
  {
    for (vtkIdType i = 0; i < Columns; ++i)
    {
      const vtkIdType p = first + j * (Columns + 1) + i;
      const vtkIdType q = p + Columns + 1;
      const vtkIdType a = turned ? q : p + 1;
      const vtkIdType b = turned ? p + 1 : q;
      triangles->InsertNextCell({ p, a, b });
      triangles->InsertNextCell({ q + 1, b, a });
    }
  }
}

// A floor ahead, in so many rows of quads.
void AddFloor(vtkPoints* points, vtkCellArray* triangles, double y, int rows, bool turned = false)
{
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
  AddQuads(triangles, first, rows, turned);
}

// Two floors, the lower one by a share of the way down to the upper one, and finer. turned: the
// upper one.
vtkSmartPointer<vtkPolyData> MakeTwoFloors(double y, double gap, int rows, bool turned = false)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  AddFloor(points, triangles, y, rows, turned);
  AddFloor(points, triangles, y * (1 + gap), 2 * rows);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

// A wall beside the eye, from ahead to behind it.
vtkSmartPointer<vtkPolyData> MakeWall()
{
  constexpr int Rows = 8; // half of them behind, by an edge just at the side
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j <= Rows; ++j)
  {
    for (int i = 0; i <= Columns; ++i)
    {
      points->InsertNextPoint(20, 0.25 * i - 5, 0.25 * j - 1);
    }
  }
  AddQuads(triangles, 0, Rows);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

Shot WidestShot(const char* projection, double nearest, double farthest)
{
  Shot shot;
  shot.Projection = projection;
  shot.Options.HorizontalFov = FindProjection(projection)->MaxHorizontalFov;
  shot.Options.VerticalFov = FindProjection(projection)->MaxVerticalFov;
  shot.Options.Radii = { { nearest, farthest } };
  return shot;
}

// A globe, and at each of its edges a triangle that runs through it there: on one side it hides the
// face of the globe, on the other one it is behind it.
vtkSmartPointer<vtkPolyData> MakeCrossings(int n)
{
  constexpr double Half = 0.35; // of the edge, to either side of its middle
  constexpr double Reach = 0.3; // across
  const vtkSmartPointer<vtkPolyData> globe = MakeGlobe(n);
  const vtkIdType triangles = globe->GetNumberOfPolys();
  const auto place = [&](vtkIdType point) {
    const double* const p = globe->GetPoint(point);
    return vec3(p[0], p[1], p[2]);
  };
  const auto add = [&](
                     const vec3& p) { return globe->GetPoints()->InsertNextPoint(p.x, p.y, p.z); };
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < triangles; ++i)
  {
    globe->GetPolys()->GetCellAtId(i, corners);
    for (int j = 0; j < 3; ++j)
    {
      const vec3 a = place(corners->GetId(j));
      const vec3 b = place(corners->GetId((j + 1) % 3));
      if (corners->GetId(j) > corners->GetId((j + 1) % 3))
      {
        continue; // the neighbour's
      }
      const vec3 middle = 0.5 * (a + b);
      const vec3 aside = glm::cross(b - a, middle) - glm::length(b - a) * middle;
      globe->GetPolys()->InsertNextCell({ add(middle + Half * (b - a) + Reach * aside),
        add(middle - Half * (b - a) + Reach * aside), add(middle - Reach * aside) });
    }
  }
  globe->Modified();
  return globe;
}

// A room of more than a million triangles; with one quadrangle its corners have to be copied.
vtkSmartPointer<vtkPolyData> MakeLargeRoom(bool copied)
{
  constexpr int Cells = 300; // a row of a face
  vtkSmartPointer<vtkPolyData> mesh = MakeRoom(Cells);
  if (copied)
  {
    mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
    mesh->Modified();
  }
  return mesh;
}

Shot MakeLargeShot(double x)
{
  Shot shot;
  shot.Options.Radii = { { 0.02, 4 } };
  shot.Eye = vec3(x, 0.1, 0.05);
  return shot;
}

// Of a picture that is drawn by chords for the most part.
reference::Metrics ExpectPlainWithin(
  Drawing& picture, vtkPolyData* mesh, const Shot& shot, double tolerance)
{
  const reference::DrawnPicture drawn = picture.Draw(shot);
  EXPECT_EQ(picture.GetNumberOfPlainDraws(), 1);
  const reference::RayCaster caster(mesh, picture.GetView(), picture.GetPose());
  const reference::Metrics m = reference::Compare(drawn, caster, tolerance);
  EXPECT_LE(m.MaxPx, tolerance) << Details(shot, picture.GetView(), m);
  return m;
}

void ExpectSame(const reference::DrawnPicture& a, const reference::DrawnPicture& b)
{
  EXPECT_EQ(a.Cell, b.Cell);
  EXPECT_EQ(a.Distance, b.Distance);
}
}

// What is known of a large mesh in one view does not stay for the next: another view, and the first
// one again, show what they show when they are drawn first.
TEST(Plain, LargeMeshesAreClassifiedAnew)
{
  for (const bool copied : { false, true })
  {
    const vtkSmartPointer<vtkPolyData> mesh = MakeLargeRoom(copied);
    ASSERT_GT(mesh->GetNumberOfPolys(), 1000000);
    Drawing picture;
    Drawing other;
    for (Drawing* const drawing : { &picture, &other })
    {
      drawing->SetMesh(mesh);
      drawing->SetTechnique(vtkWideFoVPass::AUTO);
    }
    const reference::DrawnPicture first = picture.Draw(MakeLargeShot(0.3));
    EXPECT_GT(picture.GetNumberOfPlainDraws(), 0);
    const reference::DrawnPicture second = picture.Draw(MakeLargeShot(-0.4));
    EXPECT_NE(first.Cell, second.Cell);
    ExpectSame(other.Draw(MakeLargeShot(-0.4)), second);
    ExpectSame(picture.Draw(MakeLargeShot(0.3)), first);
  }
}

TEST(Plain, DepthIsThatOfTheSurface)
{
  const vtkSmartPointer<vtkPolyData> mesh = MakeTwoFloors(-0.1, 5e-4, 24);
  Shot shot;
  shot.Options.Radii = { { 0.5, 4 } };
  constexpr double Tolerance = 1; // pixels
  Drawing picture;
  picture.SetMesh(mesh);
  picture.SetTolerance(Tolerance);
  picture.SetTechnique(vtkWideFoVPass::AUTO);
  const reference::DrawnPicture drawn = picture.Draw(shot);
  EXPECT_EQ(picture.GetNumberOfPlainDraws(), 1); // all but what is in doubt beside outlines
  const reference::RayCaster caster(mesh, picture.GetView(), picture.GetPose());
  const reference::Metrics m = reference::Compare(drawn, caster, Tolerance);
  EXPECT_LE(m.MaxPx, Tolerance) << Details(shot, picture.GetView(), m);
  // the check can tell: depth along chords shows the lower floor through the upper one
  picture.SetTechnique(vtkWideFoVPass::VERTEX);
  EXPECT_GT(reference::Compare(picture.Draw(shot), caster, Tolerance).UnexplainedPixels, 50);
}

// A sample that a chord gives to the wrong one of two faces shows that where it is hidden, beside
// the edge, by what runs through it there: not seen as near as the chord is to its edge.
TEST(Plain, SurfacesMayCrossAtEdges)
{
  constexpr double Tolerance = 0.05; // pixels
  const vtkSmartPointer<vtkPolyData> mesh = MakeCrossings(40);
  Drawing picture;
  picture.SetMesh(mesh);
  picture.SetTolerance(Tolerance);
  picture.SetTechnique(vtkWideFoVPass::AUTO);
  for (const char* const projection : { "equirectangular", "mercator", "cylindrical-equal-area",
         "azimuthal-equidistant", "sinusoidal", "mollweide", "miller" })
  {
    Shot shot;
    shot.Projection = projection;
    shot.Width = 1024;
    shot.Height = 512;
    shot.Options.Radii = { { 0.5, 4 } };
    ExpectPlainWithin(picture, mesh, shot, Tolerance);
  }
}

// A chord is off its edge by up to a hundredth of a pixel, which of a surface that is seen aslant
// makes some 1e-4 of its distance: by so much the floors are nearer to each other. Whichever side
// the upper one shows.
TEST(Plain, DepthIsThatOfThePixelsRay)
{
  constexpr double Tolerance = 0.25; // pixels
  constexpr double DepthTolerance = 1e-5;
  for (const bool turned : { false, true })
  {
    const vtkSmartPointer<vtkPolyData> mesh = MakeTwoFloors(-0.6, 1e-5, 12, turned);
    Drawing picture;
    picture.SetMesh(mesh);
    picture.SetTolerance(Tolerance);
    picture.SetTechnique(vtkWideFoVPass::AUTO);
    for (const char* const projection : { "equirectangular", "mercator", "hammer", "sinusoidal",
           "azimuthal-equidistant", "orthographic", "equi-angular-cubemap" })
    {
      const Shot shot = WidestShot(projection, 0.5, 4);
      const reference::Metrics m = ExpectPlainWithin(picture, mesh, shot, Tolerance);
      EXPECT_LE(m.MaxDepthRel, DepthTolerance) << Describe(shot);
    }
  }
}

// Triangles behind the eye would be drawn inside the rim of a map that folds there.
TEST(Plain, NothingComesFromBeyondTheRim)
{
  constexpr double Tolerance = 0.25; // pixels
  const vtkSmartPointer<vtkPolyData> mesh = MakeWall();
  Drawing picture;
  picture.SetMesh(mesh);
  picture.SetTolerance(Tolerance);
  picture.SetTechnique(vtkWideFoVPass::AUTO);
  Shot shot = WidestShot("orthographic", 1, 100);
  shot.Width = 1024;
  shot.Height = 512;
  ExpectPlainWithin(picture, mesh, shot, Tolerance);
}
