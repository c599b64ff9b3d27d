// SPDX-License-Identifier: BSD-3-Clause
// The sphere behind a picture: what it covers, and that each place has its own part of the picture.
#include "Viewing/Dome.h"

#include "Text/Angles.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTriangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
widefov::Options ViewOf(const std::string& projection, double hfov, double vfov, double tilt)
{
  widefov::Options o;
  o.Projection = projection;
  o.View.HorizontalFov = hfov;
  o.View.VerticalFov = vfov;
  o.View.Tilt = tilt;
  o.View.Aspect = 2;
  return o;
}

// Steradians, nearly: of the flat halves of its cells.
double AreaOf(vtkPolyData* dome)
{
  double area = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < dome->GetNumberOfCells(); i++)
  {
    dome->GetCellPoints(i, ids);
    double p[4][3];
    for (int j = 0; j < 4; j++)
    {
      dome->GetPoint(ids->GetId(j), p[j]);
    }
    area +=
      vtkTriangle::TriangleArea(p[0], p[1], p[2]) + vtkTriangle::TriangleArea(p[0], p[2], p[3]);
  }
  return area;
}

// Area of the picture that the cells use, of 1.
double ShareOf(vtkPolyData* dome)
{
  double share = 0;
  vtkNew<vtkIdList> ids;
  vtkDataArray* const places = dome->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < dome->GetNumberOfCells(); i++)
  {
    dome->GetCellPoints(i, ids);
    for (int j = 0; j < 4; j++)
    {
      double a[2];
      double b[2];
      places->GetTuple(ids->GetId(j), a);
      places->GetTuple(ids->GetId((j + 1) % 4), b);
      share += 0.5 * (a[0] * b[1] - b[0] * a[1]);
    }
  }
  return std::abs(share);
}
}

TEST(Dome, CoversWhatTheViewShows)
{
  const double all = 4 * widefov::Pi;
  EXPECT_NEAR(AreaOf(widefov::MakeDome(ViewOf("equirectangular", 360, 180, 0))), all, 0.01 * all);
  EXPECT_NEAR(AreaOf(widefov::MakeDome(ViewOf("hammer", 360, 180, 0))), all, 0.03 * all);
  EXPECT_NEAR(
    AreaOf(widefov::MakeDome(ViewOf("azimuthal-equidistant", 180, 180, 90))), all / 2, 0.01 * all);
  EXPECT_NEAR(
    AreaOf(widefov::MakeDome(ViewOf("equi-angular-cubemap", 360, 180, 0))), all, 0.03 * all);
}

TEST(Dome, PutsPicturesOnScreens)
{
  wfv::Screen corners;
  corners.LowerLeft = wfv::vec3(-1, 0, -2);
  corners.LowerRight = wfv::vec3(1, 0, -3);
  corners.UpperRight = wfv::vec3(1, 4, -3);
  const vtkSmartPointer<vtkPolyData> screen = widefov::MakeScreen(corners);
  ASSERT_EQ(screen->GetNumberOfCells(), 1);
  ASSERT_EQ(screen->GetNumberOfPoints(), 4);
  for (vtkIdType i = 0; i < 4; i++)
  {
    double place[2];
    screen->GetPointData()->GetTCoords()->GetTuple(i, place);
    const wfv::vec3 at = corners.LowerLeft + place[0] * (corners.LowerRight - corners.LowerLeft) +
      place[1] * (corners.UpperRight - corners.LowerRight);
    for (int c = 0; c < 3; c++)
    {
      EXPECT_DOUBLE_EQ(screen->GetPoint(i)[c], at[c]) << "corner " << i;
    }
  }
}

TEST(Dome, UsesThePictureOnce)
{
  EXPECT_NEAR(ShareOf(widefov::MakeDome(ViewOf("equirectangular", 360, 180, 0))), 1, 0.001);
  // a circle in a picture twice as wide as high
  EXPECT_NEAR(ShareOf(widefov::MakeDome(ViewOf("azimuthal-equidistant", 180, 180, 0))),
    widefov::Pi / 8, 0.001);
}

TEST(Dome, PutsEachPlaceWhereTheViewHasIt)
{
  const widefov::Options o = ViewOf("azimuthal-equal-area", 200, 200, 60);
  const vtkSmartPointer<vtkPolyData> dome = widefov::MakeDome(o);
  const wfv::View view(*wfv::FindProjection(o.Projection), o.View);
  double top = -1;
  for (vtkIdType i = 0; i < dome->GetNumberOfPoints(); i++)
  {
    double p[3];
    double place[2];
    dome->GetPoint(i, p);
    dome->GetPointData()->GetTCoords()->GetTuple(i, place);
    const wfv::NdcPoint ndc = view.Forward({ p[0], p[1], p[2] });
    ASSERT_NEAR(0.5 * (ndc.Ndc.x + 1), place[0], 1e-5) << "point " << i;
    ASSERT_NEAR(0.5 * (ndc.Ndc.y + 1), place[1], 1e-5) << "point " << i;
    top = std::max(top, p[1]);
  }
  EXPECT_NEAR(top, 1, 1e-3) << "a tilted dome has its zenith in the picture";
}
