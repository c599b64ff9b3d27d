// SPDX-License-Identifier: BSD-3-Clause
// Meshes that nobody would make on purpose: points that are no numbers, cells of thousands of
// corners and of too few, and data that are others in each frame. What can be drawn of them is
// drawn as if the rest were not there, and nothing is said of it.
#include "BadMeshes.h"
#include "Compat/Reports.h"
#include "Overheard.h"

#include <gtest/gtest.h>

#include <ctime>
#include <iostream>

using namespace badMesh;

namespace
{
// Drawn in every way as the other one, which is no bad mesh, and nothing is said.
void ExpectDrawnAs(const Mesh& bad, const Mesh& good, const char* what)
{
  for (const Way& way : EveryWay())
  {
    SCOPED_TRACE(std::string(what) + ", " + way.Name());
    const Overheard vtk;
    const auto wanted = Scene(way, DataOf(good, way.Type)).Draw();
    EXPECT_GT(CountDrawn(wanted), 250);
    const auto drawn = Scene(way, DataOf(bad, way.Type)).Draw();
    EXPECT_EQ(CountDrawn(drawn), CountDrawn(wanted));
    EXPECT_TRUE(drawn == wanted) << CountOthers(drawn, wanted) << " other pixels";
    EXPECT_EQ(vtk.All(), "");
  }
}
}

namespace
{
// Every 97th triangle has a corner of which a coordinate is this; or has a collapsed one.
Mesh Spoil(const Mesh& good, double no, bool collapsed)
{
  Mesh bad = good;
  for (size_t i = 0; i < good.Polygons.size(); i += 97)
  {
    const auto& cell = good.Polygons[i];
    Corner p = good.Points[cell[(i + (collapsed ? 1 : 0)) % 3]];
    p[i % 2] = collapsed ? p[i % 2] : no;
    bad.Polygons[i][i % 3] = static_cast<vtkIdType>(bad.Points.size());
    bad.Points.push_back(p);
  }
  return bad;
}
}

TEST(BadMesh, PointsThatAreNoNumbersTakeTheirTrianglesAlone)
{
  // where the view looks, at its rim, at a pole
  const Mesh good = MakeGlobe(48);
  ExpectDrawnAs(Spoil(good, NaN, false), Spoil(good, NaN, true), "NaN");
}

// VTK's renderer leaves out a prop whose bounds are infinite; what is beside it is drawn.
TEST(BadMesh, AnInfinitePointTakesNoOtherProp)
{
  const Mesh good = MakeGlobe(48);
  for (const double no : { Infinite, -Infinite })
  {
    for (const Way& way : EveryWay())
    {
      SCOPED_TRACE(way.Name());
      const Overheard vtk;
      const auto wanted = Scene(way, DataOf(good, way.Type)).Draw();
      Scene scene(way, DataOf(good, way.Type));
      Scene other(way, DataOf(Spoil(good, no, false), way.Type));
      other.Actor->SetScale(3); // behind it, were it drawn
      scene.Test.Renderer->AddActor(other.Actor);
      const auto drawn = scene.Draw();
      EXPECT_TRUE(drawn == wanted) << CountOthers(drawn, wanted) << " other pixels";
      EXPECT_EQ(vtk.All(), "");
    }
  }
}

// It has no direction.
TEST(BadMesh, ACornerAtTheEyeIsNoError)
{
  Mesh mesh = MakeGlobe(48);
  const auto eye = static_cast<vtkIdType>(mesh.Points.size());
  for (size_t i = 0; i < mesh.Polygons.size(); i += 97)
  {
    mesh.Polygons[i][i % 3] = eye;
  }
  for (const Way& way : EveryWay())
  {
    SCOPED_TRACE(way.Name());
    const Overheard vtk;
    WideFoVTestWindow any("equirectangular", 8, 4);
    double at[3];
    any.Camera->GetPosition(at);
    mesh.Points.resize(static_cast<size_t>(eye));
    mesh.Points.push_back({ at[0], at[1], at[2] });
    EXPECT_GT(CountDrawn(Scene(way, DataOf(mesh, way.Type)).Draw()), 5000);
    EXPECT_EQ(vtk.All(), "");
  }
}

TEST(BadMesh, AllPointsThatAreNoNumbersAreNothing)
{
  for (const double no : { NaN, Infinite })
  {
    Mesh mesh = MakeGlobe(24);
    for (Corner& p : mesh.Points)
    {
      p = { no, no, no };
    }
    for (const Way& way : EveryWay())
    {
      SCOPED_TRACE(way.Name());
      const Overheard vtk;
      EXPECT_EQ(CountDrawn(Scene(way, DataOf(mesh, way.Type)).Draw()), 0);
      EXPECT_EQ(vtk.All(), "");
    }
  }
}

TEST(BadMesh, PolygonsOfManyCornersAreTheirFans)
{
  // round caps before, behind and above the eye, beside the middle, with a hole between them
  Mesh polygons;
  Mesh fans;
  for (const int corners : { 4, 5, 17, 4001 })
  {
    const auto first = static_cast<vtkIdType>(polygons.Points.size());
    std::vector<vtkIdType> cell;
    for (int i = 0; i < corners; i++)
    {
      const double angle = 2 * M_PI * i / corners;
      const double away = corners == 4001 ? 1.5 : corners == 17 ? -1.2 : 0.2;
      polygons.Points.push_back(
        { corners == 5 ? 1.4 : std::cos(angle), std::sin(angle) + (corners == 4 ? 2 : 0),
          corners == 5 ? std::cos(angle) : away + 0.2 * std::cos(angle) });
      cell.push_back(first + i);
      if (i > 1)
      {
        fans.Polygons.push_back({ first, first + i - 1, first + i });
      }
    }
    polygons.Polygons.push_back(cell);
  }
  fans.Points = polygons.Points;
  ExpectDrawnAs(polygons, fans, "polygons");
}

TEST(BadMesh, StripsOfManyCornersAreTheirTriangles)
{
  Mesh strips;
  Mesh triangles;
  std::vector<vtkIdType> cell;
  for (int i = 0; i < 6000; i++)
  {
    const vtkIdType n = i;
    strips.Points.push_back(Round(2 * M_PI * i / 1500, 0.6 * i / 6000 + (i % 2 ? 0.15 : 0) - 0.4));
    cell.push_back(n);
    if (i > 1)
    {
      triangles.Polygons.push_back(i % 2 ? std::vector<vtkIdType>{ n - 2, n, n - 1 }
                                         : std::vector<vtkIdType>{ n - 2, n - 1, n });
    }
  }
  strips.Strips = { cell };
  triangles.Points = strips.Points;
  ExpectDrawnAs(strips, triangles, "a strip");
}

TEST(BadMesh, CellsOfTooFewCornersAreNothing)
{
  const Mesh good = MakeGlobe(24);
  Mesh bad = good;
  for (vtkIdType i = 0; i < 3000; i++) // more than there are triangles
  {
    bad.Polygons.insert(bad.Polygons.begin(),
      i % 3 == 0     ? std::vector<vtkIdType>{ i % 100 }
        : i % 3 == 1 ? std::vector<vtkIdType>{ i % 100, i % 77 }
                     : std::vector<vtkIdType>());
  }
  ExpectDrawnAs(bad, good, "polygons");
}

// VTK itself makes room for less than nothing of these, which throws.
TEST(BadMesh, StripsOfTooFewCornersAreSaid)
{
  Mesh strips;
  strips.Points = MakeGlobe(8).Points;
  strips.Strips.assign(1000, { 0 });
  for (const Way& way : EveryWay())
  {
    SCOPED_TRACE(way.Name());
    wfv::ForgetReports();
    const Overheard vtk;
    Scene scene(way, DataOf(strips));
    EXPECT_EQ(CountDrawn(scene.Draw()), 0);
    scene.Test.Camera->Yaw(10);
    EXPECT_EQ(CountDrawn(scene.Draw()), 0);
    EXPECT_EQ(vtk.Count("ERROR"), 1) << vtk.All();
    EXPECT_EQ(vtk.Count("fewer than two points"), 1) << vtk.All();
  }
}

namespace
{
// The globe, its radii another one in each frame.
void Breathe(vtkPolyData* data, const Mesh& mesh, int frame)
{
  vtkPoints* const points = data->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); i++)
  {
    Corner p = mesh.Points[i];
    const double radius = 1 + 0.3 * std::sin(5 * p[0] + 3 * p[1] + 0.7 * frame);
    points->SetPoint(i, radius * p[0], radius * p[1], radius * p[2]);
  }
  points->Modified();
}
}

// A time series: nothing is kept of the frame before.
TEST(BadMesh, AnotherOneInEachFrameIsDrawnAsAnew)
{
  const Mesh globe = MakeGlobe(64);
  for (const Way& way : EveryWay())
  {
    SCOPED_TRACE(way.Name());
    const Overheard vtk;
    const auto data = DataOf(globe, way.Type);
    Scene series(way, data);
    for (int frame = 0; frame < 4; frame++)
    {
      Breathe(data, globe, frame);
      Mesh fewer = globe;
      fewer.Polygons.resize(globe.Polygons.size() - 300 * static_cast<size_t>(frame));
      data->SetPolys(CellsOf(fewer.Polygons));
      const auto fresh = vtkSmartPointer<vtkPolyData>::New();
      fresh->DeepCopy(data);
      EXPECT_EQ(series.Draw(), Scene(way, fresh).Draw()) << "frame " << frame;
    }
    EXPECT_EQ(vtk.All(), "");
  }
}

// Of the processor's time: a fifth of what such a frame takes at the most, in which stock VTK makes
// new buffers as well. Each by the least of several, for other work only adds.
TEST(BadMesh, ClustersOfASeriesTakeAFifthOfAFrameAtTheMost)
{
  const Mesh globe = MakeGlobe(600);
  const auto data = DataOf(globe);
  Scene series({}, data);
  series.Draw();
  double frames = Infinite;
  double clusters = Infinite;
  for (int i = 0; i < 8; i++)
  {
    Breathe(data, globe, i);
    const double before = series.Test.Pass()->GetClusterTime();
    const std::clock_t start = std::clock();
    series.Test.Window->Render();
    series.Test.Window->WaitForCompletion();
    frames = std::min(frames, double(std::clock() - start) / CLOCKS_PER_SEC);
    clusters = std::min(clusters, series.Test.Pass()->GetClusterTime() - before);
  }
  std::cout << "360,000 triangles, in milliseconds: frames " << 1e3 * frames << ", clusters "
            << 1e3 * clusters << "\n";
  EXPECT_GT(clusters, 0);
  EXPECT_LE(clusters, frames / 5);
}
