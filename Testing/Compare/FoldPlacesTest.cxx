// SPDX-License-Identifier: BSD-3-Clause
// Places of scenes at which a picture once showed what is hidden: two triangles, most of which meet
// in a fold, and a ray that passes an edge of theirs so near that a float32 ray may miss it.
#include "DrawingTest.h"
#include "RayCaster.h"
#include "vtkWideFoVPass.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Two triangles, and which of them hides the other.
struct PassedFold
{
  std::vector<std::array<float, 3>> Corners;
  std::array<vtkIdType, 3> Front;
  std::array<vtkIdType, 3> Back;
};

vtkSmartPointer<vtkPolyData> MakeFold(const PassedFold& fold, bool frontFirst)
{
  vtkNew<vtkPoints> points;
  for (const std::array<float, 3>& p : fold.Corners)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell(3, frontFirst ? fold.Front.data() : fold.Back.data());
  triangles->InsertNextCell(3, frontFirst ? fold.Back.data() : fold.Front.data());
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

// Triangles from which on a mesh is classified.
constexpr vtkIdType ManyTriangles = 256;

// Makes one of so many: where the two do not meet each goes on in its own plane beyond each edge,
// turned alike; all others are on the other side of the eye.
void AddSurroundings(vtkPolyData* mesh, const vec3& ray)
{
  vtkPoints* const points = mesh->GetPoints();
  vtkCellArray* const triangles = mesh->GetPolys();
  const auto at = [&](vtkIdType point) {
    const double* const p = points->GetPoint(point);
    return vec3(p[0], p[1], p[2]);
  };
  const auto put = [&](const vec3& p) { return points->InsertNextPoint(p.x, p.y, p.z); };
  std::array<std::array<vtkIdType, 3>, 2> two;
  for (vtkIdType i = 0; i < 2; i++)
  {
    vtkNew<vtkIdList> corners;
    triangles->GetCellAtId(i, corners);
    std::copy_n(corners->begin(), 3, two[i].begin());
  }
  for (std::size_t i = 0; i < 6; i++)
  {
    const std::array<vtkIdType, 3>& own = two[i / 3];
    const std::array<vtkIdType, 3>& other = two[1 - i / 3];
    const vtkIdType from = own[i % 3];
    const vtkIdType to = own[(i + 1) % 3];
    const auto has = [&](vtkIdType p) { return std::count(other.begin(), other.end(), p) > 0; };
    if (!has(from) || !has(to))
    {
      triangles->InsertNextCell({ to, from, put(at(from) + at(to) - at(own[(i + 2) % 3])) });
    }
  }
  while (triangles->GetNumberOfCells() < ManyTriangles)
  {
    triangles->InsertNextCell(
      { put(-ray), put(-ray + vec3(0.01, 0, 0)), put(-ray + vec3(0, 0.01, 0)) });
  }
}

// The front is seen at the pixel, in whichever order the two are drawn.
void CheckFold(const PassedFold& fold, const Shot& shot, int i, int j, bool surrounded)
{
  Drawing picture;
  picture.SetTechnique(surrounded ? vtkWideFoVPass::AUTO : vtkWideFoVPass::EXACT);
  picture.SetTolerance(0.02);
  for (const bool frontFirst : { true, false })
  {
    const vtkSmartPointer<vtkPolyData> mesh = MakeFold(fold, frontFirst);
    if (surrounded)
    {
      AddSurroundings(mesh, shot.Direction);
    }
    picture.SetMesh(mesh);
    const reference::DrawnPicture drawn = picture.Draw(shot);
    const vtkIdType front = frontFirst ? 0 : 1;
    ASSERT_EQ(drawn.Cell[std::size_t(j) * shot.Width + i], float(front + 1));
    const reference::RayCaster caster(picture.GetMesh(), picture.GetView(), picture.GetPose());
    const reference::Metrics m = reference::Compare(drawn, caster, 0.02);
    EXPECT_LE(m.MaxPx, 0.02) << Details(shot, picture.GetView(), m);
    const vec2 ndc = reference::PixelToNdc(i + 0.5, j + 0.5, shot.Width, shot.Height);
    EXPECT_EQ(caster.Cast(ndc).Cell, front); // or the pixel is not what it is here for
  }
}

// Alone, and as two of a mesh that is classified.
void CheckFold(const PassedFold& fold, const Shot& shot, int i, int j)
{
  CheckFold(fold, shot, i, j, false);
  CheckFold(fold, shot, i, j, true);
}
}

TEST(Fold, FrontHidesBack)
{
  const PassedFold fold{ { { { { -0.190583915f, 0.636866927f, 0.607160628f } },
                           { { -0.190579906f, 0.634641767f, 0.606021106f } },
                           { { -0.216512591f, 0.643962681f, 0.590684652f } },
                           { { -0.217965052f, 0.644337654f, 0.592684567f } } } },
    { { 0, 1, 2 } }, { { 3, 0, 2 } } };
  Shot shot;
  shot.Width = 1024;
  shot.Height = 512;
  shot.Options.Radii = { { 1.7337706e-4, 1.7337706 } };
  CheckFold(fold, shot, 55, 126);
}

// The front is a needle: at its tip the edges are nearer to each other than the bias is wide, which
// would ask for its depth beyond the fold. Of the atrium, at 8192 x 4096; turned into the middle of
// a small picture.
TEST(Fold, NeedleHidesBack)
{
  const PassedFold fold{
    { { { { -7.6702266f, 0.1f, 4.6109567f } }, { { -7.6631069f, 0.1f, 4.6109567f } },
      { { -7.6515803f, 0.25f, 4.6464310f } }, { { -7.6271701f, 0.25f, 4.6286960f } } } },
    { { 1, 3, 2 } }, { { 0, 1, 2 } }
  };
  ViewOptions wide;
  wide.HorizontalFov = 320;
  wide.VerticalFov = 150;
  wide.Aspect = 2;
  const View view(*FindProjection("panini"), wide);
  Shot shot;
  shot.Width = 129;
  shot.Height = 65;
  shot.Options.Radii = { { 0.00234542, 23.4542 } };
  shot.Direction = view.Ray(reference::PixelToNdc(2818.5, 2022.5, 8192, 4096)).Direction;
  CheckFold(fold, shot, 64, 32);
}

// The same at a tip whose short edge is not the nearest, and where the back is no needle and was
// moved by more than the front is wide: of arrowheads, whose bases are seen nearly edge-on, at 8192
// x 4096.
TEST(Fold, NeedleOfAnArrowHidesBack)
{
  Shot shot;
  shot.Width = 129;
  shot.Height = 65;
  const PassedFold cloud{ { { { { 5.49541759f, -2.51586366f, -4.50211954f } },
                            { { 5.71500397f, -2.6151464f, -4.23373604f } },
                            { { 5.48983812f, -2.51267862f, -4.49637604f } },
                            { { 5.50222492f, -2.51479793f, -4.50729465f } } } },
    { { 0, 1, 2 } }, { { 1, 0, 3 } } };
  shot.Options.Radii = { { 0.01, 40 } };
  shot.Direction = vec3(0.72918025054874569, -0.33382578795319601, -0.59737467765808105);
  CheckFold(cloud, shot, 64, 32);
  const PassedFold wind{ { { { { 0.623458207f, -0.198052809f, -0.622675598f } },
                           { { 0.61946249f, -0.196864456f, -0.618430912f } },
                           { { 0.629381835f, -0.197693214f, -0.623096526f } },
                           { { 0.627850771f, -0.208162233f, -0.611541033f } } } },
    { { 0, 1, 2 } }, { { 3, 0, 2 } } };
  shot.Options.Radii = { { 1.7e-4, 1.7 } };
  shot.Direction = vec3(0.69355277066509013, -0.21786817890328891, -0.68667169078398838);
  CheckFold(wind, shot, 64, 32);
}

// Of stream tubes, at 8192 x 4096: the back is a needle, moved by less than the front.
TEST(Fold, BackThatIsANeedleYields)
{
  Shot shot;
  shot.Width = 129;
  shot.Height = 65;
  shot.Options.Radii = { { 5.59e-4, 5.59 } };
  const PassedFold tube{ { { { { 1.73506535f, -0.569223666f, 0.146710873f } },
                           { { 1.67211844f, -0.566247368f, 0.199144959f } },
                           { { 1.73763658f, -0.568143451f, 0.14462924f } },
                           { { 1.67449094f, -0.567822242f, 0.19714427f } } } },
    { { 0, 1, 2 } }, { { 1, 3, 2 } } };
  shot.Direction = vec3(0.94724355957878792, -0.31024760792439499, 0.08047397476015429);
  CheckFold(tube, shot, 64, 32);
  const PassedFold other{ { { { { 1.73590921f, -0.568096066f, 0.143652439f } },
                            { { 1.73825438f, -0.569673622f, 0.141621947f } },
                            { { 1.66936804f, -0.566148961f, 0.196622849f } },
                            { { 1.67192198f, -0.567375565f, 0.194601893f } } } },
    { { 0, 1, 2 } }, { { 3, 0, 2 } } };
  shot.Direction = vec3(0.94736589058378373, -0.31024760792439499, 0.079020827226656376);
  CheckFold(other, shot, 64, 32);
  shot.Direction = vec3(0.94671984865907921, -0.31127929687499994, 0.082624012804607475);
  CheckFold(other, shot, 64, 32);
  const PassedFold third{ { { { { 1.73654468f, -0.569614077f, 0.148620605f } },
                            { { 1.67555971f, -0.566369915f, 0.200505495f } },
                            { { 1.73901035f, -0.568175042f, 0.146630287f } },
                            { { 1.67307771f, -0.567450845f, 0.202692389f } } } },
    { { 0, 1, 2 } }, { { 1, 3, 2 } } };
  shot.Direction = vec3(0.94665357760567903, -0.31089174380970253, 0.084813487355082665);
  CheckFold(third, shot, 64, 32);
}

// Of two stream tubes that lie nearly in one another, at 8192 x 4096: a face is no farther away, or
// nearer, beside its own edge where nothing folds.
TEST(Fold, EdgeKeepsItsPlaceBesideAnotherFace)
{
  Shot shot;
  shot.Width = 129;
  shot.Height = 65;
  shot.Options.Radii = { { 5.59e-4, 5.59 } };
  const PassedFold tubes{ { { { -0.378244686f, 1.93263135f, -2.50078773f } },
                            { { -0.395309019f, 0.950787401f, -2.50078773f } },
                            { { -0.365530777f, 1.93241034f, -2.46851397f } },
                            { { -0.366139936f, 1.98015866f, -2.46950865f } },
                            { { -0.393824148f, 1.03070841f, -2.50070858f } },
                            { { -0.381489325f, 1.03050909f, -2.46950865f } } },
    { { 0, 1, 2 } }, { { 3, 4, 5 } } };
  shot.Direction = vec3(-0.14232825421993595, 0.39398616720691393, -0.90802949737346683);
  CheckFold(tubes, shot, 64, 32);
}
