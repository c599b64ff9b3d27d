// SPDX-License-Identifier: BSD-3-Clause
#include "CommandText.h"

#include "StereoChoice.h"
#include "StereoOptions.h"

#include <cstdio>
#include <utility>

namespace widefov
{
namespace
{
// So that a shell takes it as one word.
std::string Quoted(const std::string& text)
{
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

std::string Exactly(const Vector3& v)
{
  return Exactly(v[0]) + "," + Exactly(v[1]) + "," + Exactly(v[2]);
}

std::string FieldOfViewText(const Options& o)
{
  const wfv::Projection& p = *wfv::FindProjection(o.Projection);
  if (p.Axis == wfv::Family::Sampled)
  {
    return o.UnevenLens ? " --lens-file " + Quoted(o.LensFile)
                        : " --direction-map " + Quoted(o.DirectionMap);
  }
  if (p.Axis != wfv::Family::Azimuthal)
  {
    return " --hfov " + Exactly(o.View.HorizontalFov) + " --vfov " + Exactly(o.View.VerticalFov);
  }
  std::string text = " --fov " + Exactly(o.View.HorizontalFov);
  if (o.View.Measured.IsSet() && o.Circle.empty())
  {
    return text + " --lens-file " + Quoted(o.LensFile);
  }
  for (std::size_t i = 0; i < o.Circle.size() && o.View.Measured.IsSet(); i++)
  {
    text += (i > 0 ? "," : " --circle ") + Exactly(o.Circle[i]);
  }
  if (o.View.Lens != wfv::ViewOptions().Lens)
  {
    text += " --lens ";
    for (std::size_t i = 0; i < o.View.Lens.size(); i++)
    {
      text += (i > 0 ? "," : "") + Exactly(o.View.Lens[i]);
    }
  }
  return text;
}

std::string LookText(const Look& look)
{
  const Look standard;
  std::string text;
  const auto name = [&text](
                      const char* option, const std::string& value, const std::string& usual) {
    text += value == usual ? "" : " " + std::string(option) + " " + Quoted(value);
  };
  name("--color-by", look.ColorBy, standard.ColorBy);
  name("--colormap", look.ColorMap, standard.ColorMap);
  name("--representation", look.Representation, standard.Representation);
  name("--vectors", look.Vectors, standard.Vectors);
  name("--streamlines", look.StreamLines, standard.StreamLines);
  name("--line-width", Exactly(look.LineWidth), Exactly(standard.LineWidth));
  name("--point-size", Exactly(look.PointSize), Exactly(standard.PointSize));
  text +=
    look.Range ? " --range " + Exactly((*look.Range)[0]) + "," + Exactly((*look.Range)[1]) : "";
  text += look.LinesAsTubes ? " --lines-as-tubes" : "";
  text += look.PointsAsSpheres ? " --points-as-spheres" : "";
  text += look.ScalarBar ? " --scalar-bar" : "";
  text += look.Colors ? "" : " --no-colors";
  text += look.UsualBar ? "" : " --no-scalar-bar";
  text += look.Smooth ? "" : " --no-smooth";
  text += look.Surface ? "" : " --no-surface";
  text += look.Volume ? " --volume" : "";
  text += look.UsualVolume ? "" : " --no-volume";
  return text;
}

std::string GlassesText(const Options& o)
{
  static const Options standard;
  const bool usual = o.AnaglyphMask == standard.AnaglyphMask;
  const std::string colors =
    AnaglyphColors()[o.AnaglyphMask[0] - 1] + "," + AnaglyphColors()[o.AnaglyphMask[1] - 1];
  return (usual ? "" : " --anaglyph " + colors) +
    (o.AnaglyphSaturation == standard.AnaglyphSaturation
        ? ""
        : " --anaglyph-saturation " + Exactly(o.AnaglyphSaturation));
}

// The numbers that the model has.
std::string NumbersText(const Options& o)
{
  using Number = wfv::StereoNumber;
  const wfv::StereoOptions& s = o.View.Stereo;
  const bool fades = s.PoleFade[0] < s.PoleFade[1];
  const std::pair<Number, std::string> all[] = { { Number::InterpupillaryDistance,
                                                   " --ipd " + Exactly(s.InterpupillaryDistance) },
    { Number::PoleFade,
      fades ? " --pole-fade " + Exactly(s.PoleFade[0]) + "," + Exactly(s.PoleFade[1]) : "" },
    { Number::Iod, " --iod " + Exactly(s.Iod) },
    { Number::Distance, " --distance " + Exactly(s.Distance) },
    { Number::Offset, " --offset " + Exactly(s.Offset) },
    { Number::Separation, " --separation " + Exactly(s.Separation) },
    { Number::Convergence, " --convergence " + Exactly(s.Convergence) } };
  std::string text;
  for (const auto& [number, option] : all)
  {
    text += StereoOf(o).Has(number) ? option : "";
  }
  return text;
}

std::string StereoText(const Options& o)
{
  const wfv::StereoOptions& s = o.View.Stereo;
  if (!HasTwoEyes(o))
  {
    return "";
  }
  const std::string text = " --stereo " + o.Stereo + " --layout " + o.Layout +
    (o.Layout == "anaglyph" ? GlassesText(o) : "");
  if (o.Screens.empty())
  {
    return text + NumbersText(o);
  }
  return text + " --ipd " + Exactly(s.InterpupillaryDistance) +
    (ShowsCube(o) ? " --offset " + Exactly(s.Offset) : "");
}

std::string DrawingText(const Options& o)
{
  std::string text = " --technique " + o.TechniqueName + " --tolerance " + Exactly(o.Tolerance) +
    " --samples " + std::to_string(o.Samples) + " --depth " + o.Depth;
  if (o.Technique == Technique::CubeMap)
  {
    text += " --cubemap-resolution " + std::to_string(o.CubeMapResolution);
  }
  text += o.HasClip ? " --clip " + Exactly(o.View.Radii[0]) + "," + Exactly(o.View.Radii[1]) : "";
  text += o.ExactPerspective ? " --exact-perspective" : "";
  text += o.DebugView ? " --debug-view" : "";
  text += StereoText(o) + " --background " + Exactly(o.Background);
  text += o.Zenith ? " --zenith " + Exactly(*o.Zenith) : "";
  return text + (o.Sky.empty() ? "" : " --sky " + Quoted(o.Sky));
}
}

namespace
{
// What is seen, and how large: of screens only where they are all alike.
std::string ViewText(const Options& o)
{
  std::string text;
  if (o.Screens.empty() || ShowsCube(o))
  {
    text +=
      " --projection " + o.Projection + FieldOfViewText(o) + " --tilt " + Exactly(o.View.Tilt);
  }
  if (o.Screens.empty() || o.HasSize)
  {
    text += " --size " + std::to_string(o.Size[0]) + "x" + std::to_string(o.Size[1]);
  }
  return text;
}

std::string RoomText(const Options& o)
{
  return (o.Screens.empty() ? "" : " --screens " + Quoted(o.Screens)) +
    (o.Poses.empty() ? "" : " --pose " + Quoted(o.Poses)) +
    (o.RoomScale == 1 ? "" : " --room-scale " + Exactly(o.RoomScale));
}
}

std::string CommandText(const Options& given, const Options& now)
{
  std::string text = "widefov-render";
  if (!given.Scene.empty())
  {
    text += " --scene " + given.Scene;
  }
  for (const std::string& file : given.Files)
  {
    text += " " + Quoted(file);
  }
  text += LookText(now.Look) + ViewText(now) + RoomText(now);
  if (now.Eye && now.Direction && now.Up)
  {
    text += " --eye " + Exactly(*now.Eye) + " --direction " + Exactly(*now.Direction) + " --up " +
      Exactly(*now.Up);
  }
  return text + DrawingText(now) + " --output picture.png";
}
}
