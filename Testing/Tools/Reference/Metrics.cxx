// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics.h"

#include "DepthShift.h"
#include "NearestPlace.h"
#include "RightAnswers.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace reference
{
namespace
{
constexpr int PointsPerCircle = 16;

// Whether the ray caster sees the drawn cell somewhere on a circle round the pixel's centre.
bool AgreesOnCircle(
  const Caster& caster, int width, int height, const WorstPixel& pixel, double radius, int points)
{
  for (int k = 0; k < points; ++k)
  {
    const double angle = 2 * WFV_PI * k / points;
    const double x = pixel.I + 0.5 + radius * std::cos(angle);
    const double y = pixel.J + 0.5 + radius * std::sin(angle);
    if (caster.Sees(PixelToNdc(x, y, width, height), pixel.Drawn))
    {
      return true;
    }
  }
  return false;
}

// Sets what of the pixel the reference says: whether one of the 48 points explains it, and
// how far the nearest place of agreement is, by them, by the cell's own picture and, where
// there is none to be had, by the circles of radius 2b, 4b, ... .
void Explain(const Caster& caster, const DrawnPicture& p, WorstPixel& pixel, double tolerance)
{
  pixel.Pixels = std::numeric_limits<double>::infinity();
  const vec2 centre(pixel.I + 0.5, pixel.J + 0.5);
  const bool inside =
    caster.GetView().Ray(PixelToNdc(centre.x, centre.y, p.Width, p.Height)).Inside;
  const double limit = std::max(tolerance, SearchLimit);
  const double widest = caster.GetSoup() && inside ? tolerance : limit;
  for (double r = tolerance / 4; r <= widest && !std::isfinite(pixel.Pixels); r *= 2)
  {
    if (AgreesOnCircle(caster, p.Width, p.Height, pixel, r, PointsPerCircle))
    {
      pixel.Pixels = r;
    }
  }
  if (!(pixel.Pixels <= tolerance) &&
    IsRightAnswer(caster, PixelToNdc(centre.x, centre.y, p.Width, p.Height), pixel.Drawn))
  {
    pixel.Tie = true;
    pixel.Pixels = 0;
  }
  pixel.Explained = pixel.Pixels <= tolerance;
  const double nearest =
    NearestPlace(caster, p.Width, p.Height, centre, pixel.Drawn, std::min(pixel.Pixels, limit));
  pixel.Pixels = std::min(pixel.Pixels, nearest);
}

vtkIdType DrawnCell(float value)
{
  return value > 0 ? vtkIdType(value) - 1 : -1;
}

// Adds the distance drawn at a pixel whose cells agree.
void MeasureDepth(
  const Caster& caster, const DrawnPicture& drawn, std::size_t n, const Hit& hit, Metrics& metrics)
{
  const double e = std::abs(drawn.Distance[n] - hit.Distance) / hit.Distance;
  // a NaN must not pass for agreement
  metrics.MaxDepthRel =
    e <= metrics.MaxDepthRel ? metrics.MaxDepthRel : (std::isnan(e) ? INFINITY : e);
  if (!(e <= DepthRel))
  {
    const int i = int(n % drawn.Width);
    const int j = int(n / drawn.Width);
    const double shift =
      DepthShift(caster, drawn.Width, drawn.Height, i, j, hit, drawn.Distance[n]);
    metrics.DepthPx = std::max(metrics.DepthPx, shift);
    const double rounding = DepthRounding(caster, drawn.Width, drawn.Height, i, j, hit);
    metrics.DepthUlps = std::max(metrics.DepthUlps, e / rounding);
  }
}

// Adds the pixels whose cells agree to the metrics, returns the others.
std::vector<WorstPixel> FindMismatches(
  const Caster& caster, const DrawnPicture& drawn, const HitPicture& reference, Metrics& metrics)
{
  std::vector<WorstPixel> pixels;
  for (std::size_t n = 0; n < reference.Hits.size(); ++n)
  {
    const Hit& hit = reference.Hits[n];
    const vtkIdType cell = DrawnCell(drawn.Cell[n]);
    metrics.DomainPixels += hit.InDomain;
    if (cell != hit.Cell)
    {
      pixels.push_back({ int(n % drawn.Width), int(n / drawn.Width), cell, hit.Cell,
        drawn.Distance[n], hit.Distance, 0 });
    }
    else if (cell >= 0)
    {
      MeasureDepth(caster, drawn, n, hit, metrics);
    }
  }
  return pixels;
}

// At most so many of them, evenly taken.
void Thin(std::vector<WorstPixel>& pixels, std::size_t most)
{
  if (pixels.size() <= most)
  {
    return;
  }
  const double step = double(pixels.size()) / double(most);
  for (std::size_t i = 0; i < most; ++i)
  {
    pixels[i] = pixels[std::size_t(double(i) * step)];
  }
  pixels.resize(most);
}

void Summarize(std::vector<WorstPixel>& pixels, Metrics& m)
{
  std::sort(pixels.begin(), pixels.end(),
    [](const WorstPixel& a, const WorstPixel& b) { return a.Pixels > b.Pixels; });
  m.Searched = long(pixels.size());
  if (pixels.empty())
  {
    return;
  }
  m.MaxPx = pixels.front().Pixels;
  m.P99Px = pixels[pixels.size() / 100].Pixels;
  long missing = 0;
  long spurious = 0;
  for (const WorstPixel& p : pixels)
  {
    m.Ties += p.Tie;
    if (p.Explained)
    {
      continue;
    }
    ++m.UnexplainedPixels;
    missing += p.Drawn < 0;
    spurious += p.Reference < 0;
    if (m.Worst.size() < Metrics::MaxWorst)
    {
      m.Worst.push_back(p);
    }
  }
  m.Unexplained = double(m.UnexplainedPixels);
  m.Missing = double(missing);
  m.Spurious = double(spurious);
}
}

DrawnPicture ToDrawnPicture(vtkImageData* image)
{
  return ToDrawnPicture(image, { 0 });
}

DrawnPicture ToDrawnPicture(vtkImageData* image, const std::vector<vtkIdType>& firstCells)
{
  DrawnPicture p;
  vtkDataArray* cell = image ? image->GetPointData()->GetArray("cell") : nullptr;
  vtkDataArray* distance = image ? image->GetPointData()->GetArray("distance") : nullptr;
  vtkDataArray* prop = image ? image->GetPointData()->GetArray("prop") : nullptr;
  if (!cell || !distance || !prop)
  {
    return p;
  }
  int size[3];
  image->GetDimensions(size);
  p.Width = size[0];
  p.Height = size[1];
  for (int j = p.Height - 1; j >= 0; --j)
  {
    for (int i = 0; i < p.Width; ++i)
    {
      const vtkIdType n = vtkIdType(j) * p.Width + i;
      const double id = cell->GetComponent(n, 0);
      const vtkIdType number = vtkIdType(prop->GetComponent(n, 0)) - 1;
      const bool known = id > 0 && number >= 0 && number < vtkIdType(firstCells.size());
      p.Cell.push_back(float(known ? id + double(firstCells[number]) : id));
      p.Distance.push_back(float(distance->GetComponent(n, 0)));
    }
  }
  return p;
}

Metrics Compare(const DrawnPicture& drawn, const Caster& caster, double tolerance)
{
  return Compare(drawn, caster, caster.Render(drawn.Width, drawn.Height), tolerance);
}

Metrics Compare(const DrawnPicture& drawn, const Caster& caster, const HitPicture& reference,
  double tolerance, std::size_t mostSearched)
{
  Metrics m;
  std::vector<WorstPixel> pixels = FindMismatches(caster, drawn, reference, m);
  m.Mismatched = long(pixels.size());
  Thin(pixels, mostSearched);
  vtkSMPTools::For(0, vtkIdType(pixels.size()), 16, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType n = begin; n < end; ++n)
    {
      Explain(caster, drawn, pixels[n], tolerance);
    }
  });
  Summarize(pixels, m);
  const double share = m.Searched > 0 ? double(m.Searched) / double(m.Mismatched) : 1;
  const double all = double(drawn.Width) * drawn.Height * share;
  m.Unexplained /= all;
  m.Missing /= all;
  m.Spurious /= all;
  return m;
}

bool IsExplained(
  const Caster& caster, int width, int height, const WorstPixel& pixel, double tolerance)
{
  for (double r = tolerance / 4; r <= tolerance; r *= 2)
  {
    if (AgreesOnCircle(caster, width, height, pixel, r, PointsPerCircle))
    {
      return true;
    }
  }
  return false;
}

double NearestAgreement(
  const Caster& caster, int width, int height, const WorstPixel& pixel, double radius)
{
  constexpr int Halvings = 6;
  for (int k = Halvings; k >= 0; --k)
  {
    const double r = radius / (1 << k);
    if (AgreesOnCircle(caster, width, height, pixel, r, PointsPerCircle))
    {
      return r;
    }
  }
  return std::numeric_limits<double>::infinity();
}
}
}
