// SPDX-License-Identifier: BSD-3-Clause
// Two triangles that meet in a fold, the one seen from its front, the other from behind. The ray of
// a pixel passes the fold so near that in float32, or in a depth buffer, both lie at one depth.
// What hides the other in truth does so in the picture, in whichever order they are drawn.
#include "DrawingTest.h"
#include "Promise.h"
#include "RayCaster.h"
#include "vtkWideFoVPass.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <random>
#include <utility>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Of each kind; the environment may ask for more of those that are known.
int GetNumberOfFolds()
{
  const char* const wanted = std::getenv("WIDEFOV_TEST_FOLDS");
  return wanted ? std::atoi(wanted) : 2000;
}
const int RandomFolds = GetNumberOfFolds();

// Of these: needles whose tip, the bias inside, is behind the back all the same. It is not known of
// an edge that it is no fold, and a depth buffer's steps are coarser than what lies between.
constexpr long LostNeedles = 4;

// Of these, with twice a depth buffer's steps of less than what lies between.
constexpr long LostFlatFolds = 4;

// Of these, half of them wound to show their backs, beside corners: which of the two faces yields
// is told by the winding where the bias is wider than they are.
constexpr long LostTurnedFolds = 8;

// Where folds are: so many of them, one in so many pixels from the first row on.
struct FoldPlaces
{
  int Count;
  int Step;
};

// All over the picture.
FoldPlaces Everywhere(const Shot& shot)
{
  return { RandomFolds, shot.Width * shot.Height / RandomFolds };
}

// The top 24 rows of 512 pixels.
constexpr FoldPlaces BesideAPole = { 4096, 3 };

using Between = std::function<double(double, double)>;

// How two faces meet: how much farther from the eye each lies, a step away from the edge, and by
// how many radians a ray may miss the edge.
struct Fold
{
  double Front;
  double Back;
  double Off;
};

// Seen nearly edge-on, by a ray that misses the edge by no more than float32 makes of a ray.
Fold SharpFold(const Between& between)
{
  return { -1 / between(0.01, 0.1), 1 / between(0.01, 0.1), 1e-7 };
}

// The same, the front nearly in the plane of the rays.
Fold SharpestFold(const Between& between)
{
  return { -1 / between(0.002, 0.02), 1 / between(0.01, 0.2), 2e-7 };
}

// Two faces that are nearly the same, so that a depth buffer tells them apart far from the edge.
Fold FlatFold(const Between& between)
{
  const double front = between(-1, 1);
  return { front, front + between(0.15, 0.3), 1e-6 };
}

// A depth buffer tells them apart nowhere so near to the edge.
Fold FlatterFold(const Between& between)
{
  const double front = between(-1, 1);
  return { front, front + between(0.005, 0.15), 1e-6 };
}

// Puts a front and a back into the mesh that meet in an edge which a ray passes on either side.
// Beyond the edge the plane of the back comes first.
void AddFold(vtkPolyData* mesh, const vec3& ray, const Fold& fold, bool frontFirst, bool otherWay,
  const Between& between)
{
  const vec3 side = glm::cross(ray, vec3(between(-1, 1), between(-1, 1), between(-1, 1)));
  const vec3 along = glm::normalize(side);
  const vec3 out = glm::cross(ray, along); // beyond the fold
  const double off = between(-fold.Off, fold.Off);
  const double size = between(0.001, 0.003);
  const vec3 middle = ray + off * out;
  const auto put = [&](const vec3& p) { return mesh->GetPoints()->InsertNextPoint(p.x, p.y, p.z); };
  vtkIdType from = put(middle - size * along);
  vtkIdType to = put(middle + size * along);
  if (otherWay)
  {
    std::swap(from, to);
  }
  const vtkIdType front[] = { from, to, put(middle + size * (fold.Front * ray - out)) };
  const vtkIdType back[] = { to, from, put(middle + size * (fold.Back * ray - out)) };
  mesh->GetPolys()->InsertNextCell(3, frontFirst ? front : back);
  mesh->GetPolys()->InsertNextCell(3, frontFirst ? back : front);
}

// A fold whose front ends in a needle: as a Fold, and where a ray passes.
struct NeedleFold
{
  double Front;
  double Back;
  double Inside; // of the fold's edge, radians; below 0 beyond it
  double Width;  // of the needle there, radians, if its tip is in place
  double Off;    // of the tip from the fold's edge, radians
};

// The ray passes between the two fronts, at the tip, within what float32 makes of a ray: the bias
// inside that edge they are where no bias takes the back.
NeedleFold FlatNeedle(const Between& between)
{
  const double front = between(-1, 1);
  const double inside = between(2e-6, 1e-5);
  return { front, front + between(0.02, 0.1), inside, inside, between(-1e-7, 1e-7) };
}

// The ray passes on either side of the fold, by what float32 makes of a ray, inside the needle,
// which is nearly in the plane of the rays.
NeedleFold SteepNeedle(const Between& between)
{
  return { -1 / between(0.01, 0.02), 1 / between(0.1, 0.2), between(-2e-7, 2e-7),
    between(3e-6, 1e-5), 0 };
}

// A front that ends at the fold in a needle, which another front continues, and a back.
void AddNeedle(vtkPolyData* mesh, const vec3& ray, const NeedleFold& fold, bool frontFirst,
  const Between& between)
{
  const vec3 side = glm::cross(ray, vec3(between(-1, 1), between(-1, 1), between(-1, 1)));
  const vec3 along = glm::normalize(side);
  const vec3 out = glm::cross(ray, along); // beyond the fold
  const double size = between(0.02, 0.06);
  const double thin = between(0.02, 0.06); // of the needle, times its length
  const auto put = [&](double far, double in, double slope) {
    const vec3 p =
      ray + (fold.Inside - in) * out + (far - fold.Width / thin) * along + in * slope * ray;
    return mesh->GetPoints()->InsertNextPoint(p.x, p.y, p.z);
  };
  const vtkIdType tip = put(0, fold.Off, fold.Front);
  const vtkIdType end = put(size, 0, fold.Front);
  const vtkIdType beside = put(size, thin * size, fold.Front);
  const vtkIdType cells[][3] = { { tip, end, beside },
    { tip, beside, put(0.5 * size, 2 * thin * size, fold.Front) },
    { end, tip, put(0.5 * size, 2 * thin * size, fold.Back) } };
  for (int i = 0; i < 3; i++)
  {
    mesh->GetPolys()->InsertNextCell(3, cells[frontFirst ? i : 2 - i]);
  }
}

// A fold whose back is a needle, passed beside its tip, where the bias is less than the front's.
void AddThinBack(vtkPolyData* mesh, const vec3& ray, bool frontFirst, const Between& between)
{
  const vec3 side = glm::cross(ray, vec3(between(-1, 1), between(-1, 1), between(-1, 1)));
  const vec3 along = glm::normalize(side);
  const vec3 out = glm::cross(ray, along); // beyond the fold
  const double front = between(-1, 1);
  const double back = front + between(0.05, 0.2);
  const double size = between(0.02, 0.06);
  const double thin = between(0.02, 0.06); // of the needle, times its length
  const double tip = between(5e-6, 5e-5) / thin;
  const double inside = between(-1e-7, 2e-6);
  const auto put = [&](double far, double in, double slope) {
    const vec3 p = ray + (inside - in) * out + (far - tip) * along + in * slope * ray;
    return mesh->GetPoints()->InsertNextPoint(p.x, p.y, p.z);
  };
  const vtkIdType from = put(0, 0, 0);
  const vtkIdType to = put(size, 0, 0);
  const vtkIdType cells[][3] = { { from, to, put(0.2 * size, 0.5 * size, front) },
    { to, from, put(0.9 * size, thin * size, back) } };
  for (int i = 0; i < 2; i++)
  {
    mesh->GetPolys()->InsertNextCell(3, cells[frontFirst ? i : 1 - i]);
  }
}

// Puts what a ray passes into the mesh, in whichever order for each number.
using Add = std::function<void(vtkPolyData*, const vec3&, int, const Between&)>;

// One at each of these pixels.
vtkSmartPointer<vtkPolyData> MakeFolds(
  const View& view, const Shot& shot, const FoldPlaces& places, const Add& add)
{
  std::mt19937 generator(1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(vtkNew<vtkPoints>());
  mesh->SetPolys(vtkNew<vtkCellArray>());
  for (int i = 0; i < places.Count; i++)
  {
    const int pixel = i * places.Step;
    const vec2 ndc = reference::PixelToNdc(
      pixel % shot.Width + 0.5, pixel / shot.Width + 0.5, shot.Width, shot.Height);
    if (view.Ray(ndc).Inside)
    {
      add(mesh, view.Ray(ndc).Direction, i, between);
    }
  }
  return mesh;
}
}

// What a ray hits by its rounding alone hides what it hits by the same rounding behind.
class FoldBeyondTheEdge : public DrawingTest
{
protected:
  // bothWays: every other one is wound to show the sides that are hidden.
  static Add Folds(Fold (*make)(const Between&), bool bothWays)
  {
    return [=](vtkPolyData* mesh, const vec3& ray, int i, const Between& between) {
      AddFold(mesh, ray, make(between), i % 3 != 0, bothWays && i % 2 == 1, between);
    };
  }

  static Add Needles(NeedleFold (*make)(const Between&))
  {
    return [=](vtkPolyData* mesh, const vec3& ray, int i, const Between& between) {
      AddNeedle(mesh, ray, make(between), i % 3 != 0, between);
    };
  }

  static Add ThinBacks()
  {
    return [](vtkPolyData* mesh, const vec3& ray, int i, const Between& between) {
      AddThinBack(mesh, ray, i % 3 != 0, between);
    };
  }

  static Shot ShotOf(const std::string& projection)
  {
    Shot shot;
    shot.Projection = projection;
    shot.Width = 512;
    shot.Height = 256;
    shot.Options.HorizontalFov = FindProjection(projection)->MaxHorizontalFov;
    shot.Options.VerticalFov = FindProjection(projection)->MaxVerticalFov;
    shot.Options.Radii = { { 0.1, 2 } };
    return shot;
  }

  static reference::Metrics Compare(
    const Shot& shot, int technique, double tolerance, const FoldPlaces& places, const Add& add)
  {
    const std::string& projection = shot.Projection;
    Picture->SetTechnique(technique);
    Picture->SetTolerance(tolerance);
    Picture->SetMesh(MakeFolds(View(*FindProjection(projection), shot.Options), shot, places, add));
    const reference::DrawnPicture drawn = Picture->Draw(shot);
    const reference::RayCaster caster(Picture->GetMesh(), Picture->GetView(), Picture->GetPose());
    const reference::Metrics m = reference::Compare(drawn, caster, tolerance);
    std::cout << projection << " technique " << technique << ": " << m.Mismatched << " mismatched, "
              << m.UnexplainedPixels << " unexplained, " << m.MaxPx << " px" << std::endl;
    EXPECT_GT(std::count_if(drawn.Cell.begin(), drawn.Cell.end(), [](float c) { return c > 0; }),
      places.Count / 16);
    return m;
  }

  static reference::Metrics Compare(
    const std::string& projection, int technique, double tolerance, const Add& add)
  {
    const Shot shot = ShotOf(projection);
    return Compare(shot, technique, tolerance, Everywhere(shot), add);
  }

  static void CheckFaces(const Shot& shot, const FoldPlaces& places, const Add& add)
  {
    constexpr double Tolerance = 0.25;
    const reference::Metrics m = Compare(shot, vtkWideFoVPass::AUTO, Tolerance, places, add);
    const reference::RayCaster caster(Picture->GetMesh(), Picture->GetView(), Picture->GetPose());
    ExpectFacesThatAreThere(caster, shot, m, Tolerance, "folds");
  }

  static void Check(const std::string& projection, int technique, double tolerance, const Add& add)
  {
    EXPECT_LE(Compare(projection, technique, tolerance, add).MaxPx, tolerance) << projection;
  }
};

// Whichever way it is wound.
TEST_P(FoldBeyondTheEdge, FrontHidesBack)
{
  Check(this->GetParam(), vtkWideFoVPass::EXACT, 0.02, Folds(SharpFold, true));
  Check(this->GetParam(), vtkWideFoVPass::AUTO, 0.02, Folds(SharpFold, true));
}

TEST_P(FoldBeyondTheEdge, FrontHidesBackWhereTheyAreNearlyOneFace)
{
  const int exact = vtkWideFoVPass::EXACT;
  Check(this->GetParam(), exact, 0.02, Folds(FlatFold, false));
  const auto lost = [&](Fold (*make)(const Between&), bool bothWays) {
    return Compare(this->GetParam(), exact, 0.02, Folds(make, bothWays)).UnexplainedPixels;
  };
  EXPECT_LE(lost(FlatterFold, false), LostFlatFolds);
  EXPECT_LE(lost(FlatFold, true), LostTurnedFolds);
}

TEST_P(FoldBeyondTheEdge, FrontHidesBackBesideANeedle)
{
  EXPECT_LE(
    Compare(this->GetParam(), vtkWideFoVPass::EXACT, 0.02, Needles(FlatNeedle)).UnexplainedPixels,
    LostNeedles);
}

TEST_P(FoldBeyondTheEdge, FrontHidesAThinBack)
{
  Check(this->GetParam(), vtkWideFoVPass::EXACT, 0.02, ThinBacks());
}

// At a tolerance at which every triangle is ray-tested: `auto` shows what `exact` does.
TEST_P(FoldBeyondTheEdge, FinestToleranceIsExact)
{
  for (const Add& add : { Folds(SharpFold, true), Folds(FlatFold, true), Folds(FlatterFold, true),
         Needles(FlatNeedle), ThinBacks() })
  {
    const auto lost = [&](int technique) {
      return Compare(this->GetParam(), technique, 0.02, add).UnexplainedPixels;
    };
    EXPECT_LE(lost(vtkWideFoVPass::AUTO), lost(vtkWideFoVPass::EXACT)) << this->GetParam();
  }
}

// With chords, either face beside a fold may be seen, but nothing that is not there.
TEST_P(FoldBeyondTheEdge, OneOfTheTwoIsSeenWithChords)
{
  const Shot shot = ShotOf(this->GetParam());
  for (const Add& add : { Folds(SharpFold, false), Folds(SharpestFold, false),
         Folds(FlatFold, false), Needles(FlatNeedle), Needles(SteepNeedle) })
  {
    CheckFaces(shot, Everywhere(shot), add);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FoldBeyondTheEdge,
  ::testing::Values("equirectangular", "mercator", "panini", "hammer", "winkel-tripel",
    "azimuthal-equidistant", "orthographic", "equi-angular-cubemap"),
  DrawingTest::NameOf);

// Beside the poles of a map that stretches them a pixel is a small angle, and a chord is far from
// its edge: a ray passes within its rounding of the edge, and its pixel not so near to the chord.
class FoldBesideAPole : public FoldBeyondTheEdge
{
};

TEST_P(FoldBesideAPole, OneOfTheTwoIsSeenWithChords)
{
  const Shot shot = ShotOf(this->GetParam());
  for (const Add& add : { Folds(SharpFold, false), Folds(SharpestFold, false) })
  {
    CheckFaces(shot, BesideAPole, add);
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, FoldBesideAPole, ::testing::Values("mercator", "miller"), DrawingTest::NameOf);
