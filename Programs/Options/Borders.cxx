// SPDX-License-Identifier: BSD-3-Clause
#include "Borders.h"

#include "FilmOptions.h"
#include "Text/Angles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
// Pixels along a side of the whole: where float32 still tells a sixteenth of them apart.
constexpr double MostPixels = 1 << 20;

// NDC, either way: a border of the whole, whose angle is known and has no ray.
constexpr double AtBorder = 1 - 1e-9;

void CheckBorders(const Options& o, const wfv::Projection& p, const FieldsOfView& given)
{
  const std::vector<double>& b = o.Borders;
  if (!HasBorders(p))
  {
    FailUsage("--borders is for maps that have fields of view across and up, not for " + p.Name +
      (p.Axis == wfv::Family::Azimuthal ? "; --circle puts that anywhere" : "; leave it out"));
  }
  if (!(b[0] < b[1]) || !(b[2] < b[3]))
  {
    FailUsage("--borders: left must be below right, and down below up");
  }
  const bool others = given.Horizontal || given.Vertical || given.Round || !o.Screens.empty();
  if (others)
  {
    FailUsage("--borders says what is seen of a picture; leave --hfov, --vfov, --fov and --screens "
              "out");
  }
}

// NDC of the whole picture at an angle across (axis 0) or up (axis 1), degrees.
double PlaceOf(const wfv::View& view, int axis, double degrees)
{
  const double along = std::sin(degrees * Degree);
  const double ahead = -std::cos(degrees * Degree);
  return view.Forward(wfv::vec3(axis == 0 ? along : 0, axis == 0 ? 0 : along, ahead)).Ndc[axis];
}

void FitHeight(Options& o, const wfv::View& view, const std::array<double, 2>& parts)
{
  const wfv::vec2 scale = view.GetParameters().scale;
  const double high = parts[1] * scale.x / (parts[0] * scale.y);
  const int step = HasFilm(o) ? 2 : 1; // codecs take even numbers alone
  o.Size[1] =
    step * static_cast<int>(std::clamp(std::round(o.Size[0] * high / step), 1., MostPixels));
}

void CheckPart(const Options& o, const wfv::Projection& p)
{
  for (int i = 0; i < 2; i++)
  {
    if (!(o.Size[i] <= MostPixels * o.Part->Share[i]))
    {
      FailUsage("--borders: so small a part of " + p.Name + " is not drawn with " +
        std::to_string(o.Size[i]) + " pixels; choose a smaller --size or wider borders");
    }
  }
}
}

bool HasBorders(const wfv::Projection& p)
{
  return p.Axis != wfv::Family::Azimuthal && p.Axis != wfv::Family::Faces &&
    p.Axis != wfv::Family::Sampled;
}

void FitPart(Options& o)
{
  PartOfPicture& part = *o.Part;
  for (int i = 0; i < 2; i++)
  {
    const double whole = std::min(o.Size[i] / part.Share[i], MostPixels);
    part.Whole[i] = std::max(o.Size[i], static_cast<int>(std::lround(whole)));
    part.Start[i] = std::clamp(
      static_cast<int>(std::lround(part.From[i] * part.Whole[i])), 0, part.Whole[i] - o.Size[i]);
  }
  o.View.Aspect = double(part.Whole[0]) / part.Whole[1];
}

wfv::vec2 InWhole(const Options& o, const wfv::vec2& ndc)
{
  if (!o.Part)
  {
    return ndc;
  }
  const auto at = [&o](int i, double along) {
    return 2 * (o.Part->Start[i] + 0.5 * (along + 1) * o.Size[i]) / o.Part->Whole[i] - 1;
  };
  return { at(0, ndc.x), at(1, ndc.y) };
}

std::array<double, 4> BordersOf(const Options& o)
{
  wfv::ViewOptions plain;
  plain.HorizontalFov = o.View.HorizontalFov;
  plain.VerticalFov = o.View.VerticalFov;
  const wfv::View view(*wfv::FindProjection(o.Projection), plain);
  const auto angle = [&](int axis, double place) {
    const double most = 0.5 * (axis == 0 ? plain.HorizontalFov : plain.VerticalFov);
    const double ndc = 2 * place - 1;
    if (std::abs(ndc) > AtBorder)
    {
      return std::copysign(most, ndc);
    }
    const wfv::vec3 d = view.Ray(axis == 0 ? wfv::vec2(ndc, 0) : wfv::vec2(0, ndc)).Direction;
    return std::atan2(axis == 0 ? d.x : d.y, -d.z) / Degree;
  };
  const PartOfPicture& part = *o.Part;
  return { { angle(0, part.From[0]), angle(0, part.From[0] + part.Share[0]), angle(1, part.From[1]),
    angle(1, part.From[1] + part.Share[1]) } };
}

void TakeBorders(Options& o, const wfv::Projection& p, const FieldsOfView& given)
{
  if (o.Borders.empty())
  {
    return;
  }
  CheckBorders(o, p, given);
  const std::vector<double>& b = o.Borders;
  o.View.HorizontalFov = 2 * std::max(std::abs(b[0]), std::abs(b[1]));
  o.View.VerticalFov = 2 * std::max(std::abs(b[2]), std::abs(b[3]));
  wfv::ViewOptions plain;
  plain.HorizontalFov = o.View.HorizontalFov;
  plain.VerticalFov = o.View.VerticalFov;
  const std::string complaint = wfv::CheckOptions(p, plain);
  if (!complaint.empty())
  {
    FailUsage("--borders: " + complaint);
  }
  const wfv::View view(p, plain);
  o.Part.emplace();
  for (int i = 0; i < 2; i++)
  {
    o.Part->From[i] = 0.5 * (PlaceOf(view, i, b[2 * i]) + 1);
    o.Part->Share[i] = 0.5 * (PlaceOf(view, i, b[2 * i + 1]) + 1) - o.Part->From[i];
  }
  if (!o.HasSize)
  {
    FitHeight(o, view, o.Part->Share);
  }
  CheckPart(o, p);
  FitPart(o);
}
}
