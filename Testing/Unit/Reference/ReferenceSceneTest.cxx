// SPDX-License-Identifier: BSD-3-Clause
// The reference with scenes of several polydata, and its shorter ways to the same answers.
#include "Metrics.h"
#include "Stereo/Stereo.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <vtkAppendPolyData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

using namespace wfv;
using namespace wfv::reference;

namespace
{
constexpr int Width = 96;
constexpr int Height = 48;

View FullSphere()
{
  ViewOptions o;
  o.Radii = { { 0.01, 20 } };
  return View(*FindProjection("equirectangular"), o);
}

vtkSmartPointer<vtkPolyData> Ball(double x, double y, double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, y, -2);
  source->SetRadius(radius);
  source->SetThetaResolution(20);
  source->SetPhiResolution(20);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

TriangleSoup TwoBalls()
{
  const vtkSmartPointer<vtkPolyData> first = Ball(0.3, 0, 1);
  TriangleSoup soup = Triangulate(first, IdentityPose());
  Append(soup, Ball(-0.5, 0.4, 0.8), IdentityPose(), first->GetNumberOfCells());
  return soup;
}

vtkSmartPointer<vtkFloatArray> Array(const char* name, std::initializer_list<float> values)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  for (const float value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}
}

TEST(ReferenceScene, AppendedPolyDataAreNumberedThrough)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(Ball(0.3, 0, 1));
  both->AddInputData(Ball(-0.5, 0.4, 0.8));
  both->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  both->Update();
  const HitPicture one =
    RayCaster(both->GetOutput(), FullSphere(), IdentityPose()).Render(Width, Height);
  const HitPicture two = RayCaster(TwoBalls(), FullSphere()).Render(Width, Height);
  long first = 0;
  long second = 0;
  for (std::size_t n = 0; n < one.Hits.size(); ++n)
  {
    ASSERT_EQ(one.Hits[n].Cell, two.Hits[n].Cell);
    ASSERT_EQ(one.Hits[n].Distance, two.Hits[n].Distance);
    first += two.Hits[n].Cell >= 0 && two.Hits[n].Cell < 720;
    second += two.Hits[n].Cell >= 720;
  }
  EXPECT_GT(first, 100);
  EXPECT_GT(second, 50);
}

TEST(ReferenceScene, SeesIsCast)
{
  const RayCaster caster(TwoBalls(), FullSphere());
  long yes = 0;
  for (int j = 0; j < Height; ++j)
  {
    for (int i = 0; i < Width; ++i)
    {
      const vec2 ndc = PixelToNdc(i + 0.5, j + 0.5, Width, Height);
      const vtkIdType cell = caster.Cast(ndc).Cell;
      EXPECT_TRUE(caster.Sees(ndc, cell));
      EXPECT_EQ(caster.Sees(ndc, -1), cell == -1);
      for (vtkIdType other = cell - 2; other <= cell + 2; ++other)
      {
        EXPECT_EQ(caster.Sees(ndc, other), other == cell || (other < 0 && cell < 0 && other == -1));
      }
      yes += cell >= 0;
    }
  }
  EXPECT_GT(yes, 200);
}

namespace
{
// Every map at its widest, and of one the stereo models whose rays begin in different places or are
// none.
std::vector<View> ManyViews()
{
  std::vector<View> views;
  ViewOptions o;
  o.Radii = { { 0.01, 20 } };
  for (const Projection& projection : Projections())
  {
    o.HorizontalFov = projection.MaxHorizontalFov;
    o.VerticalFov = projection.MaxVerticalFov;
    views.emplace_back(projection, o);
  }
  o.Stereo.Eye = Eye::Left;
  o.Stereo.InterpupillaryDistance = 0.2;
  for (const char* const model : { "omnidirectional", "warped" })
  {
    o.Stereo.Model = FindStereoModel(model);
    views.emplace_back(*FindProjection("equirectangular"), o);
  }
  return views;
}
}

// Rays that are cast together say what each says alone: at seams, poles and rims, and in pictures
// that no number of tiles fills.
TEST(ReferenceScene, PicturesHaveWhatEachPixelCasts)
{
  for (const View& view : ManyViews())
  {
    const RayCaster caster(TwoBalls(), view);
    const HitPicture picture = caster.Render(Width - 1, Height - 1);
    long hits = 0;
    for (std::size_t n = 0; n < picture.Hits.size(); ++n)
    {
      const double i = double(n % picture.Width);
      const double j = double(n / picture.Width);
      const Hit one = caster.Cast(PixelToNdc(i + 0.5, j + 0.5, picture.Width, picture.Height));
      const Hit& other = picture.Hits[n];
      ASSERT_EQ(other.Triangle, one.Triangle) << view.GetProjection().Name << " " << i << " " << j;
      ASSERT_EQ(other.Cell, one.Cell);
      ASSERT_EQ(other.Distance, one.Distance);
      ASSERT_EQ(other.Barycentrics, one.Barycentrics);
      ASSERT_EQ(other.InDomain, one.InDomain);
      hits += one.Cell >= 0;
    }
    EXPECT_GT(hits, 0) << view.GetProjection().Name;
  }
}

TEST(ReferenceScene, DrawnCellsAreNumberedThrough)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 1, 1);
  image->GetPointData()->AddArray(Array("cell", { 0, 3, 3, 1 }));
  image->GetPointData()->AddArray(Array("prop", { 0, 1, 2, 2 }));
  image->GetPointData()->AddArray(Array("distance", { INFINITY, 1, 1, 1 }));
  const DrawnPicture p = ToDrawnPicture(image, { 0, 100 });
  EXPECT_EQ(p.Cell, (std::vector<float>{ 0, 3, 103, 101 }));
  EXPECT_EQ(ToDrawnPicture(image).Cell[1], 3);
}

TEST(ReferenceScene, ThinnedSearchEstimates)
{
  const RayCaster caster(TwoBalls(), FullSphere());
  const HitPicture reference = caster.Render(Width, Height);
  DrawnPicture drawn;
  drawn.Width = Width;
  drawn.Height = Height;
  for (const Hit& hit : reference.Hits)
  {
    drawn.Cell.push_back(float(hit.Cell >= 0 ? 1 + (hit.Cell + 7) % 1440 : 0));
    drawn.Distance.push_back(float(hit.Distance));
  }
  const Metrics all = Compare(drawn, caster, reference, 0.25);
  const Metrics some = Compare(drawn, caster, reference, 0.25, 50);
  EXPECT_EQ(all.Searched, all.Mismatched);
  EXPECT_EQ(some.Mismatched, all.Mismatched);
  EXPECT_EQ(some.Searched, 50);
  EXPECT_NEAR(some.Unexplained, all.Unexplained, 0.1 * all.Unexplained);
  EXPECT_LE(some.MaxPx, all.MaxPx);
  WorstPixel p = all.Worst.front();
  EXPECT_FALSE(IsExplained(caster, Width, Height, p, 0.25));
  p.Drawn = p.Reference;
  EXPECT_TRUE(IsExplained(caster, Width, Height, p, 0.25));
}
