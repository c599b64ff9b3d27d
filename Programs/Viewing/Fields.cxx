// SPDX-License-Identifier: BSD-3-Clause
#include "Fields.h"

#include "Options/Borders.h"
#include "Text/Angles.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
// Zooming in ends here, degrees: less than any scene's pixels are worth.
constexpr double SmallestFov = 1;

double HalfTangent(double degrees)
{
  return std::tan(0.5 * degrees * Degree);
}

double FovOf(double halfTangent)
{
  return 2 * std::atan(halfTangent) / Degree;
}

// Of the picture that has these fields of view.
double Proportion(const Options& o)
{
  const std::array<int, 2>& size = o.Part ? o.Part->Whole : o.Size;
  return double(size[1]) / size[0];
}
}

Fields::Fields(const Options& o)
  : Lens(o.View.Lens)
  , Measured(o.View.Measured)
  , Lensed(o.Projection)
{
  if (wfv::FindProjection(o.Projection)->Axis == wfv::Family::Planar)
  {
    this->PlanarWidth = HalfTangent(o.View.HorizontalFov);
    this->PlanarProportion = HalfTangent(o.View.VerticalFov) / this->PlanarWidth / Proportion(o);
  }
  else
  {
    this->Wide = { o.View.HorizontalFov, o.View.VerticalFov };
  }
}

Fields::Angles Fields::PlanarAngles(const Options& o) const
{
  return { FovOf(this->PlanarWidth),
    FovOf(this->PlanarWidth * this->PlanarProportion * Proportion(o)) };
}

// Up to there widening the view shows more.
double Fields::LargestZoom(const Options& o) const
{
  const wfv::Projection& p = *wfv::FindProjection(o.Projection);
  const double across = p.MaxHorizontalFov / this->Wide.Horizontal;
  if (p.Axis == wfv::Family::Azimuthal)
  {
    return across;
  }
  return std::max(across, p.MaxVerticalFov / this->Wide.Vertical);
}

bool Fields::Zoom(const Options& o, double factor)
{
  const wfv::Projection& p = *wfv::FindProjection(o.Projection);
  if (p.Axis == wfv::Family::Planar)
  {
    const double tall = std::max(1., this->PlanarProportion * Proportion(o));
    this->PlanarWidth = std::clamp(
      this->PlanarWidth * factor, HalfTangent(SmallestFov), HalfTangent(p.MaxHorizontalFov) / tall);
    return true;
  }
  if (p.MinHorizontalFov >= p.MaxHorizontalFov || p.Axis == wfv::Family::Sampled ||
    o.View.Measured.IsSet())
  {
    return false;
  }
  this->WideZoom =
    std::clamp(this->WideZoom * factor, SmallestFov / this->Wide.Horizontal, this->LargestZoom(o));
  return true;
}

void Fields::Apply(Options& o) const
{
  const wfv::Projection& p = *wfv::FindProjection(o.Projection);
  o.View.Aspect = double(o.Size[0]) / o.Size[1];
  if (o.Part)
  {
    FitPart(o);
  }
  const bool lensed = o.Projection == this->Lensed;
  o.View.Lens = lensed ? this->Lens : wfv::ViewOptions().Lens;
  o.View.Measured = lensed ? this->Measured : wfv::MeasuredPicture();
  Angles a{ this->Wide.Horizontal * this->WideZoom, this->Wide.Vertical * this->WideZoom };
  if (p.Axis == wfv::Family::Planar)
  {
    a = this->PlanarAngles(o);
  }
  else if (p.Axis == wfv::Family::Azimuthal)
  {
    a.Vertical = a.Horizontal;
  }
  const double least = 0.01 * SmallestFov; // very flat windows
  o.View.HorizontalFov =
    std::clamp(a.Horizontal, std::max(least, p.MinHorizontalFov), p.MaxHorizontalFov);
  o.View.VerticalFov = std::clamp(a.Vertical, std::max(least, p.MinVerticalFov), p.MaxVerticalFov);
}
}
