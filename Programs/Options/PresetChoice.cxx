// SPDX-License-Identifier: BSD-3-Clause
#include "PresetChoice.h"

#include "OptionGroup.h"
#include "Presets/Presets.h"
#include "Settings.h"
#include "StereoChoice.h"
#include "Text/Messages.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
using Json = nlohmann::ordered_json;

// Of a window that a preset gives its proportions, pixels: it fits most screens.
constexpr std::array<int, 2> LargestWindow{ { 1024, 768 } };

std::vector<std::string> PresetNames()
{
  std::vector<std::string> names;
  for (const wfv::Preset& preset : wfv::Presets())
  {
    names.push_back(preset.Name);
  }
  return names;
}

std::string PairText(double a, double b, const char* between)
{
  return Text(a) + between + Text(b);
}

bool IsRound(const std::string& projection)
{
  return wfv::FindProjection(projection)->Axis == wfv::Family::Azimuthal;
}

// In whole degrees where it is the projection's limit: some are no decimal numbers.
std::string FieldText(double degrees, double most)
{
  return Text(degrees <= most ? degrees : std::floor(most));
}

// Those of a projection of the same kind; another has fields of view of its own.
void AddFields(const wfv::Preset& preset, const Options& o, std::vector<Setting>& settings)
{
  const wfv::Projection& p =
    *wfv::FindProjection(o.HasProjection ? o.Projection : preset.Projection);
  if (p.Axis != wfv::FindProjection(preset.Projection)->Axis)
  {
    return;
  }
  const std::string across = FieldText(preset.HorizontalFov, p.MaxHorizontalFov);
  if (p.Axis == wfv::Family::Azimuthal)
  {
    settings.push_back({ "--fov", across, "" });
    return;
  }
  settings.push_back({ "--hfov", across, "" });
  settings.push_back({ "--vfov", FieldText(preset.VerticalFov, p.MaxVerticalFov), "" });
}

void AddSize(const wfv::Preset& preset, Target target, std::vector<Setting>& settings)
{
  std::array<int, 2> size = preset.Size;
  if (target == Target::Window)
  {
    const double scale = std::min(
      double(LargestWindow[0]) / preset.Size[0], double(LargestWindow[1]) / preset.Size[1]);
    size[0] = static_cast<int>(std::lround(scale * preset.Size[0]));
    size[1] = static_cast<int>(std::lround(scale * preset.Size[1]));
  }
  settings.push_back({ "--size", PairText(size[0], size[1], "x"), "" });
}

// Of the model that is given, if one is: what it has.
void AddEyes(const wfv::Preset& preset, const Options& o, bool given, Target target,
  std::vector<Setting>& settings)
{
  using Number = wfv::StereoNumber;
  const std::string projection = o.HasProjection ? o.Projection : preset.Projection;
  const wfv::StereoModel& own =
    preset.TwoEyes ? wfv::UsualStereo(*wfv::FindProjection(projection)) : wfv::NoStereo();
  const wfv::StereoModel& model = given ? StereoOf(o) : own;
  settings.push_back({ "--stereo", model.Name, "" });
  if (model.Traits.TwoEyes && !preset.Layout.empty() && target == Target::File)
  {
    settings.push_back({ "--layout", preset.Layout, "" });
  }
  if (model.Has(Number::InterpupillaryDistance))
  {
    settings.push_back({ "--ipd", "auto", "" });
  }
  if (model.Has(Number::PoleFade))
  {
    settings.push_back(
      { "--pole-fade", PairText(preset.PoleFade[0], preset.PoleFade[1], ","), "" });
  }
}

Json Describe(const wfv::Preset& p)
{
  Json json = { { "name", p.Name }, { "title", p.Title }, { "projection", p.Projection } };
  if (IsRound(p.Projection))
  {
    json["fov"] = p.HorizontalFov;
  }
  else
  {
    json["hfov"] = p.HorizontalFov;
    json["vfov"] = p.VerticalFov;
  }
  const Json none;
  json["tilt"] = p.Tilt;
  json["size"] = p.Size;
  json["stereo"] =
    p.TwoEyes ? wfv::UsualStereo(*wfv::FindProjection(p.Projection)).Name : wfv::NoStereo().Name;
  json["layout"] = p.TwoEyes ? Json(p.Layout) : none;
  json["pole_fade"] = p.TwoEyes ? Json(p.PoleFade) : none;
  json["codec"] = p.Codec.empty() ? none : Json(p.Codec);
  return json;
}
}

void DeclarePresets(CLI::App& app, Options& o)
{
  OptionGroup group(app, "Presets");
  group.Choice("--preset", o.Preset, PresetNames(), {},
    "projection, fields of view, tilt, size and eyes for a purpose; other options change them");
  group.Name("--config", "FILE", o.Config,
    "options that are not given here: a line each, NAME = VALUE or the name of a flag");
  group.Flag("--list-presets", o.ListPresets, "print the presets");
  group.Flag("--quiet", o.Quiet, "say nothing but errors");
  group.Flag("--verbose", o.Verbose, "say what is done");
}

void CompleteFromPreset(CLI::App& app, Options& o, Target target)
{
  if (!o.Config.empty())
  {
    ApplySettings(app, ReadSettings(o.Config));
  }
  if (o.Quiet && o.Verbose)
  {
    FailUsage("--quiet and --verbose exclude each other; give one");
  }
  SetVerbosity(o.Quiet ? Verbosity::Quiet : o.Verbose ? Verbosity::Verbose : Verbosity::Normal);
  o.HasSize = app.count("--size") > 0; // a preset's gives way to that of a direction map
  if (o.Preset.empty())
  {
    return;
  }
  if (!o.Screens.empty())
  {
    FailUsage("--preset and --screens exclude each other: the screens say what they show");
  }
  const wfv::Preset& preset = *wfv::FindPreset(o.Preset);
  std::vector<Setting> settings;
  AddFields(preset, o, settings);
  AddSize(preset, target, settings);
  AddEyes(preset, o, app.count("--stereo") > 0, target, settings);
  settings.push_back({ "--projection", preset.Projection, "" });
  settings.push_back({ "--tilt", Text(preset.Tilt), "" });
  ApplySettings(app, settings);
}

std::string PresetList(bool json)
{
  Json list = Json::array();
  std::string names;
  for (const wfv::Preset& preset : wfv::Presets())
  {
    list.push_back(Describe(preset));
    names += preset.Name + "\n";
  }
  return json ? list.dump(2) + "\n" : names;
}
}
