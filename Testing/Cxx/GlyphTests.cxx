// SPDX-License-Identifier: BSD-3-Clause
// The copies of a glyph mapper are drawn by their classes, and seen where they are when a ray
// decides for each pixel.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace
{
constexpr int GlyphPicture[2] = { 480, 240 };

// Of the pixels: what `auto` may show that a ray does not see, beside silhouettes and of what is
// thinner than a pixel (Documentation/design/refine.md).
constexpr double Beside = 2e-4;
constexpr int MostBeside = static_cast<int>(Beside * GlyphPicture[0] * GlyphPicture[1]);

vtkSmartPointer<vtkActor> MakeArrows(int count)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  const auto next = [&random](double low, double high) {
    random->Next();
    return random->GetRangeValue(low, high);
  };
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < count; i++)
  {
    points->InsertNextPoint(next(-3, 3), next(-3, 3), next(-3, 3));
    vectors->InsertNextTuple3(next(-1, 1), next(-1, 1), next(-1, 1));
    colors->InsertNextTuple3(next(60, 250), next(60, 250), next(60, 250));
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  places->GetPointData()->AddArray(vectors);
  places->GetPointData()->SetScalars(colors);
  vtkNew<vtkArrowSource> arrow;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(arrow->GetOutputPort());
  mapper->SetOrientationArray("vectors");
  mapper->SetScaleFactor(0.5);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

// Of `a`, the pixels that have the colour of none in `b` within a pixel of them.
int CountAstray(const TestPixels& a, const TestPixels& b)
{
  int astray = 0;
  for (int y = 1; y < GlyphPicture[1] - 1; y++)
  {
    for (int x = 1; x < GlyphPicture[0] - 1; x++)
    {
      bool found = false;
      for (int i = 0; i < 9 && !found; i++)
      {
        const unsigned char* const p = a.At(x, y);
        const unsigned char* const q = b.At(x + i % 3 - 1, y + i / 3 - 1);
        found = std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) <= 3;
      }
      astray += !found;
    }
  }
  return astray;
}

// eye: VTK_STEREO_LEFT, VTK_STEREO_RIGHT, or 0: between the two.
void CheckArrows(const char* projection, int eye = 0)
{
  WideFoVTestWindow test(projection, GlyphPicture[0], GlyphPicture[1]);
  if (eye != 0)
  {
    test.Camera->SetStereoModelToOmnidirectional();
    test.Window->SetStereoType(eye);
    test.Window->StereoRenderOn();
  }
  test.Renderer->AddActor(MakeArrows(400));
  test.Window->Render();
  const TestPixels drawn(test.Window);
  const vtkIdType projected = test.Pass()->GetNumberOfProjectedTriangles();
  EXPECT_GT(projected, 0);
  EXPECT_LT(projected, test.Pass()->GetNumberOfTriangles());
  test.Window->Render();
  EXPECT_EQ(CountAstray(TestPixels(test.Window), drawn), 0);
  test.Pass()->SetTechniqueToExact();
  test.Window->Render();
  EXPECT_EQ(test.Pass()->GetNumberOfProjectedTriangles(), 0);
  const TestPixels exact(test.Window);
  EXPECT_LE(CountAstray(drawn, exact), MostBeside);
  EXPECT_LE(CountAstray(exact, drawn), MostBeside);
}
}

TEST(Glyphs, AreSeenWhereRaysSeeThem)
{
  for (const char* const projection :
    { "equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap" })
  {
    SCOPED_TRACE(projection);
    CheckArrows(projection);
  }
}

TEST(Glyphs, AreSeenByEachEye)
{
  for (const int eye : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
  {
    SCOPED_TRACE(eye);
    CheckArrows("equirectangular", eye);
  }
}

// Others that share the source, and whatever is drawn after them, are not left without it.
TEST(Glyphs, EveryFrameHasAllOfThem)
{
  WideFoVTestWindow test("equirectangular", GlyphPicture[0], GlyphPicture[1]);
  const auto arrows = MakeArrows(400);
  test.Renderer->AddActor(arrows);
  test.Window->Render();
  const TestPixels first(test.Window);
  // with the projection of stock VTK, then translucent
  test.Camera->SetProjection("perspective");
  test.Camera->SetHorizontalFieldOfView(90);
  test.Camera->SetVerticalFieldOfView(60);
  test.Window->Render();
  EXPECT_EQ(test.Pass()->GetNumberOfProjectedTriangles(), 0);
  const TestPixels flat(test.Window);
  EXPECT_GT(CountAstray(flat, first), GlyphPicture[0] * GlyphPicture[1] / 50);
  test.Camera->SetProjection("equirectangular");
  test.Camera->SetHorizontalFieldOfView(360);
  test.Camera->SetVerticalFieldOfView(180);
  arrows->GetProperty()->SetOpacity(0.999);
  test.Window->Render();
  EXPECT_GT(test.Pass()->GetNumberOfProjectedTriangles(), 0);
  arrows->GetProperty()->SetOpacity(1);
  test.Window->Render();
  EXPECT_EQ(CountAstray(TestPixels(test.Window), first), 0);
}

// Those behind the eye are not drawn where the view does not show them.
TEST(Glyphs, WhatIsNotSeenIsLeftOut)
{
  WideFoVTestWindow test("equirectangular", GlyphPicture[0], GlyphPicture[1]);
  test.Renderer->AddActor(MakeArrows(400));
  test.Camera->SetHorizontalFieldOfView(120);
  test.Camera->SetVerticalFieldOfView(60);
  test.Window->Render();
  EXPECT_GT(test.Pass()->GetNumberOfCulledTriangles(), test.Pass()->GetNumberOfTriangles() / 2);
  const TestPixels drawn(test.Window);
  test.Pass()->CullingOff();
  test.Window->Render();
  EXPECT_EQ(CountAstray(TestPixels(test.Window), drawn), 0);
}
