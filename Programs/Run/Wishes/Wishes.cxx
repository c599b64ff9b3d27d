// SPDX-License-Identifier: BSD-3-Clause
#include "Wishes.h"

#include "Projections/Projection.h"
#include "Text/Messages.h"
#include "Text/OptionValues.h"
#include "Text/ProjectionNames.h"

namespace widefov
{
namespace
{
// Degrees; what the projection shows of it is checked when all is known.
constexpr Range Angles{ 0, 360, true };
constexpr Range Tilts{ -180, 180 };
constexpr Range Distances{ 0, 1e18 };

// A direction map is a file, which no variable brings along.
std::vector<std::string> FormulaNames()
{
  std::vector<std::string> names;
  for (const wfv::Projection& projection : wfv::Projections())
  {
    names.push_back(projection.Name);
  }
  return names;
}

std::vector<std::string> StereoNames()
{
  std::vector<std::string> names;
  for (const wfv::StereoModel& model : wfv::StereoModels())
  {
    names.push_back(model.Name);
  }
  return names;
}

template <std::optional<double> Wishes::*Member, const Range& Allowed>
void TakeNumber(Wishes& wishes, const std::string& name, const std::string& value)
{
  wishes.*Member = ParseNumber(name, value, Allowed);
}

void TakeProjection(Wishes& wishes, const std::string& name, const std::string& value)
{
  wishes.Projection = Choose(name, value, FormulaNames(), ProjectionAliases());
}

void TakeStereo(Wishes& wishes, const std::string& name, const std::string& value)
{
  wishes.Stereo = wfv::FindStereoModel(Choose(name, value, StereoNames()));
}

void TakeInside(Wishes& wishes, const std::string& name, const std::string& value)
{
  wishes.Inside = Choose(name, value, { "0", "1" }) == "1";
}

void CheckField(const std::optional<double>& field, double least, double most, const char* what,
  const wfv::Projection& projection)
{
  if (field && !Range{ least, most, least == 0 }.Contains(*field))
  {
    FailUsage(projection.Name + " shows a " + what + " field of view " +
      Range{ least, most, least == 0 }.Describe() + " degrees, not " + Text(*field));
  }
}

void CheckTogether(const Wishes& wishes)
{
  const wfv::Projection& p = *wfv::FindProjection(wishes.Projection);
  const bool round = p.Axis == wfv::Family::Azimuthal;
  CheckField(wishes.HorizontalFov, p.MinHorizontalFov, p.MaxHorizontalFov, "horizontal", p);
  CheckField(wishes.VerticalFov, p.MinVerticalFov, p.MaxVerticalFov, "vertical", p);
  CheckField(wishes.Fov, p.MinHorizontalFov, p.MaxHorizontalFov, "round", p);
  if (wishes.Fov && !round)
  {
    FailUsage(p.Name + " is not round: give its horizontal and its vertical field of view");
  }
  if (wishes.IsFlat() &&
    (wishes.Inside || wishes.Tilt || wishes.HorizontalFov || wishes.VerticalFov))
  {
    FailUsage("with the projection perspective the camera is the program's own: leave out all but "
              "--stereo");
  }
}
}

const std::vector<Wish>& AllWishes()
{
  static const std::vector<Wish> all = {
    { "--projection", "WIDEFOV_PROJECTION", "NAME", "what widefov-render --list-projections lists",
      &TakeProjection },
    { "--stereo", "WIDEFOV_STEREO", "NAME",
      "a model that widefov-render --help lists, seen through red and cyan glasses", &TakeStereo },
    { "--ipd", "WIDEFOV_IPD", "D",
      "distance between the eyes, scene units, of a model that has one",
      &TakeNumber<&Wishes::EyeDistance, Distances> },
    { "--hfov", "WIDEFOV_HFOV", "DEG", "horizontal field of view",
      &TakeNumber<&Wishes::HorizontalFov, Angles> },
    { "--vfov", "WIDEFOV_VFOV", "DEG", "vertical field of view",
      &TakeNumber<&Wishes::VerticalFov, Angles> },
    { "--fov", "WIDEFOV_FOV", "DEG", "field of view of a round projection",
      &TakeNumber<&Wishes::Fov, Angles> },
    { "--tilt", "WIDEFOV_TILT", "DEG", "of the axis of the projection towards up",
      &TakeNumber<&Wishes::Tilt, Tilts> },
    { "--inside", "WIDEFOV_INSIDE", "",
      "the eye is where the program's camera looks at, in the middle of what it shows",
      &TakeInside },
  };
  return all;
}

Wishes ReadWishes(const Given& given, const char* Wish::*name)
{
  Wishes wishes;
  for (const Wish& wish : AllWishes())
  {
    if (const std::optional<std::string> value = given(wish))
    {
      wish.Take(wishes, wish.*name, *value);
    }
  }
  CheckTogether(wishes);
  return wishes;
}
}
