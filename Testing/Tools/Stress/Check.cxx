// SPDX-License-Identifier: BSD-3-Clause
#include "Check.h"

#include "Projections/Bounds/ChordLimits.h"
#include "System/MessageCatcher.h"
#include "NearestFace.h"
#include "NearestPlace.h"
#include "RightAnswers.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <Gl.h>

#include <algorithm>

namespace wfv
{
namespace stress
{
namespace
{
// Larger pictures are compared at random pixels.
constexpr std::size_t MostSamples = 40000;

// Lines of a verdict, and pixels that get a close look.
constexpr std::size_t MostLines = 4;
constexpr long MostLooks = 1024;

// Two surfaces may be drawn in either order where their distances differ by less than this
// share of the range between the clip spheres (depth is a float of 24 bits, from a distance
// with as many), or by this share of the distance itself.
constexpr double DepthStep = 4.0 / 16777216;
constexpr double DistanceRounding = 1e-6;

// Pieces are clipped at the near sphere by distances that are interpolated along chords: so much
// nearer, relative to its radius, a triangle may be drawn. Corners that end there are put at 0.999
// of it (refine_types.glsl).
constexpr double AlongChord = ChordLimits::LongestChord * ChordLimits::LongestChord / 8 + 0.001;

// How far the near plane may lie beyond the near sphere, in its radii: fields of view of up
// to 120 degrees have corners within 76 degrees of the axis.
constexpr double PlaneOverSphere = 4.2;

constexpr int PointsPerCircle = 16; // as the metric's

long CountGlErrors()
{
  long count = 0;
  while (count < 1000 && glGetError() != GL_NO_ERROR)
  {
    ++count;
  }
  return count;
}

std::string Pixel(int i, int j)
{
  return "pixel (" + std::to_string(i) + ", " + std::to_string(j) + ")";
}
}

Checker::Checker() = default;
Checker::~Checker() = default;

void Checker::SetBatch(const Batch& batch)
{
  this->Current = batch;
  this->Drawing.SetMesh(batch.What.Mesh);
  this->Caster.reset();
  this->Samples.clear();
}

// Every pixel centre, or so many at random of a larger picture. The view and the pose are
// those that were drawn.
void Checker::CastRays()
{
  const test::Shot& s = this->Current.Shot;
  this->Caster.reset(new reference::RayCaster(
    this->Current.What.Mesh, this->Drawing.GetView(), this->Drawing.GetPose()));
  const std::size_t all = std::size_t(s.Width) * s.Height;
  Random random(this->Current.Seed, "samples");
  for (std::size_t n = 0; n < all; ++n)
  {
    if (all <= MostSamples || random.Unit() * double(all) < double(MostSamples))
    {
      this->Samples.push_back({ int(n % s.Width), int(n / s.Width), {} });
    }
  }
  vtkSMPTools::For(0, vtkIdType(this->Samples.size()), 256, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType n = begin; n < end; ++n)
    {
      Sample& p = this->Samples[std::size_t(n)];
      p.Truth = this->Caster->Cast(reference::PixelToNdc(p.I + 0.5, p.J + 0.5, s.Width, s.Height));
    }
  });
}

void Checker::Say(Verdict& verdict, const std::string& what) const
{
  if (verdict.Lines.size() < MostLines)
  {
    verdict.Lines.push_back(what);
  }
}

Verdict Checker::Check(const Technique& technique)
{
  Verdict verdict;
  verdict.Count.Batches = 1;
  this->BesideNear = technique.Projects ? AlongChord : 0;
  CountGlErrors(); // what others left
  this->Drawing.SetTechnique(technique.Value);
  this->Drawing.SetTolerance(technique.Tolerance);
  const reference::DrawnPicture drawn = this->Drawing.Draw(this->Current.Shot);
  verdict.Count.GlErrors += CountGlErrors();
  if (!this->Caster)
  {
    this->CastRays();
  }
  if (drawn.Width == this->Current.Shot.Width)
  {
    this->CountBadValues(verdict);
    this->Compare(drawn, technique, verdict);
  }
  if (this->Current.Closed)
  {
    this->CountHits(technique, verdict);
    verdict.Count.GlErrors += CountGlErrors();
  }
  const std::string error = widefov::MessageCatcher::TakeFirstError();
  verdict.Count.GlErrors += !error.empty();
  if (!error.empty() || drawn.Width != this->Current.Shot.Width)
  {
    this->Say(verdict, "VTK: " + (error.empty() ? "nothing was drawn" : error));
  }
  return verdict;
}

// NaN anywhere, infinity anywhere but in the distance of what is not hit.
void Checker::CountBadValues(Verdict& verdict) const
{
  vtkPointData* const data = this->Drawing.GetImage()->GetPointData();
  vtkDataArray* const cell = data->GetArray("cell");
  const int* const size = this->Drawing.GetImage()->GetDimensions();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* const array = data->GetArray(a);
    const bool isDistance = std::string(array->GetName()) == "distance";
    for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double value = array->GetComponent(n, c);
        const bool empty = isDistance && vtkMath::IsInf(value) && cell->GetComponent(n, 0) == 0;
        if (!std::isfinite(value) && !empty)
        {
          ++verdict.Count.Nan;
          this->Say(verdict,
            std::string(array->GetName()) + " is " + std::to_string(value) + " at " +
              Pixel(int(n % size[0]), int(size[1] - 1 - n / size[0])));
        }
      }
    }
  }
}

void Checker::CountHits(const Technique& technique, Verdict& verdict)
{
  const test::Shot& s = this->Current.Shot;
  const std::vector<unsigned char> counts =
    this->Counter.Count(this->Current.What.Mesh, s, technique.Value, technique.Tolerance);
  for (std::size_t n = 0; n < counts.size(); ++n)
  {
    const int i = int(n % s.Width);
    const int j = int(n / s.Width);
    const ViewRay ray =
      this->Drawing.GetView().Ray(reference::PixelToNdc(i + 0.5, j + 0.5, s.Width, s.Height));
    if (ray.Inside && counts[n] != 1)
    {
      verdict.Count.Holes += counts[n] == 0;
      verdict.Count.DoubleHits += counts[n] > 1;
      this->Say(verdict, Pixel(i, j) + " is hit " + std::to_string(counts[n]) + " times");
    }
  }
}

// Whether the cell lies so near behind what is hit here that depth cannot tell.
bool Checker::TiesAt(vec2 ndc, vtkIdType cell) const
{
  const ViewRay ray = this->Caster->GetView().Ray(ndc);
  if (!ray.Inside)
  {
    return false;
  }
  const reference::TriangleSoup& soup = this->Caster->GetTriangles();
  const auto at = std::lower_bound(soup.CellIds.begin(), soup.CellIds.end(), cell);
  if (at == soup.CellIds.end() || *at != cell)
  {
    return false;
  }
  const auto& t = soup.Triangles[std::size_t(at - soup.CellIds.begin())];
  const reference::RayTriangleHit hit = reference::IntersectTriangle(
    ray.Origin, ray.Direction, { { soup.Points[t[0]], soup.Points[t[1]], soup.Points[t[2]] } });
  const View& view = this->Caster->GetView();
  const vec2 radii = view.GetParameters().radii;
  const double nearest = this->Caster->Cast(ray.Origin, ray.Direction).Distance;
  const double step = DepthStep * (radii.y - radii.x) + DistanceRounding * hit.Distance;
  if (view.GetProjection().Axis == Family::Planar)
  {
    // stock VTK draws it, and clips by planes: between plane and sphere both are right
    return hit.Found && (hit.Distance <= nearest + step || nearest <= PlaneOverSphere * radii.x);
  }
  const bool shown =
    hit.Distance >= radii.x * (1 - this->BesideNear) - step && hit.Distance <= radii.y + step;
  return hit.Found && shown && hit.Distance <= nearest + step;
}

bool Checker::IsDepthTie(const reference::WorstPixel& p, double b) const
{
  const test::Shot& s = this->Current.Shot;
  if (p.Drawn < 0)
  {
    return false;
  }
  for (const double r : { 0.0, b / 4, b / 2, b })
  {
    for (int k = 0; k < PointsPerCircle; ++k)
    {
      const double angle = 2 * WFV_PI * k / PointsPerCircle;
      const double x = p.I + 0.5 + r * std::cos(angle);
      const double y = p.J + 0.5 + r * std::sin(angle);
      if (this->TiesAt(reference::PixelToNdc(x, y, s.Width, s.Height), p.Drawn))
      {
        return true;
      }
    }
  }
  return false;
}

// Whether the ray caster explains a pixel that differs; ties are counted.
bool Checker::IsRight(const reference::WorstPixel& p, double b, Counts& count) const
{
  const test::Shot& s = this->Current.Shot;
  if (reference::IsExplained(*this->Caster, s.Width, s.Height, p, b))
  {
    return true;
  }
  const vec2 ndc = reference::PixelToNdc(p.I + 0.5, p.J + 0.5, s.Width, s.Height);
  const bool tie = reference::IsRightAnswer(*this->Caster, ndc, p.Drawn);
  const bool depth = !tie && this->IsDepthTie(p, b);
  count.Ties += tie;
  count.DepthTies += depth;
  return tie || depth;
}

// How far from the pixel its cell is seen, by smaller circles and by the cell's own picture. True
// where the cell is there, or is there behind another one.
bool Checker::LookClosely(reference::WorstPixel& p, double b, Counts& count) const
{
  const test::Shot& s = this->Current.Shot;
  const double thin = reference::NearestAgreement(*this->Caster, s.Width, s.Height, p, b);
  count.Thin += std::isfinite(thin);
  p.Pixels = std::min(thin, p.Pixels);
  const vec2 centre(p.I + 0.5, p.J + 0.5);
  const vec2 ndc = reference::PixelToNdc(centre.x, centre.y, s.Width, s.Height);
  if (this->Caster->GetView().Ray(ndc).Inside)
  {
    p.Pixels = std::min(p.Pixels,
      reference::NearestPlace(
        *this->Caster, s.Width, s.Height, centre, p.Drawn, reference::SearchLimit));
  }
  const double most = b + reference::SnapStep;
  const bool near = p.Pixels <= most;
  const bool there = !near && p.Drawn >= 0 &&
    reference::NearestFace(*this->Caster, s.Width, s.Height, centre, p.Drawn, most) <= most;
  count.Near += near;
  count.Hidden += there;
  return near || there;
}

void Checker::Compare(
  const reference::DrawnPicture& drawn, const Technique& technique, Verdict& verdict) const
{
  const test::Shot& s = this->Current.Shot;
  Counts& count = verdict.Count;
  std::vector<std::string> lines[2]; // of pixels that show what is nowhere near, and of others
  for (const Sample& sample : this->Samples)
  {
    const std::size_t n = std::size_t(sample.J) * s.Width + sample.I;
    ++count.Pixels;
    reference::WorstPixel p{ sample.I, sample.J,
      drawn.Cell[n] > 0 ? vtkIdType(drawn.Cell[n]) - 1 : -1, sample.Truth.Cell, drawn.Distance[n],
      sample.Truth.Distance, reference::SearchLimit };
    if (p.Drawn == p.Reference)
    {
      const double e = std::abs(p.DrawnDistance - p.ReferenceDistance) / p.ReferenceDistance;
      count.MaxDepthRel = p.Drawn >= 0 && e > count.MaxDepthRel ? e : count.MaxDepthRel;
      continue;
    }
    if (this->IsRight(p, technique.B, count))
    {
      continue;
    }
    ++count.Unexplained;
    const bool found = count.Unexplained <= MostLooks && this->LookClosely(p, technique.B, count);
    count.MaxPx = std::max(count.MaxPx, p.Pixels);
    lines[found].push_back(
      "unexplained " + test::DescribePixel(this->Drawing.GetView(), s.Width, s.Height, p));
  }
  for (const auto& texts : lines)
  {
    std::for_each(
      texts.begin(), texts.end(), [&](const std::string& text) { this->Say(verdict, text); });
  }
}
}
}
