// SPDX-License-Identifier: BSD-3-Clause
// Composite data under the pass are sorted block by block; text in the scene stands at its place.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkWideFoVCompositeMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
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

struct Drawn
{
  vtkSmartPointer<vtkUnsignedCharArray> Pixels;
  int Clusters;
};

Drawn Draw(bool composite, bool twice)
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

int CountDifferent(const Drawn& a, const Drawn& b)
{
  int n = 0;
  for (vtkIdType i = 0; i < a.Pixels->GetNumberOfValues(); i++)
  {
    n += std::abs(a.Pixels->GetValue(i) - b.Pixels->GetValue(i)) > 1;
  }
  return n;
}
}

TEST(Composite, BlocksAreSortedAsOwnMappersAre)
{
  const Drawn own = Draw(false, false);
  const Drawn blocks = Draw(true, false);
  EXPECT_GT(own.Clusters, 100);
  EXPECT_EQ(blocks.Clusters, own.Clusters);
  EXPECT_EQ(CountDifferent(blocks, own), 0);
  EXPECT_EQ(CountDifferent(Draw(true, true), own), 0);
  const unsigned char* const pixels = own.Pixels->GetPointer(0);
  EXPECT_GT(std::count_if(pixels, pixels + own.Pixels->GetNumberOfValues(),
              [](unsigned char c) { return c > 50; }),
    PartsWidth * PartsHeight / 10);
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
