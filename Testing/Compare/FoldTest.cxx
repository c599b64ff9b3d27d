// SPDX-License-Identifier: BSD-3-Clause
// Two triangles of a stream tube that meet in a fold, the one seen from its front, the other
// from behind. The ray of one pixel passes the fold within a hundred-thousandth of a pixel: in
// float32 it meets both triangles at the same depth. The front hides the back, in either order.
#include "DrawingTest.h"
#include "RayCaster.h"
#include "vtkWideFoVPass.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr vtkIdType Front[] = { 0, 1, 2 };
constexpr vtkIdType Back[] = { 3, 0, 2 };

vtkSmartPointer<vtkPolyData> MakeFold(const vtkIdType* first, const vtkIdType* second)
{
  const float corners[][3] = { { -0.190583915f, 0.636866927f, 0.607160628f },
    { -0.190579906f, 0.634641767f, 0.606021106f }, { -0.216512591f, 0.643962681f, 0.590684652f },
    { -0.217965052f, 0.644337654f, 0.592684567f } };
  vtkNew<vtkPoints> points;
  for (const float* p : corners)
  {
    points->InsertNextPoint(p);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell(3, first);
  triangles->InsertNextCell(3, second);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}
}

TEST(Fold, FrontHidesBack)
{
  constexpr int I = 55;
  constexpr int J = 126;
  Shot shot;
  shot.Width = 1024;
  shot.Height = 512;
  shot.Options.Radii = { { 1.7337706e-4, 1.7337706 } };
  Drawing picture;
  picture.SetTechnique(vtkWideFoVPass::EXACT);
  for (const bool frontFirst : { true, false })
  {
    picture.SetMesh(frontFirst ? MakeFold(Front, Back) : MakeFold(Back, Front));
    const reference::DrawnPicture drawn = picture.Draw(shot);
    const vtkIdType front = frontFirst ? 0 : 1;
    ASSERT_EQ(drawn.Cell[std::size_t(J) * shot.Width + I], float(front + 1));
    const reference::RayCaster caster(picture.GetMesh(), picture.GetView(), picture.GetPose());
    const reference::Metrics m = reference::Compare(drawn, caster, 0.02);
    EXPECT_LE(m.MaxPx, 0.02) << Details(shot, picture.GetView(), m);
    const vec2 ndc = reference::PixelToNdc(I + 0.5, J + 0.5, shot.Width, shot.Height);
    EXPECT_EQ(caster.Cast(ndc).Cell, front); // or the pixel is not what it is here for
  }
}
