// SPDX-License-Identifier: BSD-3-Clause
#include "Borders.h"

#include "Angles.h"
#include "Film/FilmOptions.h"
#include "Messages.h"

#include <vtkScalarBarActor.h>

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
// Pixels along a side of the whole: where float32 still tells a sixteenth of them apart.
constexpr double MostPixels = 1 << 20;

void CheckBorders(const Options& o, const wfv::Projection& p, const FieldsOfView& given)
{
  const std::vector<double>& b = o.Borders;
  if (p.Axis == wfv::Family::Azimuthal || p.Axis == wfv::Family::Faces ||
    p.Axis == wfv::Family::Sampled)
  {
    FailUsage("--borders is for maps that have fields of view across and up, not for " + p.Name +
      (p.Axis == wfv::Family::Azimuthal ? "; --circle puts that anywhere" : "; leave it out"));
  }
  if (!(b[0] < b[1]) || !(b[2] < b[3]))
  {
    FailUsage("--borders: left must be below right, and down below up");
  }
  const bool others = given.Horizontal || given.Vertical || given.Round || !o.Screens.empty();
  if (others || o.Technique == Technique::CubeMap)
  {
    FailUsage("--borders says what is seen of a picture; leave --hfov, --vfov, --fov, --screens "
              "and --technique cubemap out");
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

// To whole pixels.
void ChoosePart(Options& o, const wfv::Projection& p, const std::array<double, 2>& from,
  const std::array<double, 2>& parts)
{
  o.Part.emplace();
  for (int i = 0; i < 2; i++)
  {
    if (!(o.Size[i] <= MostPixels * parts[i]))
    {
      FailUsage("--borders: so small a part of " + p.Name + " is not drawn with " +
        std::to_string(o.Size[i]) + " pixels; choose a smaller --size or wider borders");
    }
    o.Part->Whole[i] = std::max(o.Size[i], static_cast<int>(std::lround(o.Size[i] / parts[i])));
    o.Part->Start[i] = std::clamp(
      static_cast<int>(std::lround(from[i] * o.Part->Whole[i])), 0, o.Part->Whole[i] - o.Size[i]);
  }
}
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
  std::array<double, 2> from;
  std::array<double, 2> parts; // of the whole
  for (int i = 0; i < 2; i++)
  {
    from[i] = 0.5 * (PlaceOf(view, i, b[2 * i]) + 1);
    parts[i] = 0.5 * (PlaceOf(view, i, b[2 * i + 1]) + 1) - from[i];
  }
  if (!o.HasSize)
  {
    FitHeight(o, view, parts);
  }
  ChoosePart(o, p, from, parts);
  o.View.Aspect = double(o.Part->Whole[0]) / o.Part->Whole[1];
}

void PlaceInPart(vtkScalarBarActor* bar, const Options& o)
{
  if (!o.Part)
  {
    return;
  }
  const double* const at = bar->GetPosition();
  const auto fraction = [&](int i) { return double(o.Size[i]) / o.Part->Whole[i]; };
  const auto start = [&](int i) { return double(o.Part->Start[i]) / o.Part->Whole[i]; };
  bar->SetPosition(start(0) + at[0] * fraction(0), start(1) + at[1] * fraction(1));
  bar->SetWidth(bar->GetWidth() * fraction(0));
  bar->SetHeight(bar->GetHeight() * fraction(1));
}
}
