// SPDX-License-Identifier: BSD-3-Clause
#include "LineCheck.h"

#include "LineReference.h"
#include "SampledLines.h"
#include "vtkWideFoVPass.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace wfv
{
namespace test
{
namespace
{
// Pixels: what float32 and the samples' own shift may do to a distance.
constexpr double LineSlack = 0.02;

// Pixels outside a line within which the reference says how far it is.
constexpr double Beyond = 4;

// Relative: what float32 may do to a distance from the eye.
constexpr double LineDepth = 1e-5;

// Pixels: of the technique auto, by default.
constexpr double AutoTolerance = 0.25;

// Pixels: what the rasterizer's own grid may do to a chord.
constexpr double ChordSnap = 0.0625;

// Pixels: half of a line of one pixel that the hardware draws from corner to corner of pixels.
constexpr double ThinLine = 0.5;

// Relative: what a shift within the tolerance does to the distance of a line that is seen aslant.
constexpr double ChordDepth = 2e-3;

// Share of the pixels of chords: where two of them meet, and where a line ends, the rule by which
// the hardware chooses pixels leaves one out now and then, or draws one that is beyond an end; and
// lines that are dots, both ends.
constexpr double ChordGaps = 0.02;
constexpr long FewGaps = 6;

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

// By how much a distance is not that of a line's nearest point, relative.
double Off(const reference::NearLine& line, double rho, double beyond)
{
  const double more = beyond * (line.RhoMax - line.RhoMin);
  return std::max({ line.RhoMin - more - rho, rho - line.RhoMax - more, 0.0 }) / rho;
}

const reference::NearLine* Nearest(const std::vector<reference::NearLine>& lines)
{
  const reference::NearLine* nearest = nullptr;
  for (const reference::NearLine& line : lines)
  {
    nearest = !nearest || line.Distance < nearest->Distance ? &line : nearest;
  }
  return nearest;
}

class LineCheck
{
public:
  LineCheck(
    const reference::DrawnPicture& drawn, const View& view, double width, const LineRules& rules)
    : Drawn(drawn)
    , TheView(view)
    , Half(0.5 * width)
    , Rules(rules)
  {
  }

  LineResult Check(const reference::LinePicture& lines);

private:
  bool IsSure(const reference::NearLine& line) const
  {
    const vec2 radii = this->TheView.GetParameters().radii;
    return line.Distance < this->Half - this->Rules.Inside &&
      line.RhoMin > radii.x * (1 + this->Rules.Depth) &&
      line.RhoMax < radii.y * (1 - this->Rules.Depth);
  }

  bool IsPossible(const reference::NearLine& line) const
  {
    const vec2 radii = this->TheView.GetParameters().radii;
    return line.Distance < this->Half + this->Rules.Outside &&
      line.RhoMax > radii.x * (1 - this->Rules.Depth) &&
      line.RhoMin < radii.y * (1 + this->Rules.Depth);
  }

  void CheckPixel(long key, const std::vector<reference::NearLine>& lines);
  void CheckDepth(
    long key, const reference::NearLine& line, const std::vector<reference::NearLine>& lines);
  void CountOff(long& which, const char* what, long key, const reference::NearLine* line);
  void Count(long& which, const char* what, long key, const reference::NearLine* line);

  const reference::DrawnPicture& Drawn;
  const View& TheView;
  double Half;
  LineRules Rules;
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

// The same of a pixel on the wrong side of a line's border; Beyond where no line is near.
void LineCheck::CountOff(long& which, const char* what, long key, const reference::NearLine* line)
{
  const double off = line ? std::abs(line->Distance - this->Half) : Beyond;
  this->Result.WorstPixels = std::max(this->Result.WorstPixels, off);
  this->Count(which, what, key, line);
}

void LineCheck::CheckDepth(
  long key, const reference::NearLine& line, const std::vector<reference::NearLine>& lines)
{
  const double rho = this->Drawn.Distance[key];
  const double off = Off(line, rho, this->Rules.Beyond);
  this->Result.WorstDepth = std::max(this->Result.WorstDepth, off);
  if (off > this->Rules.Depth)
  {
    this->Count(this->Result.Depth, "depth", key, &line);
  }
  for (const reference::NearLine& other : lines)
  {
    if (this->IsSure(other) && other.RhoMax < rho * (1 - 2 * this->Rules.Depth))
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
    best = fits && (!best || Off(line, rho, 0) < Off(*best, rho, 0)) ? &line : best;
    sure = this->IsSure(line) ? &line : sure;
  }
  if (cell < 0 && sure)
  {
    this->CountOff(this->Result.Missing, "missing", key, sure);
  }
  else if (cell >= 0 && !best)
  {
    this->CountOff(this->Result.Spurious, "spurious", key, Nearest(lines));
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
    if (reference::IsClear(this->TheView, int(key % this->Drawn.Width),
          int(key / this->Drawn.Width), this->Drawn.Width, this->Drawn.Height,
          std::max(this->Rules.Inside, this->Rules.Outside), inside))
    {
      this->CheckPixel(key, found == lines.end() || !inside ? none : found->second);
    }
  }
  return this->Result;
}
}

LineRules StripRules()
{
  return { vtkWideFoVPass::EXACT, LineSlack, LineSlack, reference::NearestSlack, LineDepth, 0,
    false };
}

LineRules ChordRules(double width)
{
  // a chord is as wide along rows or columns, so across its own way it is thinner where it slants
  const double tolerance = AutoTolerance + ChordSnap;
  const double slant = 0.5 * width * (1 - std::sqrt(0.5));
  return { vtkWideFoVPass::AUTO, slant + tolerance, ThinLine + tolerance, 1 + tolerance, ChordDepth,
    1, true };
}

LineResult CheckLines(
  Drawing& drawing, const Shot& shot, const LineScene& scene, double width, const LineRules& rules)
{
  drawing.SetMesh(MakeLines(scene));
  drawing.SetLineWidth(width);
  drawing.SetTechnique(rules.Technique);
  const reference::DrawnPicture picture = drawing.Draw(shot);
  EXPECT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
  if (picture.Width != shot.Width)
  {
    return {};
  }
  const auto segments = reference::Segments(drawing.GetMesh(), drawing.GetPose());
  const bool sampled = drawing.GetView().GetProjection().Axis == Family::Sampled;
  const double reach = 0.5 * width + Beyond;
  const View& view = drawing.GetView();
  const auto render = sampled ? reference::RenderSampledLines : reference::RenderLines;
  const auto lines = render(segments, view, shot.Width, shot.Height, reach, rules.Nearest);
  const LineResult r = LineCheck(picture, view, width, rules).Check(lines);
  std::cout << shot.Projection << " " << scene.Name << " width " << width << ": drawn " << r.Drawn
            << " missing " << r.Missing << " spurious " << r.Spurious << " order " << r.Hidden
            << " depth " << r.Depth << " worst " << r.WorstDepth << ", " << r.WorstPixels << " px"
            << std::endl;
  // the dot of a line that points at the eye may fall between the centres of pixels, and what
  // lies behind the eye may have no place in the map
  const bool seen = width > 1 && shot.Options.HorizontalFov == 360;
  EXPECT_GT(seen ? r.Drawn : 1, 0) << scene.Name;
  const double gaps = std::max<double>(FewGaps, ChordGaps * static_cast<double>(r.Drawn));
  const bool few = rules.Gaps && static_cast<double>(r.Missing + r.Depth) <= gaps;
  EXPECT_EQ((few ? 0 : r.Missing + r.Depth) + r.Spurious + r.Hidden, 0)
    << scene.Name << " width " << width << " " << Describe(shot) << "\n  " << r.First;
  return r;
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
}
