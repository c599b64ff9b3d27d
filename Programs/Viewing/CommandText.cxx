// SPDX-License-Identifier: BSD-3-Clause
#include "CommandText.h"

#include "Options/Borders.h"
#include "Options/StereoChoice.h"
#include "Options/StereoOptions.h"

#include <cstdio>
#include <tuple>

namespace widefov
{
namespace
{
using List = std::vector<Setting>;

void Add(List& list, const std::string& option, const std::string& value = "")
{
  list.push_back({ option, value, "" });
}

// So that a shell takes it as one word.
std::string Quoted(const std::string& text)
{
  constexpr const char* plain =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,+-";
  if (text.find_first_not_of(plain) == std::string::npos)
  {
    return text;
  }
  std::string quoted = "'";
  for (const char c : text)
  {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

std::string Exactly(double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.17g", value);
  return text;
}

template <class Numbers>
std::string Exactly(const Numbers& numbers)
{
  std::string text;
  for (const double number : numbers)
  {
    text += (text.empty() ? "" : ",") + Exactly(number);
  }
  return text;
}

void AddFieldOfView(const Options& o, List& list)
{
  const wfv::Projection& p = *wfv::FindProjection(o.Projection);
  if (p.Axis == wfv::Family::Sampled)
  {
    Add(list, o.UnevenLens ? "--lens-file" : "--direction-map",
      o.UnevenLens ? o.LensFile : o.DirectionMap);
    return;
  }
  if (o.Part)
  {
    Add(list, "--borders", Exactly(BordersOf(o)));
    return;
  }
  if (p.Axis != wfv::Family::Azimuthal)
  {
    Add(list, "--hfov", Exactly(o.View.HorizontalFov));
    Add(list, "--vfov", Exactly(o.View.VerticalFov));
    return;
  }
  Add(list, "--fov", Exactly(o.View.HorizontalFov));
  if (o.View.Measured.IsSet())
  {
    o.Circle.empty() ? Add(list, "--lens-file", o.LensFile)
                     : Add(list, "--circle", Exactly(o.Circle));
  }
  const bool ideal = o.View.Lens == wfv::ViewOptions().Lens;
  if (!ideal && !(o.View.Measured.IsSet() && o.Circle.empty()))
  {
    Add(list, "--lens", Exactly(o.View.Lens));
  }
}

void AddLook(const Look& look, List& list)
{
  const Look standard;
  const auto name = [&list](
                      const char* option, const std::string& value, const std::string& usual) {
    value == usual ? void() : Add(list, option, value);
  };
  const auto flag = [&list](const char* option, bool given) { given ? Add(list, option) : void(); };
  name("--color-by", look.ColorBy, standard.ColorBy);
  name("--colormap", look.ColorMap, standard.ColorMap);
  name("--representation", look.Representation, standard.Representation);
  name("--vectors", look.Vectors, standard.Vectors);
  name("--streamlines", look.StreamLines, standard.StreamLines);
  name("--line-width", Exactly(look.LineWidth), Exactly(standard.LineWidth));
  name("--point-size", Exactly(look.PointSize), Exactly(standard.PointSize));
  name("--volume-opacity", Exactly(look.VolumeOpacity), Exactly(standard.VolumeOpacity));
  name("--range", look.Range ? Exactly(*look.Range) : "", "");
  flag("--lines-as-tubes", look.LinesAsTubes);
  flag("--points-as-spheres", look.PointsAsSpheres);
  flag("--scalar-bar", look.ScalarBar);
  flag("--no-colors", !look.Colors);
  flag("--no-scalar-bar", !look.UsualBar);
  flag("--no-smooth", !look.Smooth);
  flag("--no-surface", !look.Surface);
  flag("--volume", look.Volume);
  flag("--no-volume", !look.UsualVolume);
}

void AddGlasses(const Options& o, List& list)
{
  static const Options standard;
  if (o.AnaglyphMask != standard.AnaglyphMask)
  {
    Add(list, "--anaglyph",
      AnaglyphColors()[o.AnaglyphMask[0] - 1] + "," + AnaglyphColors()[o.AnaglyphMask[1] - 1]);
  }
  if (o.AnaglyphSaturation != standard.AnaglyphSaturation)
  {
    Add(list, "--anaglyph-saturation", Exactly(o.AnaglyphSaturation));
  }
}

// The numbers that the model has.
void AddNumbers(const Options& o, List& list)
{
  using Number = wfv::StereoNumber;
  const wfv::StereoOptions& s = o.View.Stereo;
  const bool fades = s.PoleFade[0] < s.PoleFade[1];
  const std::tuple<Number, const char*, std::string> all[] = {
    { Number::InterpupillaryDistance, "--ipd", Exactly(s.InterpupillaryDistance) },
    { Number::PoleFade, "--pole-fade", fades ? Exactly(s.PoleFade) : "" },
    { Number::CircleConvergence, "--convergence",
      s.CircleConvergence > 0 ? Exactly(s.CircleConvergence) : "" },
    { Number::Iod, "--iod", Exactly(s.Iod) },
    { Number::Distance, "--distance", Exactly(s.Distance) },
    { Number::Offset, "--offset", Exactly(s.Offset) },
    { Number::Separation, "--separation", Exactly(s.Separation) },
    { Number::Convergence, "--convergence", Exactly(s.Convergence) }
  };
  for (const auto& [number, option, value] : all)
  {
    if (StereoOf(o).Has(number) && !value.empty())
    {
      Add(list, option, value);
    }
  }
}

void AddStereo(const Options& o, List& list)
{
  const wfv::StereoOptions& s = o.View.Stereo;
  if (!HasTwoEyes(o))
  {
    return;
  }
  Add(list, "--stereo", o.Stereo);
  Add(list, "--layout", o.Layout);
  if (o.Layout == "anaglyph")
  {
    AddGlasses(o, list);
  }
  if (o.Screens.empty())
  {
    AddNumbers(o, list);
    return;
  }
  Add(list, "--ipd", Exactly(s.InterpupillaryDistance));
  if (ShowsCube(o))
  {
    Add(list, "--offset", Exactly(s.Offset));
  }
}

void AddDrawing(const Options& o, List& list)
{
  Add(list, "--technique", o.TechniqueName);
  Add(list, "--tolerance", Exactly(o.Tolerance));
  Add(list, "--samples", std::to_string(o.Samples));
  Add(list, "--depth", o.Depth);
  if (o.Technique == Technique::CubeMap)
  {
    Add(list, "--cubemap-resolution", std::to_string(o.CubeMapResolution));
  }
  o.HasClip ? Add(list, "--clip", Exactly(o.View.Radii)) : void();
  o.ExactPerspective ? Add(list, "--exact-perspective") : void();
  o.DebugView ? Add(list, "--debug-view") : void();
  AddStereo(o, list);
  Add(list, "--background", Exactly(o.Background));
  o.Zenith ? Add(list, "--zenith", Exactly(*o.Zenith)) : void();
  o.Sky.empty() ? void() : Add(list, "--sky", o.Sky);
}

// What is seen, and how large: of screens only where they are all alike.
void AddView(const Options& o, List& list)
{
  if (o.Screens.empty() || ShowsCube(o))
  {
    Add(list, "--projection", o.Projection);
    AddFieldOfView(o, list);
    Add(list, "--tilt", Exactly(o.View.Tilt));
  }
  if (o.Screens.empty() || o.HasSize)
  {
    Add(list, "--size", std::to_string(o.Size[0]) + "x" + std::to_string(o.Size[1]));
  }
}

void AddRoom(const Options& o, List& list)
{
  o.Screens.empty() ? void() : Add(list, "--screens", o.Screens);
  o.Poses.empty() ? void() : Add(list, "--pose", o.Poses);
  o.RoomScale == 1 ? void() : Add(list, "--room-scale", Exactly(o.RoomScale));
}
}

std::vector<Setting> SettingsOf(const Options& given, const Options& now)
{
  List list;
  given.Scene.empty() ? void() : Add(list, "--scene", given.Scene);
  for (const std::string& file : given.Files)
  {
    Add(list, "FILE", file);
  }
  given.Time ? Add(list, "--time", Exactly(*given.Time)) : void();
  AddLook(now.Look, list);
  AddView(now, list);
  AddRoom(now, list);
  if (now.Eye && now.Direction && now.Up)
  {
    Add(list, "--eye", Exactly(*now.Eye));
    Add(list, "--direction", Exactly(*now.Direction));
    Add(list, "--up", Exactly(*now.Up));
  }
  AddDrawing(now, list);
  return list;
}

std::string CommandText(const Options& given, const Options& now)
{
  std::string text = "widefov-render";
  for (const Setting& setting : SettingsOf(given, now))
  {
    text += setting.Option == "FILE" ? "" : " " + setting.Option;
    text += setting.Value.empty() ? "" : " " + Quoted(setting.Value);
  }
  return text + " --output picture.png";
}
}
