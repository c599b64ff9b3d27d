// SPDX-License-Identifier: BSD-3-Clause
// Hardware selection returns the cell that is drawn, all round.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp.h"
#include "vtkPropPicker.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"
#include "vtkWideFoVDataPass.h"

#include <gtest/gtest.h>

namespace
{
vtkSmartPointer<vtkActor> Globe()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2);
  sphere->SetThetaResolution(17);
  sphere->SetPhiResolution(11);
  return MakeTestActor(sphere, 1, 1, 1);
}

// Cell, or point, at a pixel by the hardware selector, or -1.
vtkIdType SelectCell(WideFoVTestWindow& test, unsigned int x, unsigned int y, vtkProp*& prop,
  int association = vtkDataObject::FIELD_ASSOCIATION_CELLS)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(test.Renderer);
  selector->SetFieldAssociation(association);
  selector->SetArea(x, y, x, y);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  if (!selection || selection->GetNumberOfNodes() == 0)
  {
    return -1;
  }
  vtkSelectionNode* node = selection->GetNode(0);
  prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
  auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
  return ids && ids->GetNumberOfValues() ? ids->GetValue(0) : -1;
}
}

TEST(Selection, HardwareSelectionIsTheDrawnCell)
{
  for (const char* projection : { "equirectangular", "hammer", "azimuthal-equidistant" })
  {
    WideFoVTestWindow test(projection, 200, 100);
    auto globe = Globe();
    test.Renderer->AddActor(globe);
    test.Window->Render();
    vtkRenderPass* pass = test.Renderer->GetPass();
    vtkNew<vtkWideFoVDataPass> data;
    data->SetDelegatePass(pass);
    data->SetPropIndex(globe, 0);
    test.Renderer->SetPass(data);
    test.Window->Render();
    auto* cells = data->GetOutput()->GetPointData()->GetArray("cell");
    ASSERT_TRUE(cells);
    test.Renderer->SetPass(pass);
    int drawn = 0;
    for (unsigned int y = 5; y < 100; y += 30)
    {
      for (unsigned int x = 1; x < 200; x += 37)
      {
        const auto expected = static_cast<vtkIdType>(cells->GetTuple1(y * 200 + x)) - 1;
        vtkProp* prop = nullptr;
        EXPECT_EQ(SelectCell(test, x, y, prop), expected) << projection << " " << x << "," << y;
        if (expected >= 0)
        {
          EXPECT_EQ(prop, globe.Get());
          drawn++;
        }
      }
    }
    EXPECT_GT(drawn, 5) << projection;
  }
}

// Three points behind the eye, twenty pixels large; the last one beside the seam, on the right
// border, so that its square is continued on the left one.
vtkSmartPointer<vtkActor> PointsAtTheSeam(const double eye[3])
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i < 3; i++)
  {
    const double x = i == 2 ? 0.05 : 0.8;
    cells->InsertNextCell(1);
    cells->InsertCellPoint(points->InsertNextPoint(eye[0] + x, eye[1] + 0.5 * i - 1, eye[2] + 1));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetPointSize(20);
  return actor;
}

TEST(Selection, APointIsSelectedOnBothSidesOfTheSeam)
{
  for (const char* projection : { "equirectangular", "hammer" })
  {
    WideFoVTestWindow test(projection, 200, 100);
    auto actor = PointsAtTheSeam(test.Camera->GetPosition());
    // whatever is culled, points are not
    actor->GetProperty()->SetFrontfaceCulling(projection[0] == 'h');
    actor->GetProperty()->SetBackfaceCulling(projection[0] == 'e');
    test.Renderer->AddActor(actor);
    test.Window->Render();
    for (unsigned int x : { 5, 197 })
    {
      vtkProp* prop = nullptr;
      EXPECT_EQ(SelectCell(test, x, 50, prop), 2) << projection << " " << x;
      EXPECT_EQ(prop, actor.Get());
    }
    // to pick points, VTK draws them two pixels large
    vtkProp* prop = nullptr;
    const int byPoints = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    EXPECT_EQ(SelectCell(test, 198, 50, prop, byPoints), 2) << projection;
    EXPECT_EQ(SelectCell(test, 5, 50, prop, byPoints), -1) << projection;
  }
}

TEST(Selection, APropPickerFindsThePropBehind)
{
  WideFoVTestWindow test("equirectangular", 200, 100);
  auto globe = Globe();
  test.Renderer->AddActor(globe);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.2, 0, 1.2);
  ball->SetRadius(0.3);
  auto actor = MakeTestActor(ball, 1, 0, 0);
  test.Renderer->AddActor(actor);
  test.Window->Render();
  test.Renderer->SetWorldPoint(0.2, 0, 1.2, 1);
  test.Renderer->WorldToDisplay();
  double d[3];
  test.Renderer->GetDisplayPoint(d);
  vtkNew<vtkPropPicker> picker;
  picker->Pick(d[0], d[1], 0, test.Renderer);
  EXPECT_EQ(picker->GetActor(), actor.Get());
  picker->Pick(100, 50, 0, test.Renderer);
  EXPECT_EQ(picker->GetActor(), globe.Get());
}
