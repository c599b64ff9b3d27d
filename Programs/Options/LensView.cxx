// SPDX-License-Identifier: BSD-3-Clause
#include "LensView.h"

#include "LensMap.h"
#include "Text/Angles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
const char* NameOf(LensModel model)
{
  return model == LensModel::Fisheye ? "azimuthal-equidistant" : "brown-conrady";
}

LensModel ChooseModel(const Options& o, const CalibratedLens& lens)
{
  if (!o.HasProjection)
  {
    return lens.Model.value_or(LensModel::BrownConrady);
  }
  if (o.Projection == "direction-map" && IsUneven(lens) &&
    lens.Model.value_or(LensModel::BrownConrady) == LensModel::BrownConrady)
  {
    return LensModel::BrownConrady;
  }
  for (const LensModel model : { LensModel::Fisheye, LensModel::BrownConrady })
  {
    if (o.Projection == NameOf(model) && lens.Model.value_or(model) == model)
    {
      return model;
    }
  }
  FailUsage("the lens of " + o.LensFile + " is drawn by " +
    (lens.Model ? NameOf(*lens.Model) : "azimuthal-equidistant or brown-conrady") + ", not " +
    o.Projection + "; leave --projection out");
}

wfv::LensCoefficients CoefficientsOf(const CalibratedLens& lens, LensModel model)
{
  const std::array<double, 8>& k = lens.Coefficients;
  return model == LensModel::Fisheye
    ? wfv::LensCoefficients{ { 1, 0, k[0], 0, k[1], 0, k[2], 0, k[3] } }
    : wfv::LensCoefficients{ { 1, 0, k[0], 0, k[1], 0, k[4], 0, 0 } };
}

// Of a lens whose map is round.
void TakeRoundLens(Options& o, FieldsOfView& fov, const CalibratedLens& lens, LensModel model)
{
  const wfv::Projection& p = *wfv::FindProjection(NameOf(model));
  const wfv::LensCoefficients coefficients = CoefficientsOf(lens, model);
  o.View.Lens = coefficients;
  fov.Lens.assign(coefficients.begin(), coefficients.end());
  if (!fov.Round)
  {
    wfv::ViewOptions all = o.View;
    all.HorizontalFov = p.MaxHorizontalFov;
    const double corner = RadiusToCorners(o.View.Measured);
    fov.Round = 2 / Degree *
      FollowLens(o.LensFile, { 0.5 * p.MaxHorizontalFov * Degree, corner, corner },
        [&](double angle) { return wfv::RadiusAt(p, all, angle); });
  }
}

void CheckLens(const Options& o, const FieldsOfView& fov, const CalibratedLens& lens)
{
  if (!fov.Lens.empty() || !o.Circle.empty() || fov.Horizontal || fov.Vertical ||
    !o.DirectionMap.empty())
  {
    FailUsage(
      "--lens-file says what the lens is and where; leave --lens, --circle, --hfov, --vfov and "
      "--direction-map out");
  }
  wfv::ViewOptions v;
  v.Measured = { lens.Size, lens.Axis, lens.Focal };
  const std::string problem = lens.Size == wfv::vec2(0)
    ? "its picture has no size"
    : wfv::CheckOptions(*wfv::FindProjection(NameOf(LensModel::Fisheye)), v);
  if (!problem.empty())
  {
    FailUsage(o.LensFile + ": " + problem + "; check the calibration");
  }
}
}

FieldsOfView TakeLensFile(Options& o, const FieldsOfView& given)
{
  if (o.LensFile.empty())
  {
    return given;
  }
  FieldsOfView fov = given;
  const CalibratedLens lens = ReadLensFile(o.LensFile);
  CheckLens(o, fov, lens);
  if (!o.HasSize)
  {
    o.Size = { { static_cast<int>(std::lround(lens.Size.x)),
      static_cast<int>(std::lround(lens.Size.y)) } };
  }
  const LensModel model = ChooseModel(o, lens);
  if (model == LensModel::BrownConrady && IsUneven(lens))
  {
    o.Projection = "direction-map";
    o.UnevenLens = lens;
    o.UnevenLens->End = EndOfLens(o.LensFile, lens, fov.Round);
    fov.Round.reset();
    return fov;
  }
  o.Projection = NameOf(model);
  o.View.Measured = { lens.Size, lens.Axis, lens.Focal };
  TakeRoundLens(o, fov, lens, model);
  return fov;
}

void TakeCircle(Options& o, const wfv::Projection& p)
{
  if (o.Circle.empty())
  {
    return;
  }
  if (p.Axis != wfv::Family::Azimuthal)
  {
    FailUsage("--circle is for round projections, not for " + p.Name + "; leave it out");
  }
  if (!(o.Circle[2] > 0))
  {
    FailUsage("--circle: the radius must be above 0 pixels, not " + Text(o.Circle[2]));
  }
  const bool lens = o.View.Lens != wfv::ViewOptions().Lens;
  const double rim = lens ? 1 : wfv::RadiusAt(p, o.View, 0.5 * o.View.HorizontalFov * Degree);
  o.View.Measured.Size = wfv::vec2(o.Size[0], o.Size[1]);
  o.View.Measured.Axis = wfv::vec2(o.Circle[0], o.Circle[1]);
  o.View.Measured.Focal = wfv::vec2(o.Circle[2] / rim);
}
}
