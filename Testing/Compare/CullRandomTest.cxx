// SPDX-License-Identifier: BSD-3-Clause
// Random meshes by every mapper: what a view leaves out is not in its picture.
#include "DrawingTest.h"
#include "vtkWideFoVPass.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCompositePolyDataMapper2.h>
#include <vtkGlyph3DMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWideFoVCamera.h>
#include <vtkWideFoVPolyDataMapper.h>
#include <vtkWideFoVRenderer.h>

#include <cstring>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int Width = 128;
constexpr int Height = 64;
constexpr int Props = 48;
constexpr int Crowds = 1;
constexpr int Shots = 1; // a projection and technique

class RandomCrowd
{
public:
  explicit RandomCrowd(unsigned int seed)
    : Engine(seed)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Width, Height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetActiveCamera(this->Camera);
    this->Renderer->SetPass(this->Pass);
    for (int i = 0; i < Props; ++i)
    {
      this->Renderer->AddActor(this->MakeActor(i % 6));
    }
  }

  void Point(const Projection& p)
  {
    Shot shot;
    shot.Projection = p.Name;
    const double part = 0.15 + 0.85 * std::abs(this->Unit());
    shot.Options.HorizontalFov = std::max(p.MinHorizontalFov, part * p.MaxHorizontalFov);
    shot.Options.VerticalFov = std::max(p.MinVerticalFov, part * p.MaxVerticalFov);
    shot.Options.Tilt = 90 * this->Unit();
    shot.Options.Radii = { { 0.05 + 0.5 * std::abs(this->Unit()),
      4 + 6 * std::abs(this->Unit()) } };
    shot.Eye = 3.0 * this->Place();
    shot.Direction = glm::normalize(this->Place());
    shot.Up = glm::normalize(vec3(this->Unit(), 1, this->Unit()));
    this->Text = Describe(shot);
    PlaceCamera(this->Camera, shot);
  }

  vtkSmartPointer<vtkUnsignedCharArray> Draw(bool culling)
  {
    this->Pass->SetCulling(culling);
    this->Window->Render();
    auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->Window->GetPixelData(0, 0, Width - 1, Height - 1, 0, pixels);
    return pixels;
  }

  vtkNew<vtkWideFoVPass> Pass;
  std::string Text;

private:
  double Unit() { return this->Distribution(this->Engine); }
  vec3 Place()
  {
    const double x = this->Unit();
    const double y = this->Unit();
    return vec3(x, y, this->Unit());
  }

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
    auto mapper = vtkSmartPointer<vtkCompositePolyDataMapper2>::New();
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
        : vtkPolyDataMapper::New());
    // of its own mapper's some are sorted, some are too small for that
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

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVCamera> Camera;
  std::mt19937_64 Engine;
  std::uniform_real_distribution<double> Distribution{ -1, 1 };
};

// Props left out.
int CompareCrowd(RandomCrowd& crowd, const Projection& p, int technique)
{
  int left = 0;
  crowd.Pass->SetTechnique(technique);
  for (int i = 0; i < Shots; ++i)
  {
    crowd.Point(p);
    const auto whole = crowd.Draw(false);
    EXPECT_EQ(crowd.Pass->GetNumberOfCulledProps(), 0);
    const auto culled = crowd.Draw(true);
    left += crowd.Pass->GetNumberOfCulledProps();
    EXPECT_EQ(std::memcmp(whole->GetPointer(0), culled->GetPointer(0),
                static_cast<std::size_t>(whole->GetNumberOfValues())),
      0)
      << "technique " << technique << ", " << crowd.Text;
  }
  return left;
}
}

TEST(Culling, ChangesNoPictureOfRandomMeshes)
{
  int left = 0;
  for (unsigned int seed = 1; seed <= Crowds; ++seed)
  {
    RandomCrowd crowd(seed);
    for (const Projection& p : Projections())
    {
      if (p.Axis != Family::Planar)
      {
        SCOPED_TRACE("seed " + std::to_string(seed));
        left += CompareCrowd(crowd, p, vtkWideFoVPass::AUTO);
        left += CompareCrowd(crowd, p, vtkWideFoVPass::EXACT);
      }
    }
  }
  std::cout << "props left out " << left << std::endl;
  EXPECT_GT(left, 50);
}
