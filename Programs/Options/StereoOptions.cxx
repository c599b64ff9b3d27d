// SPDX-License-Identifier: BSD-3-Clause
#include "StereoOptions.h"

#include "Completion.h"
#include "OutputNames.h"
#include "Stereo/Stereo.h"
#include "StereoChoice.h"
#include "StereoLayout.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace widefov
{
namespace
{
const std::vector<Alias> LayoutAliases{ { "sbs", "side-by-side" }, { "left-right", "side-by-side" },
  { "tb", "top-bottom" }, { "over-under", "top-bottom" }, { "exr", "multi-view" } };

// The largest distance that may be asked for, scene units: squares of it still fit a float32.
constexpr double MostLength = 1e18;

// A number that one model alone takes; that it was given is kept.
void ModelNumber(OptionGroup& group, Options& o, const std::string& name, const std::string& type,
  double& target, const Range& range, const std::string& text)
{
  group.Add(name, type, Text(target), text + ", " + range.Describe(),
    [&o, &target, range](const std::string& option, const std::string& value) {
      target = ParseNumber(option, value, range);
      o.StereoGiven.push_back(option);
    });
}

// LEFT,RIGHT: a colour each, of which no light reaches both.
std::array<int, 2> ParseMask(const std::string& option, const std::string& value)
{
  const std::size_t comma = value.find(',');
  if (comma == std::string::npos)
  {
    FailUsage(option + ": '" + value + "' is not of the form LEFT,RIGHT; give two colours");
  }
  const std::array<std::string, 2> names{ { value.substr(0, comma), value.substr(comma + 1) } };
  std::array<int, 2> mask{ { 0, 0 } };
  for (std::size_t i = 0; i < 2; i++)
  {
    const std::vector<std::string>& all = AnaglyphColors();
    const std::string color = Choose(option, names[i], all);
    mask[i] = 1 + int(std::find(all.begin(), all.end(), color) - all.begin());
  }
  if ((mask[0] & mask[1]) != 0)
  {
    FailUsage(option + ": both eyes would see light of " + names[0] + " and " + names[1] +
      "; choose colours that share none, such as red,cyan");
  }
  return mask;
}

// The same, or "auto": from the depths of the picture.
void DepthNumber(OptionGroup& group, Options& o, const std::string& name, double& target,
  const Range& range, const std::string& text)
{
  group.Add(name, "D|auto", Text(target), text + ", " + range.Describe() + "; auto: by the picture",
    [&o, &target, range](const std::string& option, const std::string& value) {
      o.ConvergeOnDepth = value == "auto";
      target = value == "auto" ? target : ParseNumber(option, value, range);
      o.StereoGiven.push_back(option);
    });
}

using Number = wfv::StereoNumber;

const std::pair<Number, const char*> NumberOptions[] = { { Number::InterpupillaryDistance,
                                                           "--ipd" },
  { Number::PoleFade, "--pole-fade" }, { Number::CircleConvergence, "--convergence" },
  { Number::Iod, "--iod" }, { Number::Distance, "--distance" }, { Number::Offset, "--offset" },
  { Number::Separation, "--separation" }, { Number::Convergence, "--convergence" } };

// Everything in one plane, or at one depth, has no parallax: the window's border may lie there.
bool HasPlane(const wfv::StereoModel& model)
{
  return model.Has(Number::Offset) || model.Has(Number::Convergence);
}

// The options that a model has.
std::vector<std::string> OptionsOfModel(const wfv::StereoModel& model, bool screens)
{
  if (screens && HasPlane(model))
  {
    // the rest follows from the screens
    return model.Has(Number::Offset) ? std::vector<std::string>{ "--ipd", "--offset" }
                                     : std::vector<std::string>{ "--ipd" };
  }
  std::vector<std::string> options;
  for (const auto& [number, option] : NumberOptions)
  {
    if (model.Has(number))
    {
      options.emplace_back(option);
    }
  }
  if (HasPlane(model))
  {
    options.emplace_back("--floating-window");
  }
  return options;
}

std::vector<std::string> NamesOfModels()
{
  std::vector<std::string> names;
  for (const wfv::StereoModel& m : wfv::StereoModels())
  {
    names.push_back(m.Name);
  }
  return names;
}

// For help: which models an option is for.
std::string NamesWith(Number number)
{
  std::vector<std::string> names;
  for (const wfv::StereoModel& m : wfv::StereoModels())
  {
    if (m.Has(number))
    {
      names.push_back(m.Name);
    }
  }
  return Join(names);
}

void DeclareFrame(OptionGroup& group, Options& o)
{
  ModelNumber(group, o, "--floating-window", "F", o.FloatingWindow, { 0, 0.25 },
    NamesWith(Number::Convergence) + ", " + NamesWith(Number::Offset) +
      ": width of a bar that brings the border forward, of the picture's");
  ModelNumber(group, o, "--letterbox", "F", o.Letterbox, { 0, 0.4 },
    "height of the bars above and below, of the picture's");
}

void DeclareEyeDistance(OptionGroup& group, Options& o)
{
  group.Add("--ipd", "D|auto", Text(o.View.Stereo.InterpupillaryDistance),
    NamesWith(Number::InterpupillaryDistance) +
      ", screens: distance between the eyes, scene units; auto: by the nearest thing seen",
    [&o](const std::string& option, const std::string& value) {
      o.EyesByDepth = value == "auto";
      const Range range{ 0, MostLength };
      double& distance = o.View.Stereo.InterpupillaryDistance;
      distance = o.EyesByDepth ? distance : ParseNumber(option, value, range);
      o.StereoGiven.push_back(option);
    });
}

void DeclareAnaglyph(OptionGroup& group, Options& o)
{
  group.Add("--anaglyph", "LEFT,RIGHT", "red,cyan",
    "colours of the glasses, for the layout anaglyph: " + Join(AnaglyphColors()),
    [&o](const std::string& option, const std::string& value) {
      o.AnaglyphMask = ParseMask(option, value);
      o.StereoGiven.push_back(option);
    });
  const Range range{ 0, 1 };
  group.Add("--anaglyph-saturation", "S", Text(o.AnaglyphSaturation),
    "0: grey, 1: full colours, " + range.Describe(),
    [&o, range](const std::string& option, const std::string& value) {
      o.AnaglyphSaturation = ParseNumber(option, value, range);
      o.StereoGiven.push_back(option);
    });
}
}

void DeclareStereo(CLI::App& app, Options& o)
{
  OptionGroup group(app, "Stereo");
  wfv::StereoOptions& s = o.View.Stereo;
  group.Choice("--stereo", o.Stereo, NamesOfModels(), {}, "stereo model");
  group.Add("--layout", "NAME", "anaglyph", "where the eyes go: " + Join(StereoLayoutNames()),
    [&o](const std::string& option, const std::string& value) {
      o.Layout = Choose(option, value, StereoLayoutNames(), LayoutAliases);
      o.StereoGiven.push_back(option);
    });
  Completions()["--layout"] = StereoLayoutNames();
  DeclareAnaglyph(group, o);
  DeclareEyeDistance(group, o);
  group.Add("--pole-fade", "A,B", "off",
    NamesWith(Number::PoleFade) + ": latitudes, degrees, between which the eyes' distance fades",
    [&o, &s](const std::string& option, const std::string& value) {
      const std::vector<double> fade = ParseNumbers(option, value, 2, 2);
      s.PoleFade = { { fade[0], fade[1] } };
      o.StereoGiven.push_back(option);
    });
  ModelNumber(group, o, "--iod", "D", s.Iod, { 0, wfv::MostIod },
    NamesWith(Number::Iod) + ": distance between the eyes, NDC");
  ModelNumber(group, o, "--distance", "D", s.Distance, { 0, MostLength },
    NamesWith(Number::Distance) + ": of the viewer from the plane of zero parallax, NDC");
  DepthNumber(group, o, "--offset", s.Offset, { -1, 1 },
    NamesWith(Number::Offset) + ": plane of zero parallax, NDC depth");
  ModelNumber(group, o, "--separation", "F", s.Separation, { 0, wfv::MostSeparation },
    NamesWith(Number::Separation) + ": parallax far away, fraction of the width");
  DepthNumber(group, o, "--convergence", s.Convergence, { 0, MostLength, true },
    NamesWith(Number::Convergence) + ", " + NamesWith(Number::CircleConvergence) +
      " (off, no auto): distance of zero parallax, scene units");
  DeclareFrame(group, o);
}

namespace
{
// Gives a model of eyes on a circle the convergence of the command line.
void CompleteConvergence(Options& o)
{
  wfv::StereoOptions& s = o.View.Stereo;
  const auto given = std::find(o.StereoGiven.begin(), o.StereoGiven.end(), "--convergence");
  if (!s.Model->Has(Number::CircleConvergence) || given == o.StereoGiven.end())
  {
    return;
  }
  if (o.ConvergeOnDepth)
  {
    FailUsage("--convergence auto does not go with --stereo " + o.Stereo + "; give a distance");
  }
  const double least = 0.5 * s.InterpupillaryDistance;
  if (!o.EyesByDepth && s.Convergence <= least)
  {
    FailUsage("--convergence: " + Text(s.Convergence) + " is inside the circle of the eyes; give " +
      "a distance above half of --ipd, " + Text(least));
  }
  s.CircleConvergence = s.Convergence;
}
}

void CompleteStereo(Options& o)
{
  o.View.Stereo.Model = &StereoOf(o);
  std::vector<std::string> known = OptionsOfModel(*o.View.Stereo.Model, !o.Screens.empty());
  if (HasTwoEyes(o))
  {
    known.emplace_back("--layout");
    known.emplace_back("--letterbox");
  }
  if (HasTwoEyes(o) && o.Layout == "anaglyph")
  {
    known.emplace_back("--anaglyph");
    known.emplace_back("--anaglyph-saturation");
  }
  if (o.EyesByDepth && !o.Screens.empty())
  {
    FailUsage(
      "--ipd auto is not for --screens, before which people have the eyes they have; give a "
      "number");
  }
  CompleteConvergence(o);
  for (const std::string& given : o.StereoGiven)
  {
    if (HasTwoEyes(o) && o.Layout != "anaglyph" && given.rfind("--anaglyph", 0) == 0)
    {
      FailUsage(given + " does not go with --layout " + o.Layout + "; choose --layout anaglyph");
    }
    if (std::find(known.begin(), known.end(), given) == known.end())
    {
      FailUsage(given + " does not go with --stereo " + o.Stereo +
        (known.empty() ? "; choose a stereo model" : ", which has " + Join(known)));
    }
  }
}

namespace
{
// What the files and the view must be for a layout that is a format of its own.
void CheckLayout(const Options& o)
{
  const StereoLayout& layout = FindStereoLayout(o.Layout);
  const wfv::ViewOptions& v = o.View;
  if (layout.Vr180 &&
    (o.Projection != "equirectangular" || v.HorizontalFov != 180 || v.VerticalFov != 180))
  {
    FailUsage("--layout vr180 is half a sphere an eye, equirectangular; add "
              "--projection equirectangular --hfov 180 --vfov 180");
  }
  for (const std::string& output : o.Outputs)
  {
    if (layout.MultiView && !IsMultiViewName(output))
    {
      FailUsage("--layout multi-view is for .exr, not for '" + output + "'; rename it");
    }
    if (IsVr180Photo(output) && !layout.Vr180)
    {
      FailUsage("'" + output + "' is the name of a VR180 photo; add --layout vr180, or rename it");
    }
  }
}
}

void CheckStereo(const Options& o)
{
  if (!HasTwoEyes(o))
  {
    return;
  }
  if (o.Technique == Technique::CubeMap)
  {
    FailUsage("--technique cubemap has no stereo model; leave --stereo out");
  }
  if (!o.Aov.empty() && o.Layout != "left" && o.Layout != "right")
  {
    FailUsage("--aov is for one eye; give --layout left or --layout right");
  }
  CheckLayout(o);
}

void CheckFiles(const Options& o)
{
  if (HasTwoEyes(o) && FindStereoLayout(o.Layout).InTurn)
  {
    FailUsage("--layout " + o.Layout + " is for a window; use widefov-viewer, or another layout");
  }
}

const std::vector<std::string>& AnaglyphColors()
{
  static const std::vector<std::string> colors{ "blue", "green", "cyan", "red", "magenta",
    "yellow" };
  return colors;
}

bool EyesFitTiles(const Options& o)
{
  const StereoLayout& layout = FindStereoLayout(o.Layout);
  const bool pairs = layout.Rows == 2 && layout.Half && o.Size[1] % 2 != 0;
  // its bars, and its depths, are those of the whole
  const bool whole = o.FloatingWindow == 0 && o.Letterbox == 0 && !o.ConvergeOnDepth;
  return !HasTwoEyes(o) ||
    (o.Layout != "split" && !pairs && !layout.MultiView && !layout.Vr180 && whole);
}
}
