// SPDX-License-Identifier: BSD-3-Clause
// Lines of the technique exact against the reference in double: every pixel whose centre
// is nearer to a line than half its width is drawn, none that is farther, with the cell
// and the distance of the nearest line's nearest point.
#include "DrawingTest.h"
#include "LineReference.h"
#include "vtkWideFoVPass.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <iostream>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels: what float32 and the samples' own shift may do to a distance.
constexpr double LineSlack = 0.02;

// Relative: what float32 may do to a distance from the eye.
constexpr double LineDepth = 1e-5;

struct LineScene
{
  std::string Name;
  std::vector<std::vector<vec3>> Lines;
};

vtkSmartPointer<vtkPolyData> MakeLines(const LineScene& scene)
{
  vtkNew<vtkPoints> points; // single precision, as the mapper's buffers
  vtkNew<vtkCellArray> cells;
  for (const std::vector<vec3>& line : scene.Lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const vec3& p : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetLines(cells);
  return mesh;
}

struct LineResult
{
  long Drawn = 0;
  long Missing = 0;
  long Spurious = 0;
  long Hidden = 0; // another line is in front
  long Depth = 0;
  double WorstDepth = 0;
  std::string First; // the first wrong pixel
};

// By how much a distance is not that of a line's nearest point, relative.
double Off(const reference::NearLine& line, double rho)
{
  return std::max({ line.RhoMin - rho, rho - line.RhoMax, 0.0 }) / rho;
}

class LineCheck
{
public:
  LineCheck(const reference::DrawnPicture& drawn, const View& view, double width)
    : Drawn(drawn)
    , TheView(view)
    , Half(0.5 * width)
  {
  }

  LineResult Check(const reference::LinePicture& lines);

private:
  bool IsSure(const reference::NearLine& line) const
  {
    const vec2 radii = this->TheView.GetParameters().radii;
    return line.Distance < this->Half - LineSlack && line.RhoMin > radii.x * (1 + LineDepth) &&
      line.RhoMax < radii.y * (1 - LineDepth);
  }

  bool IsPossible(const reference::NearLine& line) const
  {
    const vec2 radii = this->TheView.GetParameters().radii;
    return line.Distance < this->Half + LineSlack && line.RhoMax > radii.x * (1 - LineDepth) &&
      line.RhoMin < radii.y * (1 + LineDepth);
  }

  void CheckPixel(long key, const std::vector<reference::NearLine>& lines);
  void CheckDepth(
    long key, const reference::NearLine& line, const std::vector<reference::NearLine>& lines);
  void Count(long& which, const char* what, long key, const reference::NearLine* line);

  const reference::DrawnPicture& Drawn;
  const View& TheView;
  double Half;
  LineResult Result;
};

void LineCheck::Count(long& which, const char* what, long key, const reference::NearLine* line)
{
  which++;
  if (this->Result.First.empty())
  {
    char text[300];
    std::snprintf(text, sizeof text,
      "%s at (%ld, %ld): drawn cell %g at %.9g, reference cell %lld distance %.4f px rho "
      "%.9g..%.9g",
      what, key % this->Drawn.Width, key / this->Drawn.Width, this->Drawn.Cell[key],
      this->Drawn.Distance[key], line ? (long long)line->Cell + 1 : -1,
      line ? line->Distance : -1.0, line ? line->RhoMin : 0.0, line ? line->RhoMax : 0.0);
    this->Result.First = text;
  }
}

void LineCheck::CheckDepth(
  long key, const reference::NearLine& line, const std::vector<reference::NearLine>& lines)
{
  const double rho = this->Drawn.Distance[key];
  const double off = Off(line, rho);
  this->Result.WorstDepth = std::max(this->Result.WorstDepth, off);
  if (off > LineDepth)
  {
    this->Count(this->Result.Depth, "depth", key, &line);
  }
  for (const reference::NearLine& other : lines)
  {
    if (this->IsSure(other) && other.RhoMax < rho * (1 - 2 * LineDepth))
    {
      this->Count(this->Result.Hidden, "order", key, &other);
    }
  }
}

void LineCheck::CheckPixel(long key, const std::vector<reference::NearLine>& lines)
{
  const auto cell = static_cast<vtkIdType>(this->Drawn.Cell[key]) - 1;
  const reference::NearLine* best = nullptr;
  const reference::NearLine* sure = nullptr;
  for (const reference::NearLine& line : lines)
  {
    const double rho = this->Drawn.Distance[key];
    const bool fits = line.Cell == cell && this->IsPossible(line);
    best = fits && (!best || Off(line, rho) < Off(*best, rho)) ? &line : best;
    sure = this->IsSure(line) ? &line : sure;
  }
  if (cell < 0 && sure)
  {
    this->Count(this->Result.Missing, "missing", key, sure);
  }
  else if (cell >= 0 && !best)
  {
    this->Count(this->Result.Spurious, "spurious", key, lines.empty() ? nullptr : &lines[0]);
  }
  else if (cell >= 0)
  {
    this->CheckDepth(key, *best, lines);
  }
}

LineResult LineCheck::Check(const reference::LinePicture& lines)
{
  const long pixels = long(this->Drawn.Width) * this->Drawn.Height;
  const std::vector<reference::NearLine> none;
  for (long key = 0; key < pixels; key++)
  {
    const auto found = lines.find(key);
    const bool drawn = this->Drawn.Cell[key] > 0;
    this->Result.Drawn += drawn;
    if (!drawn && found == lines.end())
    {
      continue;
    }
    bool inside = false;
    if (IsClear(this->TheView, int(key % this->Drawn.Width), int(key / this->Drawn.Width),
          this->Drawn.Width, this->Drawn.Height, LineSlack, inside))
    {
      this->CheckPixel(key, found == lines.end() || !inside ? none : found->second);
    }
  }
  return this->Result;
}

void Check(Drawing& drawing, const Shot& shot, const LineScene& scene, double width)
{
  drawing.SetMesh(MakeLines(scene));
  drawing.SetLineWidth(width);
  drawing.SetTechnique(vtkWideFoVPass::EXACT);
  const reference::DrawnPicture picture = drawing.Draw(shot);
  ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
  const auto segments = reference::Segments(drawing.GetMesh(), drawing.GetPose());
  const auto lines =
    reference::RenderLines(segments, drawing.GetView(), shot.Width, shot.Height, 0.5 * width + 1);
  const LineResult r = LineCheck(picture, drawing.GetView(), width).Check(lines);
  std::cout << shot.Projection << " " << scene.Name << " width " << width << ": drawn " << r.Drawn
            << " missing " << r.Missing << " spurious " << r.Spurious << " order " << r.Hidden
            << " depth " << r.Depth << " worst " << r.WorstDepth << std::endl;
  // the dot of a line that points at the eye may fall between the centres of pixels, and what
  // lies behind the eye may have no place in the map
  const bool seen = width > 1 && shot.Options.HorizontalFov == 360;
  EXPECT_GT(seen ? r.Drawn : 1, 0) << scene.Name;
  EXPECT_EQ(r.Missing + r.Spurious + r.Hidden + r.Depth, 0)
    << scene.Name << " width " << width << " " << Describe(shot) << "\n  " << r.First;
}

// Segments in no direction in particular, short and long, near and far.
LineScene RandomLines(unsigned int seed, int count, double longest)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::uniform_real_distribution<double> share(0, 1);
  LineScene scene;
  scene.Name = "random " + std::to_string(seed) + " up to " + std::to_string(longest);
  while (int(scene.Lines.size()) < count)
  {
    const vec3 a(uniform(generator), uniform(generator), uniform(generator));
    const vec3 b(uniform(generator), uniform(generator), uniform(generator));
    scene.Lines.push_back({ a, a + (b - a) * longest * std::pow(share(generator), 3.0) });
  }
  return scene;
}

// One line a scene: what may go wrong shows alone.
std::vector<LineScene> NastyLines()
{
  std::vector<LineScene> all{
    { "over the pole", { { vec3(0.5, 1, -0.25), vec3(-1, 2, 0.5) } } },
    { "down the pole", { { vec3(0, 1, -1), vec3(0, 1, 2) } } },
    { "from the pole", { { vec3(0, 1, 0), vec3(1, 0, -1) } } },
    { "over the antipode", { { vec3(0.5, 0.25, 1), vec3(-1, -0.5, 2) } } },
    { "from the antipode", { { vec3(0, 0, 1), vec3(1, 0.5, -0.3) } } },
    { "along the seam", { { vec3(0, -0.5, 1), vec3(0, 0.8, 1.5) } } },
    { "across the seam", { { vec3(-0.5, 0.3, 1), vec3(0.7, -0.2, 1.2) } } },
    { "through the eye", { { vec3(0.3, 0.2, -1), vec3(-0.6, -0.4, 2) } } },
    { "towards the eye", { { vec3(0.3, 0.2, -1), vec3(0.6, 0.4, -2) } } },
    { "a point", { { vec3(0.3, 0.2, -1), vec3(0.3, 0.2, -1) } } },
    { "past the eye", { { vec3(1, 0.05, 0.3), vec3(-1, 0.05, 0.3) } } },
    { "close past the eye", { { vec3(1, 1e-3, -0.7), vec3(-1.1, 1e-3, 0.7) } } },
    { "level", { { vec3(1, 0, -1), vec3(-1, 0, -0.4) } } },
    { "half round", { { vec3(1, 0.01, 0.02), vec3(-1, 0.3, 0.02) } } },
    { "broken",
      { { vec3(1, 0.2, -1), vec3(0.2, 0.9, -0.4), vec3(-0.3, 0.9, 0.3), vec3(-1, -0.6, 0.2),
        vec3(0.8, -0.8, 0.9) } } },
  };
  for (double aside : { 1e-4, 1e-3, 1e-2, 0.05, 0.2 })
  {
    const std::string by = std::to_string(aside);
    all.push_back({ "past the pole by " + by, { { vec3(1, 1, aside), vec3(-0.7, 1, aside) } } });
    all.push_back(
      { "past the nadir by " + by, { { vec3(0.3, -1, aside), vec3(-0.7, -1.2, aside) } } });
    all.push_back(
      { "past the antipode by " + by, { { vec3(1, aside, 1), vec3(-0.7, aside, 1) } } });
  }
  return all;
}

Shot LineShot(const std::string& projection, int width)
{
  Shot s;
  s.Projection = projection;
  s.Width = width;
  s.Height = width / 2;
  s.Options.HorizontalFov = FindProjection(projection)->MaxHorizontalFov;
  s.Options.VerticalFov = FindProjection(projection)->MaxVerticalFov;
  s.Options.Radii = { { 0.02, 4 } };
  return s;
}
}

class CompareLines : public DrawingTest
{
};

TEST_P(CompareLines, Nasty)
{
  for (const LineScene& scene : NastyLines())
  {
    for (double width : { 1.0, 3.0, 20.0 })
    {
      Check(*Picture, LineShot(this->GetParam(), 1024), scene, width);
    }
  }
}

TEST_P(CompareLines, Random)
{
  for (unsigned int seed = 1; seed <= 12; seed++)
  {
    const double width = seed % 3 == 0 ? 1 : (seed % 3 == 1 ? 4 : 13);
    Check(*Picture, LineShot(this->GetParam(), 1024), RandomLines(seed, 12, 1), width);
  }
}

INSTANTIATE_TEST_SUITE_P(All, CompareLines,
  ::testing::Values("equirectangular", "hammer", "azimuthal-equidistant", "panini", "orthographic",
    "equi-angular-cubemap"),
  DrawingTest::NameOf);
