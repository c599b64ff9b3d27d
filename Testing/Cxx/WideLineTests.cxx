// SPDX-License-Identifier: BSD-3-Clause
// Wide lines of many props: chords, as many lines of one prop are.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVPass.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{
// The lines from the first on, as often as is said.
vtkSmartPointer<vtkActor> MakeWideLines(int first, int lines, int times)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int i = first; i < first + lines; i++)
  {
    const vtkIdType ends[] = { points->InsertNextPoint(-3, -1 + 0.1 * i, -2),
      points->InsertNextPoint(3, -1.3 + 0.1 * i, -1.5) };
    for (int k = 0; k < times; k++)
    {
      cells->InsertNextCell(2, ends);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLineWidth(9);
  actor->GetProperty()->LightingOff();
  return actor;
}

struct LineWindow : WideFoVTestWindow
{
  LineWindow()
    : WideFoVTestWindow("equirectangular", 400, 200)
  {
  }
  TestPixels Draw()
  {
    this->Window->Render();
    return TestPixels(this->Window);
  }
};

TestPixels DrawProps(int props, int technique)
{
  LineWindow test;
  test.Pass()->SetTechnique(technique);
  for (int i = 0; i < props; i++)
  {
    test.Renderer->AddActor(MakeWideLines(i, 1, 1));
  }
  return test.Draw();
}

// The same in one prop, of many lines.
TestPixels DrawOneProp(int lines)
{
  LineWindow test;
  test.Renderer->AddActor(MakeWideLines(0, lines, 500 / lines + 1));
  return test.Draw();
}

// Pixels that differ.
int CountOther(const TestPixels& a, const TestPixels& b)
{
  int count = 0;
  for (int i = 0; i < 3 * a.Width * a.Height; i += 3)
  {
    count += std::abs(a.Data->GetValue(i) - b.Data->GetValue(i)) > 2;
  }
  return count;
}
}

TEST(WideLines, LookTheSameInOnePropAndInMany)
{
  for (const int lines : { 25, 26 })
  {
    const TestPixels props = DrawProps(lines, vtkWideFoVPass::AUTO);
    EXPECT_EQ(CountOther(props, DrawOneProp(lines)), 0) << lines;
    EXPECT_GT(CountOther(props, LineWindow().Draw()), 1000) << "nothing was drawn";
  }
}

// `exact` draws each line as a strip of the map, `auto` as stock VTK does: they differ at ends and
// joints alone.
TEST(WideLines, AreWhereRaysSeeThem)
{
  const TestPixels drawn = DrawProps(25, vtkWideFoVPass::AUTO);
  const int covered = CountOther(drawn, LineWindow().Draw());
  EXPECT_LT(CountOther(drawn, DrawProps(25, vtkWideFoVPass::EXACT)), covered / 15);
}
