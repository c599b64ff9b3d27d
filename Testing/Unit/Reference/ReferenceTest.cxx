// SPDX-License-Identifier: BSD-3-Clause
// The ray caster against brute force and against what is known without it.
#include "Metrics.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <random>

using namespace wfv;
using namespace wfv::reference;

namespace
{
View SphereBetween(double nearRadius, double farRadius)
{
  ViewOptions o;
  o.Radii = { { nearRadius, farRadius } };
  return View(*FindProjection("equirectangular"), o);
}

Pose EyeAt(double x, double y, double z)
{
  Pose pose = IdentityPose();
  pose[3] = -x;
  pose[7] = -y;
  pose[11] = -z;
  return pose;
}

vtkSmartPointer<vtkPolyData> Sphere(int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

// Triangles of all sizes and directions round the origin.
vtkSmartPointer<vtkPolyData> RandomTriangles(int count)
{
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i < count; ++i)
  {
    const vec3 c = vec3(unit(engine), unit(engine), unit(engine)) * 10.0;
    const double size = std::pow(10, 1.5 * unit(engine) - 0.5);
    vtkIdType ids[3];
    for (vtkIdType& id : ids)
    {
      id = points->InsertNextPoint(
        c.x + size * unit(engine), c.y + size * unit(engine), c.z + size * unit(engine));
    }
    cells->InsertNextCell(3, ids);
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(points);
  polyData->SetPolys(cells);
  return polyData;
}

Hit BruteForce(const RayCaster& caster, const vec3& o, const vec3& d)
{
  Hit best;
  const TriangleSoup& soup = caster.GetTriangles();
  const vec2 radii = caster.GetView().GetParameters().radii;
  for (std::size_t n = 0; n < soup.Triangles.size(); ++n)
  {
    const auto& t = soup.Triangles[n];
    const auto hit =
      IntersectTriangle(o, d, { { soup.Points[t[0]], soup.Points[t[1]], soup.Points[t[2]] } });
    if (hit.Found && hit.Distance >= radii.x && hit.Distance <= radii.y &&
      hit.Distance < best.Distance)
    {
      best.Triangle = vtkIdType(n);
      best.Cell = soup.CellIds[n];
      best.Distance = hit.Distance;
    }
  }
  return best;
}
}

TEST(RayCaster, CandidatesAreComplete)
{
  const View view = SphereBetween(0.5, 12);
  const RayCaster caster(RandomTriangles(3000), view, EyeAt(0.1, -0.2, 0.3));
  int hits = 0;
  for (const vec3& d : test::RandomDirections(4000))
  {
    for (const vec3& o : { vec3(0), vec3(0.3, 0, 0.4) })
    {
      const Hit hit = caster.Cast(o, d);
      const Hit brute = BruteForce(caster, o, d);
      ASSERT_EQ(hit.Triangle, brute.Triangle) << test::Text(d);
      hits += hit.Cell >= 0;
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST(RayCaster, CandidatesAreCompleteAlongBoxFaces)
{
  // rays along the faces and diagonals of the boxes of the search, through shared vertices
  const View view = SphereBetween(1e-3, 100);
  const RayCaster caster(Sphere(64), view, EyeAt(0, 0, 0));
  for (double offset : { 0.0, 1e-15, 1e-12, 1e-9 })
  {
    for (const vec3& d : test::SpecialDirections(offset))
    {
      const Hit hit = caster.Cast(vec3(0), d);
      ASSERT_EQ(hit.Triangle, BruteForce(caster, vec3(0), d).Triangle) << test::Text(d);
      ASSERT_GE(hit.Cell, 0) << test::Text(d);
    }
  }
}

TEST(RayCaster, KnowsDistanceAndBarycentricsOfAPlane)
{
  // one triangle in the plane z = -3
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-4, -4, -3);
  points->InsertNextPoint(8, -4, -3);
  points->InsertNextPoint(-4, 8, -3);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> polyData;
  polyData->SetPoints(points);
  polyData->SetPolys(cells);
  const View view = SphereBetween(0.1, 100);
  const RayCaster caster(polyData, view, EyeAt(0, 0, 0));
  for (const vec3& target : { vec3(0, 0, -3), vec3(1, 2, -3), vec3(-3.9, -3.9, -3) })
  {
    const Hit hit = caster.Cast(vec3(0), glm::normalize(target));
    ASSERT_EQ(hit.Cell, 0);
    EXPECT_NEAR(hit.Distance, glm::length(target), 1e-14);
    const double b1 = (target.x + 4) / 12;
    const double b2 = (target.y + 4) / 12;
    EXPECT_NEAR(hit.Barycentrics.x, 1 - b1 - b2, 1e-14);
    EXPECT_NEAR(hit.Barycentrics.y, b1, 1e-14);
    EXPECT_NEAR(hit.Barycentrics.z, b2, 1e-14);
  }
  EXPECT_EQ(caster.Cast(vec3(0), glm::normalize(vec3(5, 5, -3))).Cell, -1);
  EXPECT_EQ(caster.Cast(vec3(0), vec3(0, 0, 1)).Cell, -1);
}

TEST(RayCaster, ClipSpheres)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(2);
  cube->SetYLength(2);
  cube->SetZLength(2);
  cube->Update();
  const vec3 diagonal = glm::normalize(vec3(1, 1, 1));
  EXPECT_EQ(RayCaster(cube->GetOutput(), SphereBetween(0.1, 1.7), IdentityPose())
              .Cast(vec3(0), diagonal)
              .Cell,
    -1);
  EXPECT_GE(RayCaster(cube->GetOutput(), SphereBetween(0.1, 1.8), IdentityPose())
              .Cast(vec3(0), diagonal)
              .Cell,
    0);
  EXPECT_EQ(RayCaster(cube->GetOutput(), SphereBetween(1.1, 1.8), IdentityPose())
              .Cast(vec3(0), vec3(1, 0, 0))
              .Cell,
    -1);
}

TEST(RayCaster, CellIdsCountVertsAndLinesFirst)
{
  vtkNew<vtkPoints> points;
  const double xyz[][3] = { { -1, -1, -2 }, { 1, -1, -2 }, { 1, 1, -2 }, { -1, 1, -2 },
    { -1, -1, 2 }, { -1, 1, 2 }, { 1, -1, 2 }, { 1, 1, 2 }, { 3, -1, 2 }, { 3, 1, 2 } };
  for (const auto& p : xyz)
  {
    points->InsertNextPoint(p);
  }
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 2 });
  lines->InsertNextCell({ 1, 3 });
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 4, 5, 6, 7, 8, 9 });
  vtkNew<vtkPolyData> polyData;
  polyData->SetPoints(points);
  polyData->SetVerts(verts);
  polyData->SetLines(lines);
  polyData->SetPolys(polys);
  polyData->SetStrips(strips);
  const RayCaster caster(polyData, SphereBetween(0.1, 10), IdentityPose());
  EXPECT_EQ(caster.GetTriangles().Triangles.size(), 6u);
  EXPECT_EQ(caster.Cast(vec3(0), vec3(0, 0, -1)).Cell, 3);
  EXPECT_EQ(caster.Cast(vec3(0), glm::normalize(vec3(0.1, 0.2, -1))).Cell, 3);
  EXPECT_EQ(caster.Cast(vec3(0), vec3(0, 0, 1)).Cell, 4);
  EXPECT_EQ(caster.Cast(vec3(0), glm::normalize(vec3(2.5, 0.5, 2))).Cell, 4);
}

// No ray of a closed mesh falls through, aimed exactly at its vertices and edges, at
// every scale and far from the origin.
TEST(RayCaster, ClosedMeshHasNoGap)
{
  for (double scale : { 1e-6, 1.0, 1e8 })
  {
    for (double far : { 0.0, 1e5 })
    {
      vtkNew<vtkSphereSource> source;
      source->SetRadius(scale);
      source->SetCenter(far * scale, -far * scale, far * scale);
      source->SetThetaResolution(60);
      source->SetPhiResolution(31);
      source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      source->Update();
      const Pose pose = EyeAt(far * scale, -far * scale, (far + 0.25) * scale);
      const RayCaster caster(source->GetOutput(), SphereBetween(1e-3 * scale, 10 * scale), pose);
      const TriangleSoup& soup = caster.GetTriangles();
      for (const auto& t : soup.Triangles)
      {
        for (int k = 0; k < 3; ++k)
        {
          const vec3 a = soup.Points[t[k]];
          const vec3 b = soup.Points[t[(k + 1) % 3]];
          ASSERT_GE(caster.Cast(vec3(0), glm::normalize(a)).Cell, 0) << test::Text(a);
          ASSERT_GE(caster.Cast(vec3(0), glm::normalize(a + b)).Cell, 0) << test::Text(a + b);
          ASSERT_GE(caster.Cast(vec3(0), glm::normalize(a * 0.7 + b * 0.3)).Cell, 0);
        }
      }
    }
  }
}

TEST(RayCaster, PictureIsTopDown)
{
  const RayCaster caster(Sphere(32), SphereBetween(0.01, 10), EyeAt(0, 0.5, 0));
  const HitPicture picture = caster.Render(64, 32);
  // the eye is near the top of the sphere
  EXPECT_NEAR(picture.At(10, 0).Distance, 0.5, 0.01);
  EXPECT_NEAR(picture.At(10, 31).Distance, 1.5, 0.02);
  for (int j : { 3, 17 })
  {
    const Hit one = caster.Cast(PixelToNdc(20.5, j + 0.5, 64, 32));
    EXPECT_EQ(one.Cell, picture.At(20, j).Cell);
    EXPECT_EQ(one.Distance, picture.At(20, j).Distance);
  }
}

TEST(RayCaster, EmptyInputHitsNothing)
{
  vtkNew<vtkPolyData> nothing;
  const RayCaster caster(nothing, SphereBetween(0.1, 10), IdentityPose());
  EXPECT_EQ(caster.Cast(vec2(0, 0)).Cell, -1);
  EXPECT_TRUE(caster.Cast(vec2(0, 0)).InDomain);
}

namespace
{
DrawnPicture Perfect(const HitPicture& p)
{
  DrawnPicture drawn;
  drawn.Width = p.Width;
  drawn.Height = p.Height;
  for (const Hit& hit : p.Hits)
  {
    drawn.Cell.push_back(float(hit.Cell + 1));
    drawn.Distance.push_back(float(hit.Distance));
  }
  return drawn;
}
}

TEST(Metrics, PerfectPictureHasNoError)
{
  const RayCaster caster(Sphere(24), SphereBetween(0.01, 10), EyeAt(0.1, 0.2, 0));
  const HitPicture reference = caster.Render(128, 64);
  const Metrics m = Compare(Perfect(reference), caster, reference, 0.25);
  EXPECT_EQ(m.Mismatched, 0);
  EXPECT_EQ(m.Unexplained, 0);
  EXPECT_EQ(m.MaxPx, 0);
  EXPECT_EQ(m.DomainPixels, 128 * 64);
  EXPECT_LT(m.MaxDepthRel, 1e-7);
}

TEST(Metrics, HolesAndStrangersAreCounted)
{
  const RayCaster caster(Sphere(24), SphereBetween(0.01, 10), EyeAt(0.1, 0.2, 0));
  const HitPicture reference = caster.Render(128, 64);
  DrawnPicture drawn = Perfect(reference);
  drawn.Cell[30 * 128 + 40] = 0; // a hole
  drawn.Distance[31 * 128 + 40] *= 1.5f;
  const Metrics m = Compare(drawn, caster, reference, 0.25);
  EXPECT_EQ(m.UnexplainedPixels, 1);
  EXPECT_DOUBLE_EQ(m.Missing, 1.0 / (128 * 64));
  EXPECT_DOUBLE_EQ(m.Unexplained, m.Missing);
  EXPECT_EQ(m.Spurious, 0);
  // nothing is seen outside the map only, 30 pixels away
  EXPECT_GT(m.MaxPx, 30);
  EXPECT_NEAR(m.MaxDepthRel, 0.5, 1e-6);
  ASSERT_EQ(m.Worst.size(), 1u);
  EXPECT_EQ(m.Worst[0].I, 40);
  EXPECT_EQ(m.Worst[0].J, 30);
}

// A picture shifted by a known part of a pixel is explained at tolerances above it only,
// and the distance found is of its size.
TEST(Metrics, ShiftIsMeasured)
{
  const RayCaster caster(Sphere(24), SphereBetween(0.01, 10), EyeAt(0.1, 0.2, 0));
  const HitPicture reference = caster.Render(128, 64);
  DrawnPicture drawn = Perfect(reference);
  constexpr double Shift = 0.4; // pixels
  for (int j = 0; j < 64; ++j)
  {
    for (int i = 0; i < 127; ++i)
    {
      drawn.Cell[j * 128 + i] =
        float(caster.Cast(PixelToNdc(i + 0.5 + Shift, j + 0.5, 128, 64)).Cell + 1);
    }
  }
  const Metrics narrow = Compare(drawn, caster, reference, 0.1);
  EXPECT_GT(narrow.UnexplainedPixels, 100);
  const Metrics wide = Compare(drawn, caster, reference, 1);
  EXPECT_GT(wide.Mismatched, 100);
  // slivers at the poles may be missed by 48 points
  EXPECT_LT(wide.UnexplainedPixels, wide.Mismatched / 50);
  EXPECT_LE(wide.MaxPx, Shift + 1e-3);
  EXPECT_GT(wide.P99Px, 0.5 * Shift);
}
