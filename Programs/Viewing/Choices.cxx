// SPDX-License-Identifier: BSD-3-Clause
#include "Choices.h"

#include "Options/Borders.h"
#include "Options/OptionCheck.h"
#include "Options/StereoChoice.h"
#include "Options/StereoLayout.h"
#include "Pictures/EyeDistance.h"
#include "Stereo/Stereo.h"
#include "Text/Messages.h"

#include <algorithm>
#include <utility>

namespace widefov
{
namespace
{
// Takes the other options where they can be drawn.
bool Take(Options& options, Options next, bool tiled)
{
  if (!WhyNot(next, tiled).empty())
  {
    return false;
  }
  CheckDrawn(next);
  options = std::move(next);
  return true;
}

// The name so many steps behind the present one, round and round.
std::string NameBehind(const std::vector<std::string>& names, const std::string& name, int step)
{
  const int count = static_cast<int>(names.size());
  const int at = static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
  return names[static_cast<std::size_t>(((at + step) % count + count) % count)];
}
}

// Behind none the usual one of a picture all round.
std::vector<std::string> StereoNames()
{
  const wfv::StereoModel& usual = wfv::UsualStereo(*wfv::FindProjection("equirectangular"));
  std::vector<std::string> names{ wfv::NoStereo().Name, usual.Name };
  for (const wfv::StereoModel& m : wfv::StereoModels())
  {
    if (m.Traits.TwoEyes && &m != &usual)
    {
      names.push_back(m.Name);
    }
  }
  return names;
}

bool CanBeTiled(const Options& options)
{
  const wfv::Projection& p = *wfv::FindProjection(options.Projection);
  return p.Axis != wfv::Family::Planar && TechniqueOf(options.TechniqueName) != Technique::CubeMap;
}

std::string WhyNot(const Options& options, bool tiled)
{
  const wfv::Projection& p = *wfv::FindProjection(options.Projection);
  if (p.Axis == wfv::Family::Sampled && !options.View.Map)
  {
    return "a direction map is a file; give one on the command line";
  }
  if (tiled && !CanBeTiled(options))
  {
    return "only wide projections drawn by this module go over several windows";
  }
  if (options.Part && !HasBorders(p))
  {
    return "--borders is for other projections";
  }
  const std::string complaint = wfv::CheckOptions(p, options.View);
  if (!complaint.empty())
  {
    return complaint;
  }
  try
  {
    Options copy = options;
    CheckDrawn(copy);
  }
  catch (const Failure& failure)
  {
    return failure.what();
  }
  return "";
}

bool GiveUpTechnique(Options& o)
{
  if (o.Technique == Technique::Auto || WhyNot(o).empty())
  {
    return false;
  }
  o.Technique = Technique::Auto;
  o.TechniqueName = TechniqueNames().front();
  return true;
}

bool SetProjection(Options& o, const Fields& fields, const std::string& name, bool tiled)
{
  Options next = o;
  next.Projection = name;
  fields.Apply(next);
  GiveUpTechnique(next);
  if (!WhyNot(next).empty())
  {
    next.DebugView = false;
    next.Depth = "linear";
    next.Stereo = wfv::NoStereo().Name;
    next.View.Stereo.Model = nullptr;
  }
  return Take(o, next, tiled);
}

void StepProjection(Options& o, const Fields& fields, int step, bool tiled)
{
  std::vector<std::string> names;
  for (const wfv::Projection* const p : wfv::AllProjections())
  {
    names.push_back(p->Name);
  }
  const int count = static_cast<int>(names.size());
  const std::string before = o.Projection;
  for (int tries = 1; tries < count; tries++)
  {
    if (SetProjection(o, fields, NameBehind(names, before, step * tries), tiled))
    {
      return;
    }
  }
}

bool SetTechnique(Options& o, const std::string& name, bool tiled)
{
  Options next = o;
  next.TechniqueName = name;
  return Take(o, next, tiled);
}

bool StepTechnique(Options& o, int step, bool tiled)
{
  const std::vector<std::string> names = TechniqueNames();
  const std::string before = o.TechniqueName;
  for (int tries = 1; tries < static_cast<int>(names.size()); tries++)
  {
    if (SetTechnique(o, NameBehind(names, before, step * tries), tiled))
    {
      return true;
    }
  }
  return false;
}

bool SetStereo(Options& o, const std::string& name, bool tiled)
{
  Options next = o;
  next.Stereo = name;
  next.View.Stereo.Model = wfv::FindStereoModel(name);
  return Take(o, next, tiled);
}

bool StepStereo(Options& o, int step, bool tiled)
{
  const std::vector<std::string> names = StereoNames();
  const std::string before = o.Stereo;
  for (int tries = 1; tries < static_cast<int>(names.size()); tries++)
  {
    if (SetStereo(o, NameBehind(names, before, step * tries), tiled))
    {
      return true;
    }
  }
  return false;
}

bool SetView(Options& o, const wfv::ViewOptions& view, bool tiled)
{
  Options next = o;
  next.View = view;
  return Take(o, next, tiled);
}

bool SetPreset(
  Options& o, Fields& fields, const wfv::Preset& preset, const Scene& scene, bool tiled)
{
  const wfv::Projection& p = *wfv::FindProjection(preset.Projection);
  const wfv::StereoModel& model = preset.TwoEyes ? wfv::UsualStereo(p) : wfv::NoStereo();
  Options next = o;
  next.Projection = preset.Projection;
  next.View.HorizontalFov = std::min(preset.HorizontalFov, p.MaxHorizontalFov);
  next.View.VerticalFov = std::min(preset.VerticalFov, p.MaxVerticalFov);
  next.View.Lens = wfv::ViewOptions().Lens;
  next.View.Measured = wfv::MeasuredPicture();
  next.Part.reset();
  next.View.Tilt = preset.Tilt;
  next.View.Stereo.Model = &model;
  next.View.Stereo.PoleFade = preset.PoleFade;
  next.Stereo = model.Name;
  next.EyesByDepth = preset.TwoEyes;
  const Fields own(next);
  own.Apply(next);
  GiveUpTechnique(next);
  if (!WhyNot(next, tiled).empty())
  {
    next.DebugView = false;
    next.Depth = "linear";
  }
  if (!Take(o, next, tiled))
  {
    return false;
  }
  FitEyes(o, scene);
  o.EyesByDepth = false; // once
  fields = own;
  return true;
}

bool FitsWindow(const Options& options)
{
  const StereoLayout& layout = FindStereoLayout(options.Layout);
  return !HasTwoEyes(options) || layout.Types.size() == 1 || layout.InTurn;
}

bool ShowsEyesInTurn(const Options& options)
{
  return HasTwoEyes(options) && FindStereoLayout(options.Layout).InTurn;
}

bool StepLayout(Options& o, int step)
{
  if (!HasTwoEyes(o))
  {
    return false;
  }
  do
  {
    o.Layout = NameBehind(StereoLayoutNames(), o.Layout, step);
  } while (!FitsWindow(o)); // "anaglyph" does
  return true;
}

bool SetDebugView(Options& o, bool on)
{
  Options next = o;
  next.DebugView = on;
  if (!WhyNot(next).empty())
  {
    return false;
  }
  o = next;
  return true;
}
}
