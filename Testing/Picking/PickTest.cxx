// SPDX-License-Identifier: BSD-3-Clause
// VTK's own pickers find what is drawn at a pixel, all round and in each eye.
#include "PickScene.h"

#include "Compat/Reports.h"

#include <vtkAreaPicker.h>
#include <vtkCell.h>
#include <vtkCellPicker.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>
#include <vtkOutputWindow.h>
#include <vtkPointPicker.h>
#include <vtkProp3DCollection.h>
#include <vtkRenderedAreaPicker.h>
#include <vtkStringOutputWindow.h>
#include <vtkWideFoVCellPicker.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Of a projection: 10,000 in all, most of them in the middle.
int CountPixels(const PickView& view)
{
  return view.Which == Eye::Middle ? 6000 : 2000;
}

// Pixels. A cell picker thickens cells by a millionth of the picture's diagonal (its Tolerance), as
// far as the middle of the scene.
constexpr double PickedSlack = 0.02;

// Five maps, in the middle and of each eye; the seam of the tilted one is off the middle.
std::vector<PickView> Views()
{
  std::vector<PickView> views;
  for (Eye eye : { Eye::Middle, Eye::Left, Eye::Right })
  {
    views.push_back({ "equirectangular", eye });
    views.push_back({ "hammer", eye });
    views.push_back({ "azimuthal-equidistant", eye });
    views.push_back({ "mercator", eye });
    views.push_back({ "equirectangular", eye, 70 });
  }
  return views;
}

class RandomPixels
{
public:
  double X() { return this->Column(this->Engine) + 0.5; }
  double Y() { return this->Row(this->Engine) + 0.5; }

private:
  std::mt19937 Engine{ 41 };
  std::uniform_int_distribution<int> Column{ 0, PickScene::Width - 1 };
  std::uniform_int_distribution<int> Row{ 0, PickScene::Height - 1 };
};

// Counts what is wrong, and keeps the first place.
struct Count
{
  int Wrong = 0;
  int Seen = 0;
  std::string First;

  void Add(const PickScene& scene, double x, double y, double slack, const PickedCell& picked)
  {
    this->Seen += picked.Prop ? 1 : 0;
    if (!scene.SeesNear(x, y, slack, picked))
    {
      const PickedCell seen = scene.See(x, y);
      this->Wrong++;
      this->First = this->Wrong > 1 ? this->First
                                    : "at " + std::to_string(x) + "," + std::to_string(y) +
          " cell " + std::to_string(picked.Cell) + ", not " + std::to_string(seen.Cell) +
          (picked.Prop == seen.Prop ? "" : " of another prop");
    }
  }
};

PickedCell Pick(vtkCellPicker* picker, double x, double y, vtkRenderer* renderer)
{
  picker->Pick(x, y, 0, renderer);
  return { picker->GetViewProp(), picker->GetViewProp() ? picker->GetCellId() : -1 };
}

void ExpectCells(vtkCellPicker* picker, int share = 1)
{
  for (const PickView& view : Views())
  {
    PickScene scene(view);
    const int pixelCount = CountPixels(view) / share;
    RandomPixels pixels;
    Count count;
    for (int i = 0; i < pixelCount; i++)
    {
      const double x = pixels.X();
      const double y = pixels.Y();
      count.Add(scene, x, y, PickedSlack, Pick(picker, x, y, scene.Renderer));
    }
    EXPECT_EQ(count.Wrong, 0) << picker->GetClassName() << ", " << Describe(view) << ": "
                              << count.First;
    EXPECT_GT(count.Seen, pixelCount / 4) << Describe(view);
  }
}
}

TEST(Picking, ACellPickerFindsTheCellThatIsSeen)
{
  ExpectCells(vtkNew<vtkCellPicker>());
}

TEST(Picking, SoDoesTheOneOfWideViews)
{
  ExpectCells(vtkNew<vtkWideFoVCellPicker>(), 10);
}

namespace
{
// Where a place of the world is seen, pixels and depth.
void ShowAt(const PickScene& scene, const double world[3], double display[3])
{
  scene.Renderer->SetWorldPoint(world[0], world[1], world[2], 1);
  scene.Renderer->WorldToDisplay();
  scene.Renderer->GetDisplayPoint(display);
}
}

// Corners that nothing hides, each at the place of the picture where it is seen.
TEST(Picking, APointPickerFindsThePointThatIsSeen)
{
  std::vector<PickView> views = Views();
  views.resize(5); // those of the middle
  for (const PickView& view : views)
  {
    PickScene scene(view);
    vtkNew<vtkPointPicker> picker;
    picker->SetTolerance(1e-4);
    int seen = 0;
    for (const auto& body : scene.GetBodies())
    {
      vtkDataSet* const mesh = body->GetMapper()->GetInput();
      for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); id += 7)
      {
        double p[3];
        double at[3];
        mesh->GetPoint(id, p);
        ShowAt(scene, p, at);
        const PickedCell cell = scene.See(at[0], at[1]);
        if (cell.Prop != body || mesh->GetCell(cell.Cell)->GetPointIds()->IsId(id) < 0)
        {
          continue;
        }
        seen++;
        picker->Pick(at[0], at[1], 0, scene.Renderer);
        ASSERT_GE(picker->GetPointId(), 0) << Describe(view) << " at " << at[0] << "," << at[1];
        // of several behind one another any
        double found[3];
        picker->GetDataSet()->GetPoint(picker->GetPointId(), found);
        double d[3];
        ShowAt(scene, found, d);
        EXPECT_LT(std::hypot(d[0] - at[0], d[1] - at[1]), 0.5)
          << Describe(view) << " at " << at[0] << "," << at[1];
      }
    }
    EXPECT_GT(seen, 50) << Describe(view);
  }
}

namespace
{
// What an area picker finds in a square of so many pixels to each side of a place of the picture,
// and whether a warning was said by the next frame.
struct AreaFound
{
  bool Body;
  bool Warned;
};

AreaFound PickArea(
  PickScene& scene, vtkAreaPicker* picker, vtkActor* body, const double at[2], double half)
{
  ForgetReports();
  vtkNew<vtkStringOutputWindow> heard;
  const vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkOutputWindow::SetInstance(heard);
  picker->AreaPick(at[0] - half, at[1] - half, at[0] + half, at[1] + half, scene.Renderer);
  const bool found = picker->GetProp3Ds()->IsItemPresent(body) != 0;
  scene.Window->Render();
  vtkOutputWindow::SetInstance(before);
  return { found, heard->GetOutput().find("vtkAreaPicker") != std::string::npos };
}
}

// A small square is right; of a large one that says what is right in it nothing is said.
TEST(Picking, AnAreaPickerSaysWhereItIsWrong)
{
  std::vector<PickView> views = Views();
  views.resize(3);
  for (const PickView& view : views)
  {
    PickScene scene(view);
    for (std::size_t i = 1; i < scene.GetBodies().size(); i += 3)
    {
      vtkActor* const body = scene.GetBodies()[i];
      double at[3];
      ShowAt(scene, body->GetCenter(), at);
      vtkNew<vtkAreaPicker> planes;
      vtkNew<vtkRenderedAreaPicker> drawn;
      const AreaFound small = PickArea(scene, planes, body, at, 2);
      EXPECT_TRUE(small.Body) << Describe(view) << " body " << i;
      EXPECT_FALSE(small.Warned) << Describe(view) << " body " << i;
      EXPECT_TRUE(PickArea(scene, planes, body, at, 60).Warned) << Describe(view);
      const AreaFound large = PickArea(scene, drawn, body, at, 60);
      EXPECT_FALSE(large.Warned) << Describe(view) << " body " << i;
    }
  }
}
