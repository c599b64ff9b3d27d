// SPDX-License-Identifier: BSD-3-Clause
#include "LineReference.h"

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

// Samples to begin with, so that no turn of the image is stepped over.
constexpr int FirstSamples = 2048;

// Radians: a stretch so short is not parted further; what is still far apart is a jump.
constexpr double ShortestStretch = 1e-12;

struct Sample
{
  double Angle = 0;
  vec2 Pixel{ 0 };
  double Rho = 0;
};

// The line as an arc about the eye.
class Arc
{
public:
  Arc(const Segment& segment, const View& view, int width, int height);

  double GetSpan() const { return this->Span; }
  bool IsDots() const { return this->Dots; }
  double GetShortest() const { return this->Shortest; }
  double GetPeriod() const { return this->Period; }
  Sample At(double angle) const;

private:
  vec2 PixelOf(const vec3& direction) const;

  const View* TheView;
  double Size[2];
  vec3 From;
  vec3 To;
  vec3 First;  // the direction of From
  vec3 Second; // at a right angle to it, towards To
  double Span = 0;
  double Shortest = ShortestStretch;
  double Period = 0; // pixels, 0 where the map does not close across a straight seam
  bool Dots = false;
};

// Sine below which a line counts as pointing at the eye: float32's, as the picture's.
constexpr double Radial = 4e-7;

Arc::Arc(const Segment& s, const View& view, int width, int height)
  : TheView(&view)
  , Size{ double(width), double(height) }
  , From(s.From)
  , To(s.To)
{
  const bool atEye = !(glm::length(s.From) > 0);
  this->First = glm::normalize(atEye ? s.To : s.From);
  const vec3 base = glm::length(s.To - s.From) < glm::length(s.To) ? s.To - s.From : s.To;
  const vec3 across = base - this->First * glm::dot(this->First, base);
  const double sine = glm::length(across);
  if (atEye || sine <= Radial * glm::length(base))
  {
    this->Dots = true;
    this->Span = !atEye && glm::dot(s.From, s.To) < 0 ? WFV_PI : 0;
    return;
  }
  this->Second = across / sine;
  this->Span = std::atan2(sine, glm::dot(this->First, s.To));
  const Projection& p = view.GetProjection();
  const WfvView& v = view.GetParameters();
  const vec3 normal = wfvTilt(glm::cross(this->First, this->Second), v);
  const double aside = p.Axis == Family::Meridian ? normal.y : normal.z;
  this->Shortest = std::abs(aside) <= ThroughPole ? 2 * ThroughPole : ShortestStretch;
  if (p.Axis == Family::Meridian && p.StraightSeam)
  {
    this->Period = width * p.Map(vec2(WFV_PI, 0), v).x;
  }
}

vec2 Arc::PixelOf(const vec3& direction) const
{
  const vec3 ndc = this->TheView->Forward(direction).Ndc;
  return vec2(0.5 * (1 + ndc.x) * this->Size[0], 0.5 * (1 - ndc.y) * this->Size[1]);
}

Sample Arc::At(double angle) const
{
  Sample s;
  s.Angle = angle;
  if (this->Dots)
  {
    const vec3 end = angle > 0 || !(glm::length(this->From) > 0) ? this->To : this->From;
    s.Rho = glm::length(end);
    s.Pixel = this->PixelOf(glm::normalize(end));
    return s;
  }
  const vec3 direction = std::cos(angle) * this->First + std::sin(angle) * this->Second;
  s.Pixel = this->PixelOf(direction);
  const double a = std::sin(angle) * glm::length(this->From);
  const double b = std::sin(this->Span - angle) * glm::length(this->To);
  const double t = angle <= 0 ? 0 : (angle >= this->Span ? 1 : a / (a + b));
  s.Rho = glm::length(this->From + t * (this->To - this->From));
  return s;
}

double Apart(const Sample& a, const Sample& b, double period)
{
  double dx = b.Pixel.x - a.Pixel.x;
  dx -= period > 0 ? period * std::round(dx / period) : 0;
  return std::hypot(dx, b.Pixel.y - a.Pixel.y);
}

// Appends what lies behind `from` up to and including `to`.
void Refine(const Arc& arc, const Sample& from, const Sample& to, std::vector<Sample>& samples)
{
  if (Apart(from, to, arc.GetPeriod()) > Step && to.Angle - from.Angle > arc.GetShortest())
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
  for (int i = 1; i <= FirstSamples; i++)
  {
    const Sample from = samples.back();
    Refine(arc, from, arc.At(std::min(arc.GetSpan() * i / FirstSamples, arc.GetSpan() - inset)),
      samples);
  }
  return samples;
}

// Calls f(pixel key, distance) for the pixels near a short stretch.
template <typename F>
void ForPixels(const Sample& a, const Sample& b, int width, int height, double reach, F&& f)
{
  const vec2 d = b.Pixel - a.Pixel;
  const double l2 = glm::dot(d, d);
  const int i0 = std::max(0, int(std::floor(std::min(a.Pixel.x, b.Pixel.x) - reach)));
  const int i1 = std::min(width - 1, int(std::ceil(std::max(a.Pixel.x, b.Pixel.x) + reach)));
  const int j0 = std::max(0, int(std::floor(std::min(a.Pixel.y, b.Pixel.y) - reach)));
  const int j1 = std::min(height - 1, int(std::ceil(std::max(a.Pixel.y, b.Pixel.y) + reach)));
  for (int j = j0; j <= j1; j++)
  {
    for (int i = i0; i <= i1; i++)
    {
      const vec2 p = vec2(i + 0.5, j + 0.5) - a.Pixel;
      const double t = l2 > 0 ? std::min(1.0, std::max(0.0, glm::dot(p, d) / l2)) : 0;
      const double distance = glm::length(p - t * d);
      if (distance <= reach)
      {
        f(long(j) * width + i, distance);
      }
    }
  }
}

// Calls f(pixel key, distance, a, b) for all stretches a, b of a line, also as they appear
// across a straight seam.
template <typename F>
void ForLine(
  const Arc& arc, const std::vector<Sample>& samples, int width, int height, double reach, F&& f)
{
  const double period = arc.GetPeriod();
  for (std::size_t i = 0; i < samples.size(); i++)
  {
    const Sample& a = samples[i];
    Sample b = samples[i + 1 < samples.size() ? i + 1 : i];
    b.Pixel.x -= period > 0 ? period * std::round((b.Pixel.x - a.Pixel.x) / period) : 0;
    b = Apart(a, b, 0) > 2 * Step ? a : b; // the image jumps
    for (int turn = period > 0 ? -1 : 0; turn <= (period > 0 ? 1 : 0); turn++)
    {
      Sample c = a;
      Sample d = b;
      c.Pixel.x += turn * period;
      d.Pixel.x += turn * period;
      ForPixels(
        c, d, width, height, reach, [&](long key, double distance) { f(key, distance, c, d); });
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

LinePicture RenderLines(
  const std::vector<Segment>& segments, const View& view, int width, int height, double reach)
{
  LinePicture picture;
  for (const Segment& segment : segments)
  {
    const Arc arc(segment, view, width, height);
    const std::vector<Sample> samples = Samples(arc);
    std::unordered_map<long, NearLine> near;
    const auto shortest = [&](long key, double distance, const Sample&, const Sample&) {
      NearLine& line = near[key];
      line.Cell = segment.Cell;
      line.Distance = std::min(line.Distance, distance);
    };
    const auto range = [&](long key, double distance, const Sample& a, const Sample& b) {
      NearLine& line = near[key];
      if (distance <= line.Distance + NearestSlack)
      {
        line.RhoMin = std::min({ line.RhoMin, a.Rho, b.Rho });
        line.RhoMax = std::max({ line.RhoMax, a.Rho, b.Rho });
      }
    };
    ForLine(arc, samples, width, height, reach, shortest);
    ForLine(arc, samples, width, height, reach, range);
    for (const auto& entry : near)
    {
      picture[entry.first].push_back(entry.second);
    }
  }
  return picture;
}
}
}
