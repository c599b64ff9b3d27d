// SPDX-License-Identifier: BSD-3-Clause
// Random meshes by every mapper: what a view leaves out is not in its picture.
#include "CullCrowd.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <CompositeMapper.h>
#include <vtkGlyph3DMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkWideFoVPolyDataMapper.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int Width = 128;
constexpr int Height = 64;
constexpr int Meshes = 48;
constexpr int Crowds = 2;
constexpr int Shots = 4; // a projection and technique

class RandomCrowd : public CullCrowd
{
public:
  explicit RandomCrowd(unsigned int seed)
    : CullCrowd(seed, Width, Height, 0)
  {
    for (int i = 0; i < Meshes; ++i)
    {
      this->Add(this->MakeActor(i % 6));
    }
  }

private:
  // Cells of so many corners: slivers, needles and large ones, from one place on.
  vtkSmartPointer<vtkPolyData> MakeSoup(int corners, int cells)
  {
    const vec3 middle = 5.0 * this->Place();
    const double size = std::pow(10, -1.5 + 1.5 * std::abs(this->Unit()));
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> array;
    for (int i = 0; i < cells; ++i)
    {
      const vec3 at = middle + this->Place();
      array->InsertNextCell(corners);
      for (int j = 0; j < corners; ++j)
      {
        const vec3 p = at + size * this->Place();
        array->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
      }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    corners == 1     ? data->SetVerts(array)
      : corners == 2 ? data->SetLines(array)
                     : data->SetPolys(array);
    return data;
  }

  vtkSmartPointer<vtkMapper> MakeBlocks()
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (unsigned int i = 0; i < 3; ++i)
    {
      blocks->SetBlock(i, this->MakeSoup(3, 20));
    }
    auto mapper = vtkSmartPointer<vtkWideFoVCompositeMapper>::New();
    mapper->SetInputDataObject(blocks);
    return mapper;
  }

  vtkSmartPointer<vtkMapper> MakeGlyphs()
  {
    auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
    mapper->SetInputData(this->MakeSoup(1, 8));
    mapper->SetSourceData(this->MakeSoup(3, 10));
    mapper->SetScaleFactor(0.3);
    return mapper;
  }

  vtkSmartPointer<vtkMapper> MakeMapper(int kind)
  {
    if (kind == 4 || kind == 5)
    {
      return kind == 4 ? this->MakeBlocks() : this->MakeGlyphs();
    }
    vtkSmartPointer<vtkPolyDataMapper> mapper;
    mapper.TakeReference(kind == 0
        ? static_cast<vtkPolyDataMapper*>(vtkWideFoVPolyDataMapper::New())
        : vtkOpenGLPolyDataMapper::New());
    // of its own mapper's some are classified, some are too small for that
    const int cells = kind == 0 && this->Unit() > 0 ? 600 : 40;
    mapper->SetInputData(this->MakeSoup(kind < 2 ? 3 : kind - 1, cells));
    return mapper;
  }

  vtkSmartPointer<vtkActor> MakeActor(int kind)
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(this->MakeMapper(kind));
    vtkProperty* const look = actor->GetProperty();
    const vec3 colour = 0.6 + 0.4 * this->Place();
    look->SetColor(colour.x, colour.y, colour.z);
    look->SetLineWidth(this->Unit() > 0 ? 1 : 3);
    look->SetPointSize(this->Unit() > 0 ? 1 : 5);
    return actor;
  }
};
}

TEST(Culling, ChangesNoPictureOfRandomMeshes)
{
  int left = 0;
  for (unsigned int seed = 1; seed <= Crowds; ++seed)
  {
    RandomCrowd crowd(seed);
    for (const Projection& p : Projections())
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      left += crowd.Compare(p, vtkWideFoVPass::AUTO, Shots).Props;
      // of one crowd: both cull alike, and the pictures take minutes
      left += seed == 1 ? crowd.Compare(p, vtkWideFoVPass::EXACT, Shots).Props : 0;
    }
  }
  std::cout << "props left out " << left << std::endl;
  EXPECT_GT(left, 50);
}
