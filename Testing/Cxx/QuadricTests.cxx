// SPDX-License-Identifier: BSD-3-Clause
// Balls under what else VTK does with them: selection, clipping planes, translucency,
// multisampling, culling, clip radii.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
// x, y, z and radius, seen from (0.1, 0.05, 0.07)
using BallList = std::vector<std::array<double, 4>>;

vtkSmartPointer<vtkPolyData> Points(const BallList& balls)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkFloatArray> radii;
  radii->SetName("radius");
  for (const auto& b : balls)
  {
    const vtkIdType id = points->InsertNextPoint(b.data());
    verts->InsertNextCell(1, &id);
    radii->InsertNextValue(static_cast<float>(b[3]));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(verts);
  data->GetPointData()->AddArray(radii);
  return data;
}

// Unlit, white.
vtkSmartPointer<vtkActor> BallActor(const BallList& balls)
{
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(Points(balls));
  mapper->SetScaleArray("radius");
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

struct BallWindow : WideFoVTestWindow
{
  explicit BallWindow(const BallList& balls, const char* projection = "equirectangular")
    : WideFoVTestWindow(projection, 200, 100)
    , Actor(BallActor(balls))
  {
    this->Renderer->SetBackground(0, 0, 0);
    this->Renderer->AddActor(this->Actor);
  }

  // Of the pixel that the place is drawn at, after a frame.
  int Level(double x, double y, double z)
  {
    this->Window->Render();
    this->Renderer->SetWorldPoint(x, y, z, 1);
    this->Renderer->WorldToDisplay();
    double d[3];
    this->Renderer->GetDisplayPoint(d);
    return TestPixels(this->Window).At(static_cast<int>(d[0]), static_cast<int>(d[1]))[0];
  }

  vtkSmartPointer<vtkActor> Actor;
};

// What is selected in the whole window, sorted.
std::vector<vtkIdType> SelectAll(BallWindow& test, int association)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(test.Renderer);
  selector->SetFieldAssociation(association);
  selector->SetArea(0, 0, 199, 99);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  std::vector<vtkIdType> ids;
  if (selection && selection->GetNumberOfNodes() == 1)
  {
    auto* list = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
    ids.assign(list->GetPointer(0), list->GetPointer(0) + list->GetNumberOfValues());
    std::sort(ids.begin(), ids.end());
  }
  return ids;
}

// Ahead, overhead, on the seam behind, and one hidden by the first.
const BallList Four{ { 0.1, 0, -2, 0.5 }, { 0.2, 2, 0, 0.4 }, { 0.1, 0.1, 2, 0.3 },
  { 0.1, 0, -4, 0.2 } };
}

TEST(Quadrics, SelectionIsTheBallThatIsSeen)
{
  const std::vector<vtkIdType> seen{ 0, 1, 2 };
  for (const char* projection : { "equirectangular", "hammer", "azimuthal-equidistant" })
  {
    BallWindow test(Four, projection);
    test.Window->Render();
    EXPECT_EQ(SelectAll(test, vtkDataObject::FIELD_ASSOCIATION_CELLS), seen) << projection;
    EXPECT_EQ(SelectAll(test, vtkDataObject::FIELD_ASSOCIATION_POINTS), seen) << projection;
  }
}

TEST(Quadrics, AClippingPlaneTakesTheBallsWhoseCentresAreBeyond)
{
  BallWindow test(Four);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, 1, 0);
  plane->SetNormal(0, -1, 0);
  test.Actor->GetMapper()->AddClippingPlane(plane);
  EXPECT_EQ(test.Level(0.1, 0, -2), 255);
  EXPECT_EQ(test.Level(0.2, 2, 0), 0);
}

TEST(Quadrics, ATranslucentBallHasAFrontAndABack)
{
  BallWindow test(Four);
  // without scalars the stock mapper takes the opacity twice: a quarter a layer
  test.Actor->GetProperty()->SetOpacity(0.5);
  EXPECT_NEAR(test.Level(0.1, 0.1, 2), 112, 1);
  // only the back of one that holds the eye, over nothing
  BallWindow inside({ { 0.1, 0.05, 0, 1 } });
  inside.Actor->GetProperty()->SetOpacity(0.5);
  EXPECT_NEAR(inside.Level(0.1, 0.1, 2), 64, 1);
}

TEST(Quadrics, AnOpaqueBallRoundTheEyeShowsItsInsideUnlessItIsCulled)
{
  BallWindow test({ { 0.1, 0.05, 0, 1 } });
  EXPECT_EQ(test.Level(0.1, 0.1, 2), 255);
  EXPECT_EQ(test.Level(0.1, 2, 0), 255);
  test.Actor->GetProperty()->BackfaceCullingOn();
  EXPECT_EQ(test.Level(0.1, 0.1, 2), 0);
  BallWindow outside(Four);
  outside.Actor->GetProperty()->BackfaceCullingOn();
  EXPECT_EQ(outside.Level(0.1, 0.1, 2), 255);
}

TEST(Quadrics, AutomaticClipRadiiHoldTheWholeBall)
{
  // alone and outside the eye: the bounds are one point
  BallWindow test({ { 0.1, 0.05, -3, 2.5 } });
  EXPECT_EQ(test.Level(0.1, 0.05, -3), 255);
  EXPECT_EQ(test.Level(0.1 + 2.4, 0.05, -3), 255);
  double radii[2];
  test.Camera->GetClipRadii(radii);
  EXPECT_LT(radii[0], 0.57);
  EXPECT_GT(radii[1], 5.57);
}

TEST(Quadrics, MultisampledEdgesHaveTheAreaOfTheBall)
{
  double sum[2];
  for (int samples : { 0, 4 })
  {
    WideFoVTestWindow test("equirectangular", 400, 200);
    test.Window->SetMultiSamples(samples);
    test.Renderer->SetBackground(0, 0, 0);
    test.Renderer->AddActor(BallActor({ { 0.1, 0.05, -1.93, 0.03 } }));
    test.Window->Render();
    const TestPixels pixels(test.Window);
    double total = 0;
    int between = 0;
    for (int i = 0; i < 400 * 200; i++)
    {
      const int level = pixels.At(i % 400, i / 400)[0];
      total += level / 255.0;
      between += level > 0 && level < 255;
    }
    sum[samples > 0] = total;
    EXPECT_EQ(between > 0, samples > 0);
  }
  // asin(0.03 / 2) in pixels of 0.9 degrees
  const double radius = std::asin(0.015) / (2 * 3.14159265358979323846 / 400);
  EXPECT_NEAR(sum[1], 3.14159265358979323846 * radius * radius, 0.15);
}

TEST(Quadrics, GaussiansWithoutARadiusArePoints)
{
  WideFoVTestWindow test("hammer", 200, 100);
  test.Renderer->SetBackground(0, 0, 0);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(Points(Four));
  mapper->SetScaleFactor(0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetPointSize(3);
  test.Renderer->AddActor(actor);
  test.Window->Render();
  const TestPixels pixels(test.Window);
  int lit = 0;
  for (int i = 0; i < 200 * 100; i++)
  {
    lit += pixels.At(i % 200, i / 200)[0] > 0;
  }
  EXPECT_GT(lit, 12);
  EXPECT_LT(lit, 60);
}
