// SPDX-License-Identifier: BSD-3-Clause
// Points against their definition in double: a point of n pixels is the square of n pixels
// round the place of its centre, continued across a seam, cut where the map ends. Every pixel
// whose centre is in the square shows the point, or one in front of it; none else does. On a
// direction map the square is round each pixel's centre, in its own map.
#include "DrawingTest.h"
#include "OwnMap.h"
#include "SampledShot.h"
#include "vtkWideFoVPass.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels: what float32, and the grid that a rasterizer snaps to, may do to a place.
constexpr double PointSlack = 0.02;

// Relative: what float32 may do to a distance from the eye.
constexpr double PointDepth = 1e-5;

// Places of the picture, pixels, x from the left and y from the top, and the rows of pixels
// that a square round them may show in.
struct Square
{
  vec2 Centre;
  double Top;
  double Bottom;
};

vec2 ToPixel(vec2 ndc, const Shot& s)
{
  return vec2(0.5 * (1 + ndc.x) * s.Width, 0.5 * (1 - ndc.y) * s.Height);
}

// Where a map of longitude and latitude shows a point beyond the seam.
void Continue(const View& view, const vec3& p, const Square& square, const Shot& shot,
  std::vector<Square>& squares)
{
  const Projection& projection = view.GetProjection();
  const WfvView& v = view.GetParameters();
  const vec2 angles = wfvMeridianAngles(p);
  const double side = square.Centre.x < 0.5 * shot.Width ? -1 : 1;
  Square other = square;
  if (projection.StraightSeam)
  {
    other.Centre.x -= side * shot.Width * projection.Map(vec2(WFV_PI, 0), v).x;
    squares.push_back(other);
  }
  else if (std::abs(angles.x) > 0.5 * WFV_PI)
  {
    const double lambda = side * (std::abs(angles.x) - 2 * WFV_PI);
    other.Centre = ToPixel(projection.Map(vec2(lambda, angles.y), v), shot);
    squares.push_back(other);
  }
}

// The squares of a point in view coordinates.
std::vector<Square> Squares(const View& view, const vec3& point, const Shot& shot, double size)
{
  const Projection& projection = view.GetProjection();
  const vec3 p = wfvTilt(point, view.GetParameters());
  if (projection.FlatRim && p.z > 0)
  {
    return {};
  }
  const vec3 ndc = view.Forward(point).Ndc;
  Square square{ ToPixel(vec2(ndc.x, ndc.y), shot), 0, double(shot.Height) };
  if (projection.Axis == Family::Faces)
  {
    (ndc.y < 0 ? square.Top : square.Bottom) = 0.5 * shot.Height;
  }
  std::vector<Square> squares{ square };
  // a point of one pixel is one pixel
  if (projection.Axis == Family::Meridian && size > 1)
  {
    Continue(view, p, square, shot, squares);
  }
  return squares;
}

struct Candidate
{
  vtkIdType Cell;
  double Rho;
  bool Sure;
};

using Candidates = std::map<long, std::vector<Candidate>>;

void AddSquare(
  const Square& square, const Shot& shot, double size, Candidate candidate, Candidates& all)
{
  const double half = 0.5 * size;
  const vec2 c = square.Centre;
  const auto range = [&](double at, int end, int& first, int& last) {
    first = int(std::max(0.0, std::min(double(end), std::floor(at - half - 1))));
    last = int(std::min(double(end), std::max(0.0, std::ceil(at + half + 1))));
  };
  int i0, i1, j0, j1;
  range(c.x, shot.Width, i0, i1);
  range(c.y, shot.Height, j0, j1);
  const bool known = candidate.Sure;
  for (int j = j0; j < j1; j++)
  {
    for (int i = i0; i < i1; i++)
    {
      const double off = std::max(std::abs(i + 0.5 - c.x), std::abs(j + 0.5 - c.y));
      if (off < half + PointSlack && j + 0.5 > square.Top && j + 0.5 < square.Bottom)
      {
        candidate.Sure = known && off < half - PointSlack;
        all[long(j) * shot.Width + i].push_back(candidate);
      }
    }
  }
}

Candidates Expect(const std::vector<vec3>& points, const View& view, const Shot& shot, double size)
{
  const vec2 radii = view.GetParameters().radii;
  Candidates all;
  for (std::size_t k = 0; k < points.size(); k++)
  {
    const double rho = glm::length(points[k]);
    const bool sure = rho > radii.x * (1 + PointDepth) && rho < radii.y * (1 - PointDepth);
    if (rho > radii.x * (1 - PointDepth) && rho < radii.y * (1 + PointDepth))
    {
      for (const Square& square : Squares(view, points[k], shot, size))
      {
        AddSquare(square, shot, size, { vtkIdType(k), rho, sure }, all);
      }
    }
  }
  return all;
}

// On a direction map: each pixel by its own map.
Candidates ExpectSampled(
  const std::vector<vec3>& points, const View& view, const Shot& shot, double size)
{
  const vec2 radii = view.GetParameters().radii;
  const double half = 0.5 * size;
  Candidates all;
  for (int j = 0; j < shot.Height; j++)
  {
    for (int i = 0; i < shot.Width; i++)
    {
      const reference::OwnMap map(view, i, j, shot.Width, shot.Height);
      for (std::size_t k = 0; map.IsShown() && k < points.size(); k++)
      {
        const double rho = glm::length(points[k]);
        const vec2 at = glm::abs(map.PlaceOf(points[k]));
        const double off = std::max(at.x, at.y);
        if (off < half + PointSlack && rho > radii.x && rho < radii.y)
        {
          all[long(j) * shot.Width + i].push_back({ vtkIdType(k), rho, off < half - PointSlack });
        }
      }
    }
  }
  return all;
}

struct PointResult
{
  long Drawn = 0;
  long Wrong = 0;
  std::string First;
};

// Whether a pixel may show this cell at this distance.
bool Agrees(vtkIdType cell, double distance, const std::vector<Candidate>& candidates)
{
  bool found = cell < 0;
  for (const Candidate& c : candidates)
  {
    found = found || (c.Cell == cell && std::abs(c.Rho - distance) <= PointDepth * std::abs(c.Rho));
    if (c.Sure && (cell < 0 || c.Rho < distance * (1 - 2 * PointDepth)))
    {
      return false;
    }
  }
  return found;
}

PointResult Compare(
  const reference::DrawnPicture& drawn, const Candidates& expected, const View& view)
{
  PointResult result;
  const std::vector<Candidate> none;
  for (long key = 0; key < long(drawn.Width) * drawn.Height; key++)
  {
    const auto found = expected.find(key);
    const auto cell = static_cast<vtkIdType>(drawn.Cell[key]) - 1;
    const int i = int(key % drawn.Width);
    const int j = int(key / drawn.Width);
    result.Drawn += cell >= 0;
    bool inside = false;
    if ((cell < 0 && found == expected.end()) ||
      !reference::IsClear(view, i, j, drawn.Width, drawn.Height, PointSlack, inside))
    {
      continue;
    }
    const auto& candidates = inside && found != expected.end() ? found->second : none;
    if (!Agrees(cell, drawn.Distance[key], candidates))
    {
      result.Wrong++;
      const std::string what = std::to_string(i) + ", " + std::to_string(j) + ": drawn " +
        std::to_string(cell) + " at " + std::to_string(drawn.Distance[key]) + ", expected " +
        (candidates.empty() ? "nothing" : std::to_string(candidates[0].Cell));
      result.First = result.First.empty() ? what : result.First;
    }
  }
  return result;
}

vec3 Direction(double lambda, double phi)
{
  return wfvMeridianDirection(vec2(lambda, phi) * (WFV_PI / 180));
}

// Directions beside everything that tears a map, and others. Degrees.
std::vector<vec3> PointPlaces(const Shot& shot, std::mt19937& generator)
{
  const View view(*FindProjection(shot.Projection), shot.Options);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<vec3> places{ Direction(180, 20), Direction(-180, -50), vec3(1e-3, 1, -1e-3),
    vec3(0, 0, 1) };
  for (int k = 0; k < 12; k++)
  {
    // in the picture, and beside its borders
    const double side = k % 2 ? 1 : -1;
    for (const vec2& ndc : { vec2(u(generator), u(generator)), vec2(0.99 * side, u(generator)),
           vec2(u(generator), 0.98 * side) })
    {
      const ViewRay ray = view.Ray(ndc);
      places.push_back(ray.Inside ? ray.Direction : places[k]);
    }
    places.push_back(Direction(180 + 8 * u(generator), 85 * u(generator)));
    places.push_back(Direction(180 * u(generator), (k % 2 ? 1 : -1) * (90 - 4 * u(generator))));
    places.push_back(Direction(180, 0) + 0.08 * vec3(u(generator), u(generator), 0));
    // beside the rim of a half sphere, and beside the borders of a cube's faces
    places.push_back(vec3(u(generator), u(generator), 0.05 * u(generator)));
    const double a = u(generator);
    vec3 border(u(generator), a, (k % 3 ? 1 : -1) * a * (1 + 0.05 * u(generator)));
    places.push_back(k % 2 ? border : vec3(border.y, border.z, border.x));
    places.push_back(vec3(u(generator), u(generator), u(generator)));
  }
  return places;
}

// As the mapper's buffer has them: single precision.
std::vector<vec3> Points(const Shot& shot, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> distance(0.8, 4.3);
  std::vector<vec3> points;
  for (const vec3& d : PointPlaces(shot, generator))
  {
    const vec3 p = glm::normalize(d) * distance(generator);
    points.push_back(vec3(float(p.x), float(p.y), float(p.z)));
  }
  return points;
}

vtkSmartPointer<vtkPolyData> MakePoints(const std::vector<vec3>& places)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const vec3& p : places)
  {
    cells->InsertNextCell(1);
    cells->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetVerts(cells);
  return mesh;
}
}

class ComparePoints : public DrawingTest
{
protected:
  static inline long Drawn = 0; // pixels of all shots of a projection

  static void Check(const Shot& shot, int technique, unsigned int seed, double size)
  {
    const std::vector<vec3> points = Points(shot, seed);
    Picture->SetMesh(MakePoints(points));
    Picture->SetPointSize(size);
    Picture->SetTechnique(technique);
    const reference::DrawnPicture picture = Picture->Draw(shot);
    ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
    const View& view = Picture->GetView();
    const auto expect = view.GetProjection().Axis == Family::Sampled ? ExpectSampled : Expect;
    const PointResult r = Compare(picture, expect(points, view, shot, size), view);
    std::cout << shot.Projection << " " << shot.Options.HorizontalFov << " technique " << technique
              << " size " << size << ": drawn " << r.Drawn << " wrong " << r.Wrong << std::endl;
    Drawn += r.Drawn;
    EXPECT_EQ(r.Wrong, 0) << "seed " << seed << " size " << size << " " << Describe(shot) << "\n  "
                          << r.First;
  }
};

TEST_P(ComparePoints, EveryPixelOfTheSquare)
{
  const Projection& p = *FindProjection(this->GetParam());
  Drawn = 0;
  for (double share : { 1.0, 0.4 })
  {
    Shot shot;
    shot.Projection = p.Name;
    shot.Options.HorizontalFov = std::max(p.MinHorizontalFov, share * p.MaxHorizontalFov);
    shot.Options.VerticalFov = std::max(p.MinVerticalFov, share * p.MaxVerticalFov);
    shot.Options.Radii = { { 1, 4 } };
    unsigned int seed = 1;
    for (double size : { 1.0, 2.0, 5.0, 20.0 })
    {
      for (int technique : { vtkWideFoVPass::EXACT, vtkWideFoVPass::PRECLIP, vtkWideFoVPass::AUTO })
      {
        Check(shot, technique, seed++, size);
      }
    }
  }
  EXPECT_GT(Drawn, 10000);
}

// On maps made of projections, torn at their seams and poles.
class CompareSampledPoints : public ComparePoints
{
};

TEST_P(CompareSampledPoints, EveryPixelOfTheSquare)
{
  Drawn = 0;
  Shot shot;
  UseMapOf(this->GetParam(), shot);
  shot.Options.Radii = { { 1, 4 } };
  unsigned int seed = 1;
  for (double size : { 1.0, 5.0, 20.0 })
  {
    for (int technique : { vtkWideFoVPass::EXACT, vtkWideFoVPass::PRECLIP, vtkWideFoVPass::AUTO })
    {
      Check(shot, technique, seed++, size);
    }
  }
  EXPECT_GT(Drawn, 5000);
}

INSTANTIATE_TEST_SUITE_P(All, ComparePoints, ::testing::ValuesIn(WideNames()), DrawingTest::NameOf);
INSTANTIATE_TEST_SUITE_P(All, CompareSampledPoints,
  ::testing::Values("equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap"),
  DrawingTest::NameOf);
