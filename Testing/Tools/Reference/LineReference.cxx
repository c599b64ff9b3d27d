// SPDX-License-Identifier: BSD-3-Clause
#include "LineReference.h"

#include "LineArc.h"

#include <vtkIdList.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace reference
{
namespace
{
// Pixels between consecutive samples, at the most.
constexpr double Step = 0.1;

// Samples to begin with, so that no turn of the image is stepped over: of half a great circle,
// and at least.
constexpr int FirstSamples = 2048;
constexpr int LeastSamples = 64;

// Pixels outside the picture, over the reach: whether lines are there does not matter, and
// some maps go on to infinity.
constexpr double Beyond = 2;

double Apart(const Sample& a, const Sample& b, double period)
{
  double dx = b.Pixel.x - a.Pixel.x;
  dx -= period > 0 ? period * std::round(dx / period) : 0;
  return std::hypot(dx, b.Pixel.y - a.Pixel.y);
}

// True where a stretch lies on one side of the window, out of reach.
bool IsBeyond(const Sample& a, const Sample& b, const Window& w)
{
  const double out = w.Reach + Beyond;
  return std::max(a.Pixel.x, b.Pixel.x) < -out || std::min(a.Pixel.x, b.Pixel.x) > w.Width + out ||
    std::max(a.Pixel.y, b.Pixel.y) < -out || std::min(a.Pixel.y, b.Pixel.y) > w.Height + out;
}

bool IsCoarse(const Arc& arc, const Sample& a, const Sample& b)
{
  if (!a.Counts || !b.Counts)
  {
    return a.Counts != b.Counts;
  }
  return Apart(a, b, arc.GetPeriod()) > Step && !IsBeyond(a, b, arc.GetWindow());
}

// Appends what lies behind `from` up to and including `to`.
void Refine(const Arc& arc, const Sample& from, const Sample& to, std::vector<Sample>& samples)
{
  if (IsCoarse(arc, from, to) && to.Angle - from.Angle > arc.GetShortest())
  {
    const Sample middle = arc.At(0.5 * (from.Angle + to.Angle));
    Refine(arc, from, middle, samples);
    Refine(arc, middle, to, samples);
    return;
  }
  samples.push_back(to);
}

std::vector<Sample> Samples(const Arc& arc)
{
  // an end at a pole has no azimuth: its image is that of the arc beside it
  const double inset = arc.GetShortest();
  std::vector<Sample> samples{ arc.At(arc.IsDots() ? 0 : inset) };
  if (arc.IsDots())
  {
    if (arc.GetSpan() > 0)
    {
      samples.push_back(arc.At(arc.GetSpan()));
    }
    return samples;
  }
  const int count = std::max(LeastSamples, int(FirstSamples * arc.GetSpan() / WFV_PI));
  for (int i = 1; i <= count; i++)
  {
    const Sample from = samples.back();
    Refine(arc, from, arc.At(std::min(arc.GetSpan() * i / count, arc.GetSpan() - inset)), samples);
  }
  return samples;
}

// Calls f(pixel key, distance) for the pixels near a short stretch.
template <typename F>
void ForPixels(const Sample& a, const Sample& b, const Window& w, F&& f)
{
  const vec2 d = b.Pixel - a.Pixel;
  const double l2 = glm::dot(d, d);
  const vec2 low = glm::max(w.Low, glm::min(a.Pixel, b.Pixel) - w.Reach);
  const vec2 high = glm::min(w.High, glm::max(a.Pixel, b.Pixel) + w.Reach);
  if (low.x > high.x || low.y > high.y)
  {
    return; // what is far outside is no number of a pixel
  }
  for (int j = int(std::ceil(low.y - 0.5)); j + 0.5 <= high.y; j++)
  {
    for (int i = int(std::ceil(low.x - 0.5)); i + 0.5 <= high.x; i++)
    {
      const vec2 p = vec2(i + 0.5, j + 0.5) - a.Pixel;
      const double t = l2 > 0 ? std::min(1.0, std::max(0.0, glm::dot(p, d) / l2)) : 0;
      const double distance = glm::length(p - t * d);
      if (distance <= w.Reach)
      {
        f(long(j) * long(w.Width) + i, distance);
      }
    }
  }
}

// Calls f(pixel key, distance, a, b) for all stretches a, b of a line, also as they appear
// across a straight seam.
template <typename F>
void ForLine(const Arc& arc, const std::vector<Sample>& samples, F&& f)
{
  const double period = arc.GetPeriod();
  for (std::size_t i = 0; i < samples.size(); i++)
  {
    const Sample& a = samples[i];
    if (!a.Counts)
    {
      continue;
    }
    Sample b = samples[i + 1 < samples.size() ? i + 1 : i];
    b = b.Counts ? b : a;
    b.Pixel.x -= period > 0 ? period * std::round((b.Pixel.x - a.Pixel.x) / period) : 0;
    b = Apart(a, b, 0) > 2 * Step ? a : b; // the image jumps
    for (int turn = period > 0 ? -1 : 0; turn <= (period > 0 ? 1 : 0); turn++)
    {
      Sample c = a;
      Sample d = b;
      c.Pixel.x += turn * period;
      d.Pixel.x += turn * period;
      ForPixels(c, d, arc.GetWindow(), [&](long key, double distance) { f(key, distance, c, d); });
    }
  }
}
}

std::vector<Segment> Segments(vtkPolyData* polyData, const Pose& m)
{
  const auto toView = [&m](const double p[3]) {
    return vec3(m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3],
      m[4] * p[0] + m[5] * p[1] + m[6] * p[2] + m[7],
      m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11]);
  };
  std::vector<Segment> segments;
  vtkNew<vtkIdList> ids;
  vtkCellArray* lines = polyData->GetLines();
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); cell++)
  {
    lines->GetCellAtId(cell, ids);
    for (vtkIdType k = 0; k + 1 < ids->GetNumberOfIds(); k++)
    {
      segments.push_back({ toView(polyData->GetPoint(ids->GetId(k))),
        toView(polyData->GetPoint(ids->GetId(k + 1))), cell + polyData->GetNumberOfVerts() });
    }
  }
  return segments;
}

namespace
{
// Adds what one line shows in a window.
void AddLine(const Arc& arc, vtkIdType cell, double nearest, LinePicture& picture)
{
  const std::vector<Sample> samples = Samples(arc);
  std::unordered_map<long, NearLine> near;
  const auto shortest = [&](long key, double distance, const Sample&, const Sample&) {
    NearLine& line = near[key];
    line.Cell = cell;
    line.Distance = std::min(line.Distance, distance);
  };
  const auto range = [&](long key, double distance, const Sample& a, const Sample& b) {
    NearLine& line = near[key];
    if (distance <= line.Distance + nearest)
    {
      line.RhoMin = std::min({ line.RhoMin, a.Rho, b.Rho });
      line.RhoMax = std::max({ line.RhoMax, a.Rho, b.Rho });
    }
  };
  ForLine(arc, samples, shortest);
  ForLine(arc, samples, range);
  for (const auto& entry : near)
  {
    picture[entry.first].push_back(entry.second);
  }
}
}

LinePicture RenderLines(const std::vector<Segment>& segments, const View& view, int width,
  int height, double reach, double nearest)
{
  Window window;
  window.Width = window.High.x = width;
  window.Height = window.High.y = height;
  window.Reach = reach;
  const bool faces = view.GetProjection().Axis == Family::Faces;
  LinePicture picture;
  for (int face = 0; face < (faces ? 6 : 1); face++)
  {
    const FaceMap map(view, face);
    if (faces)
    {
      window.Low = vec2(width * (face % 3) / 3., face < 3 ? 0 : 0.5 * height);
      window.High = window.Low + vec2(width / 3., 0.5 * height);
    }
    for (const Segment& segment : segments)
    {
      AddLine(Arc(segment, view, window, faces ? &map : nullptr), segment.Cell, nearest, picture);
    }
  }
  return picture;
}
}
}
