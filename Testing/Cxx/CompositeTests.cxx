// SPDX-License-Identifier: BSD-3-Clause
// Composite data under the pass are drawn as their blocks are, and classified block by block where
// VTK lets them; text in the scene stands at its place.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "Compat/CompositeMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace
{
constexpr int Blocks = 5;
constexpr int PartsWidth = 400;
constexpr int PartsHeight = 200;

vtkSmartPointer<vtkPolyData> MakeBlock(int i)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(80);
  sphere->SetPhiResolution(80);
  sphere->SetCenter(3 * std::sin(1.3 * i), 0.4 * i - 0.8, 3 * std::cos(1.3 * i));
  sphere->SetRadius(0.9);
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkActor> MakeActor(vtkMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.5, 0.2);
  return actor;
}

void AddBlocks(vtkRenderer* renderer, bool composite)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < Blocks; i++)
  {
    blocks->SetBlock(i, MakeBlock(i));
    if (!composite)
    {
      vtkNew<vtkWideFoVPolyDataMapper> mapper;
      mapper->SetInputData(MakeBlock(i));
      renderer->AddActor(MakeActor(mapper));
    }
  }
  if (composite)
  {
    vtkNew<vtkWideFoVCompositeMapper> mapper;
    mapper->SetInputDataObject(blocks);
    renderer->AddActor(MakeActor(mapper));
  }
}

struct DrawnBlocks
{
  vtkSmartPointer<vtkUnsignedCharArray> Pixels;
  int Clusters;
};

DrawnBlocks Draw(bool composite, bool twice)
{
  WideFoVTestWindow test("equirectangular", PartsWidth, PartsHeight);
  AddBlocks(test.Renderer, composite);
  test.Window->Render();
  if (twice)
  {
    test.Window->Render();
  }
  return { TestPixels(test.Window).Data, test.Pass()->GetNumberOfClusters() };
}

// Colours of the cells: rows of the sphere.
void ColorCells(vtkPolyData* mesh)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); i++)
  {
    const auto shade = static_cast<unsigned char>(i % 256);
    const unsigned char color[3] = { shade, 128, 255 };
    colors->InsertNextTypedTuple(color);
  }
  mesh->GetCellData()->SetScalars(colors);
}

// Block 0 red, 1 hidden, 2 translucent, 3 with colours of its cells, 4 as it is.
vtkSmartPointer<vtkActor> MakeVariedBlock(int i)
{
  auto mesh = MakeBlock(i);
  vtkNew<vtkWideFoVPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  auto actor = MakeActor(mapper);
  if (i == 0)
  {
    actor->GetProperty()->SetColor(1, 0, 0);
  }
  if (i == 3)
  {
    ColorCells(mesh);
  }
  actor->SetVisibility(i != 1);
  actor->GetProperty()->SetOpacity(i == 2 ? 0.4 : 1);
  return actor;
}

vtkSmartPointer<vtkActor> MakeVariedBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < Blocks; i++)
  {
    auto mesh = MakeBlock(i);
    if (i == 3)
    {
      ColorCells(mesh);
    }
    blocks->SetBlock(i, mesh);
  }
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  vtkNew<vtkWideFoVCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetBlockColor(1, 1, 0, 0); // flat indices: the root is 0
  mapper->SetBlockVisibility(2, false);
  mapper->SetBlockOpacity(3, 0.4);
  return MakeActor(mapper);
}

DrawnBlocks DrawVaried(bool composite)
{
  WideFoVTestWindow test("equirectangular", PartsWidth, PartsHeight);
  for (int i = 0; i < (composite ? 0 : Blocks); i++)
  {
    test.Renderer->AddActor(MakeVariedBlock(i));
  }
  if (composite)
  {
    test.Renderer->AddActor(MakeVariedBlocks());
  }
  test.Window->Render();
  return { TestPixels(test.Window).Data, test.Pass()->GetNumberOfClusters() };
}

// Block and cell at every pixel, by the hardware selector; -1 where there is none.
using Selected = std::pair<int, vtkIdType>;

std::vector<Selected> SelectAll(bool composite)
{
  WideFoVTestWindow test("equirectangular", PartsWidth, PartsHeight);
  AddBlocks(test.Renderer, composite);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(test.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(0, 0, PartsWidth - 1, PartsHeight - 1);
  selector->CaptureBuffers();
  std::vector<Selected> all;
  for (unsigned int i = 0; i < PartsWidth * PartsHeight; i++)
  {
    const unsigned int place[2] = { i % PartsWidth, i / PartsWidth };
    const vtkHardwareSelector::PixelInformation found = selector->GetPixelInformation(place);
    const int block = composite ? static_cast<int>(found.CompositeID) - 1 : found.PropID;
    all.push_back(found.Valid ? Selected(block, found.AttributeID) : Selected(-1, -1));
  }
  return all;
}

int CountDifferent(const DrawnBlocks& a, const DrawnBlocks& b)
{
  int n = 0;
  for (vtkIdType i = 0; i < a.Pixels->GetNumberOfValues(); i++)
  {
    n += std::abs(a.Pixels->GetValue(i) - b.Pixels->GetValue(i)) > 1;
  }
  return n;
}
}

TEST(Composite, BlocksAreDrawnAsOwnMappersAre)
{
  const DrawnBlocks own = Draw(false, false);
  const DrawnBlocks blocks = Draw(true, false);
  EXPECT_GT(own.Clusters, 100);
  EXPECT_EQ(blocks.Clusters, own.Clusters);
  EXPECT_EQ(CountDifferent(blocks, own), 0);
  EXPECT_EQ(CountDifferent(Draw(true, true), own), 0);
  const unsigned char* const pixels = own.Pixels->GetPointer(0);
  EXPECT_GT(std::count_if(pixels, pixels + own.Pixels->GetNumberOfValues(),
              [](unsigned char c) { return c > 50; }),
    PartsWidth * PartsHeight / 10);
}

// One block red, one hidden, one translucent and one coloured by its cells: as actors of their own.
TEST(Composite, BlocksKeepWhatIsSetOfEach)
{
  const DrawnBlocks blocks = DrawVaried(true);
  EXPECT_EQ(CountDifferent(blocks, DrawVaried(false)), 0);
  EXPECT_GT(CountDifferent(blocks, Draw(true, false)), PartsWidth * PartsHeight / 20);
}

// The block and the cell of it that are selected are those that are seen, all round.
TEST(Composite, TheSeenCellIsSelected)
{
  const std::vector<Selected> expected = SelectAll(false);
  EXPECT_EQ(SelectAll(true), expected);
  for (int i = 0; i < Blocks; i++)
  {
    EXPECT_GT(std::count_if(
                expected.begin(), expected.end(), [i](const Selected& s) { return s.first == i; }),
      100);
  }
}

TEST(Billboards, StandWhereTheirPlaceIsShown)
{
  WideFoVTestWindow test("hammer", PartsWidth, PartsHeight);
  vtkNew<vtkBillboardTextActor3D> text;
  text->SetInput("MM");
  test.Renderer->AddActor(text);
  double eye[3];
  test.Camera->GetPosition(eye);
  for (const auto& to : { std::vector<double>{ 2, 1, -3 }, { -3, -1, 1 }, { -1, 2, 2 } })
  {
    const double place[3] = { eye[0] + to[0], eye[1] + to[1], eye[2] + to[2] };
    text->SetPosition(place[0], place[1], place[2]);
    test.Window->Render();
    double ndc[3];
    ASSERT_TRUE(test.Camera->WorldToNDC(place, double(PartsWidth) / PartsHeight, ndc));
    TestPixels pixels(test.Window);
    int left = PartsWidth;
    int low = PartsHeight;
    int high = -1;
    for (int i = 0; i < PartsWidth * PartsHeight; i++)
    {
      if (pixels.At(i % PartsWidth, i / PartsWidth)[0] > 128)
      {
        left = std::min(left, i % PartsWidth);
        low = std::min(low, i / PartsWidth);
        high = std::max(high, i / PartsWidth);
      }
    }
    EXPECT_NEAR(left, 0.5 * (ndc[0] + 1) * PartsWidth, 5);
    EXPECT_NEAR(low, 0.5 * (ndc[1] + 1) * PartsHeight, 6);
    EXPECT_GT(high - low, 5);
    EXPECT_LT(high - low, 30);
  }
}

// Lights of the scene shine on where the camera looks from one side alone.
TEST(Billboards, HaveTheColorThatTheyAreTold)
{
  WideFoVTestWindow test("hammer", PartsWidth, PartsHeight);
  vtkNew<vtkBillboardTextActor3D> text;
  text->SetInput("MM");
  text->GetTextProperty()->SetColor(1, 1, 1);
  test.Renderer->AddActor(text);
  test.Renderer->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  test.Renderer->AddLight(light);
  double eye[3];
  test.Camera->GetPosition(eye);
  for (const double side : { -1., 1. })
  {
    text->SetPosition(eye[0] + 1, eye[1], eye[2] + 3 * side);
    light->SetPosition(eye);
    light->SetFocalPoint(text->GetPosition());
    test.Window->Render();
    const TestPixels pixels(test.Window);
    int brightest = 0;
    for (int i = 0; i < PartsWidth * PartsHeight; i++)
    {
      brightest = std::max<int>(brightest, pixels.At(i % PartsWidth, i / PartsWidth)[0]);
    }
    EXPECT_GT(brightest, 250) << side;
  }
}
