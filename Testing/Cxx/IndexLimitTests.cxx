// SPDX-License-Identifier: BSD-3-Clause
// Meshes of more than OpenGL counts: one error, and what is beside them is drawn.
#include "BadMeshes.h"
#include "Compat/CompositeMapper.h"
#include "Compat/Reports.h"
#include "Drawables/IndexLimit.h"
#include "Overheard.h"

#include "vtkMultiBlockDataSet.h"

#include <gtest/gtest.h>

using namespace badMesh;

namespace
{
// As if OpenGL counted so far.
struct Most
{
  Most(vtkTypeInt64 points, vtkTypeInt64 indices)
  {
    wfv::ForgetReports();
    wfv::SetMostForTests({ points, indices, false });
  }
  ~Most()
  {
    wfv::SetMostForTests({ wfv::IndexCount::MostPoints, wfv::IndexCount::MostIndices, false });
  }
};
}

TEST(IndexLimit, IndicesAreCountedAsTheyAreDrawn)
{
  Mesh mesh = MakeGlobe(8); // 64 triangles
  const auto triangles = DataOf(mesh);
  EXPECT_EQ(wfv::CountIndices(triangles, VTK_SURFACE).Points, 45);
  EXPECT_EQ(wfv::CountIndices(triangles, VTK_SURFACE).Indices, 3 * 64);
  EXPECT_EQ(wfv::CountIndices(triangles, VTK_WIREFRAME).Indices, 2 * 3 * 64);
  EXPECT_EQ(wfv::CountIndices(triangles, VTK_POINTS).Indices, 3 * 64);
  mesh.Strips = { std::vector<vtkIdType>(1000, 0) };
  EXPECT_EQ(wfv::CountIndices(DataOf(mesh), VTK_SURFACE).Indices, 3 * 998);
  mesh.Polygons = { std::vector<vtkIdType>(2000, 0) };
  EXPECT_EQ(wfv::CountIndices(DataOf(mesh), VTK_SURFACE).Indices, 3 * 1998);
  EXPECT_EQ(wfv::CountIndices(vtkSmartPointer<vtkPolyData>::New(), VTK_SURFACE).Indices, 0);
}

TEST(IndexLimit, MoreThan32BitsCountIsSaid)
{
  const vtkTypeInt64 points = wfv::IndexCount::MostPoints;
  const vtkTypeInt64 indices = wfv::IndexCount::MostIndices;
  EXPECT_EQ(wfv::FindExcess({ points, indices, false }), "");
  EXPECT_NE(wfv::FindExcess({ points + 1, 3, false }).find("4294967297 points"), std::string::npos);
  EXPECT_NE(
    wfv::FindExcess({ 3, indices + 1, false }).find("2147483648 corners"), std::string::npos);
  // 64 GB of points alone, and 715,827,883 triangles
  EXPECT_NE(wfv::FindExcess({ 5500000000, 3, false }), "");
  EXPECT_NE(wfv::FindExcess({ 3, 3 * vtkTypeInt64(715827883), false }), "");
}

// Once, and what is beside it is drawn.
TEST(IndexLimit, MoreThanCanBeCountedIsNotDrawn)
{
  const Mesh small = MakeGlobe(8);
  const Mesh large = MakeGlobe(24);
  for (const Way& way : EveryWay())
  {
    SCOPED_TRACE(way.Name());
    const auto wanted = Scene(way, DataOf(small)).Draw();
    for (const bool points : { false, true })
    {
      const Most most(points ? 100 : 1000000, points ? 1000000 : 1000);
      const Overheard vtk;
      Scene scene(way, DataOf(small));
      Scene other(way, DataOf(large));
      scene.Test.Renderer->AddActor(other.Actor);
      EXPECT_EQ(scene.Draw(), wanted);
      scene.Test.Camera->Yaw(10);
      scene.Draw();
      EXPECT_EQ(vtk.Count("ERROR"), 1) << vtk.All();
      EXPECT_EQ(vtk.Count("draw it in parts"), 1) << vtk.All();
    }
  }
}

TEST(IndexLimit, BlocksAreCountedTogether)
{
  const Most most(1000000, 1000);
  const Overheard vtk;
  Scene scene({}, DataOf(MakeGlobe(8)));
  const auto wanted = scene.Draw();
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 6; i++) // 192 indices each
  {
    blocks->SetBlock(i, DataOf(MakeGlobe(8)));
  }
  vtkNew<vtkWideFoVCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetScale(0.5);
  scene.Test.Renderer->AddActor(actor);
  EXPECT_EQ(scene.Draw(), wanted);
  EXPECT_EQ(vtk.Count("ERROR"), 1) << vtk.All();
}

// Without a pass, too: the mapper by itself.
TEST(IndexLimit, OurMapperByItselfLeavesItOutToo)
{
  const Most most(1000000, 1000);
  const Overheard vtk;
  Scene scene({}, DataOf(MakeGlobe(24)));
  scene.Test.Renderer->SetPass(nullptr);
  EXPECT_EQ(CountDrawn(scene.Draw()), 0);
  scene.Test.Camera->Yaw(10);
  EXPECT_EQ(CountDrawn(scene.Draw()), 0);
  EXPECT_EQ(vtk.Count("ERROR"), 1) << vtk.All();
}
