// SPDX-License-Identifier: BSD-3-Clause
#include "OptionCheck.h"

#include "Borders.h"
#include "Displays.h"
#include "FilmOptions.h"
#include "LensView.h"
#include "OutputNames.h"
#include "RoomOptions.h"
#include "Scenes/MeshBuilder.h"
#include "StereoChoice.h"
#include "StereoLayout.h"
#include "StereoOptions.h"
#include "System/InputFiles.h"
#include "System/OutputFiles.h"
#include "Text/Angles.h"
#include "Text/Messages.h"
#include "Text/OptionValues.h"
#include "WarpOptions.h"
#include "WebOptions.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace widefov
{
namespace
{
// Horizontal field of view of the perspective where none is given, degrees.
constexpr double PerspectiveFov = 90;

// Square pixels: the angle across `to` pixels where `angle` (degrees) spans `from`.
double PlanarFov(double angle, double from, double to)
{
  return 2 * std::atan(std::tan(0.5 * angle * Degree) * to / from) / Degree;
}

void CompletePlanar(Options& o, const wfv::Projection& p, const FieldsOfView& fov)
{
  const double width = o.Size[0];
  const double height = o.Size[1];
  wfv::ViewOptions& v = o.View;
  if (fov.Horizontal || !fov.Vertical)
  {
    v.HorizontalFov = fov.Horizontal.value_or(PerspectiveFov);
    v.VerticalFov =
      fov.Vertical.value_or(std::min(p.MaxVerticalFov, PlanarFov(v.HorizontalFov, width, height)));
  }
  else
  {
    v.VerticalFov = *fov.Vertical;
    v.HorizontalFov = std::min(p.MaxHorizontalFov, PlanarFov(v.VerticalFov, height, width));
  }
}

void CheckDirectionMap(const Options& o, const wfv::Projection& p)
{
  const bool sampled = p.Axis == wfv::Family::Sampled;
  if (sampled == (o.DirectionMap.empty() && !o.UnevenLens))
  {
    std::error_code error;
    FailUsage(sampled ? "--projection direction-map needs --direction-map FILE.exr, or one of " +
          Join(DisplayNames())
        : FindDisplay(o.DirectionMap) != nullptr || std::filesystem::exists(o.DirectionMap, error)
        ? "--direction-map goes with --projection direction-map alone"
        : "--direction-map: there is no file or map '" + o.DirectionMap + "'" +
          DidYouMean(NearestName(o.DirectionMap, DisplayNames())) + "; give a file, or one of " +
          Join(DisplayNames()));
  }
}

// A display that is known by name needs no other projection and has a size of its own.
void TakeDisplay(Options& o)
{
  const Display* const display = FindDisplay(o.DirectionMap);
  if (display)
  {
    o.Projection = o.HasProjection ? o.Projection : "direction-map";
    o.Size = o.HasSize ? o.Size : display->Size;
  }
}

void TakeLens(Options& o, const FieldsOfView& fov)
{
  std::copy(fov.Lens.begin(), fov.Lens.end(), o.View.Lens.begin());
  if (!fov.Lens.empty() &&
    std::all_of(fov.Lens.begin(), fov.Lens.end(), [](double c) { return c == 0; }))
  {
    FailUsage("--lens: all coefficients are zero; at least one must not be");
  }
}

void CompleteView(Options& o, const FieldsOfView& given)
{
  const FieldsOfView fov = TakeLensFile(o, given);
  TakeDisplay(o);
  const wfv::Projection& p = *wfv::FindProjection(o.Projection);
  wfv::ViewOptions& v = o.View;
  v.Aspect = double(o.Size[0]) / o.Size[1];
  if (fov.Round && p.Axis != wfv::Family::Azimuthal)
  {
    FailUsage("--fov is for round projections; give " + p.Name + " --hfov and --vfov");
  }
  if (p.Axis == wfv::Family::Planar)
  {
    CompletePlanar(o, p, fov);
  }
  else if (p.Axis == wfv::Family::Azimuthal)
  {
    v.HorizontalFov =
      fov.Round.value_or(fov.Horizontal.value_or(std::min(360., p.MaxHorizontalFov)));
    v.VerticalFov =
      fov.Round || !fov.Vertical ? std::min(v.HorizontalFov, p.MaxVerticalFov) : *fov.Vertical;
  }
  else
  {
    v.HorizontalFov = fov.Horizontal.value_or(std::min(360., p.MaxHorizontalFov));
    v.VerticalFov = fov.Vertical.value_or(std::min(180., p.MaxVerticalFov));
  }
  TakeBorders(o, p, given);
  CheckDirectionMap(o, p);
  TakeLens(o, fov);
  TakeCircle(o, p);
  CompleteStereo(o);
  const std::string complaint = wfv::CheckOptions(p, v);
  if (!complaint.empty())
  {
    FailUsage(complaint);
  }
  TakeWarp(o);
}

void CheckCamera(const Options& o)
{
  if (o.LookAt && o.Direction)
  {
    FailUsage("--look-at and --direction exclude each other; give one");
  }
  if (o.Direction && Length(*o.Direction) == 0)
  {
    FailUsage("--direction: 0,0,0 is no direction");
  }
  if (o.Up && Length(*o.Up) == 0)
  {
    FailUsage("--up: 0,0,0 is no direction");
  }
  if (o.Eye && o.LookAt && *o.Eye == *o.LookAt)
  {
    FailUsage("--look-at is the same point as --eye; choose another");
  }
}

void CheckFirstView(const Options& o)
{
  if (o.Inside && o.Outside)
  {
    FailUsage("--inside and --outside exclude each other; give one");
  }
  if (o.Look.Volume && !o.Look.UsualVolume)
  {
    FailUsage("--volume and --no-volume exclude each other; give one");
  }
  if (o.Eye && (o.Inside || o.Outside))
  {
    FailUsage("--eye says where the eye is; leave --inside and --outside out");
  }
}

// Something is printed instead of drawn: nothing else need be right.
bool OnlyLists(const Options& o)
{
  return o.ListProjections || o.ListScenes || o.ListFormats || o.ListPresets ||
    !o.ListArrays.empty() || o.Version;
}

void CheckInput(const Options& o)
{
  if (o.Info && o.Files.empty())
  {
    FailUsage("--info says what files hold; give one or more");
  }
  if (!o.Scene.empty() && !o.Files.empty())
  {
    FailUsage("--scene and files exclude each other; give one or the other");
  }
  if (o.Scene.empty() && o.Files.empty())
  {
    FailUsage("no input; give a file or --scene NAME (--list-scenes prints the names)");
  }
  if (o.Look.Range && !((*o.Look.Range)[0] < (*o.Look.Range)[1]))
  {
    FailUsage("--range: the first value must be below the second");
  }
}

// Two names of one file, existing or not.
bool SameFile(const std::string& a, const std::string& b)
{
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error))
  {
    return true;
  }
  return std::filesystem::weakly_canonical(a, error) == std::filesystem::weakly_canonical(b, error);
}

// Every file that is written; their endings are checked.
std::vector<std::string> AllOutputs(const Options& o)
{
  std::vector<std::string> all;
  for (const std::string& output : o.Outputs)
  {
    if (!HasFilm(o))
    {
      CheckPictureName(output);
    }
    const std::vector<std::string> files = HasFilm(o) ? FilesOfFilm(o, output) : FilesOf(o, output);
    all.insert(all.end(), files.begin(), files.end());
  }
  if (!o.Aov.empty())
  {
    CheckAovName(o.Aov);
    all.push_back(o.Aov);
  }
  if (!o.Stats.empty())
  {
    all.push_back(o.Stats);
  }
  return all;
}

// Every file that an option names and that is read.
std::vector<std::string> AllInputs(const Options& o)
{
  std::vector<std::string> all = o.Files;
  all.insert(all.end(),
    { o.Config, o.DirectionMap, o.Warp, o.Projectors, o.LensFile,
      o.LensFile.substr(0, o.LensFile.rfind('#')), o.Screens, o.Poses, o.Sky, o.Film.Audio,
      o.Film.Path });
  all.erase(std::remove_if(all.begin(), all.end(),
              [](const std::string& name) { return name.empty() || name == StandardStream; }),
    all.end());
  return all;
}

// Standard output takes one file, and no list of several.
void CheckStandardStream(const Options& o)
{
  const bool separate = HasTwoEyes(o) && FindStereoLayout(o.Layout).Separate;
  const bool several = separate || HasRoom(o) || !o.Projectors.empty();
  if (several && std::count(o.Outputs.begin(), o.Outputs.end(), StandardStream) > 0)
  {
    FailUsage("--output - takes one picture, not those of " +
      std::string(separate ? "--layout " + o.Layout : "--screens, --pose and --display") +
      "; name files");
  }
}

void CheckOutput(const Options& o)
{
  CheckStandardStream(o);
  const std::vector<std::string> all = AllOutputs(o);
  if (all.empty() && o.Web.empty() && o.DumpShaders.empty() && !o.DryRun)
  {
    FailUsage("nothing to write; give -o FILE, --web FOLDER, --aov FILE.exr, --stats FILE.json or "
              "--dump-shaders DIR");
  }
  for (const std::string& input : AllInputs(o))
  {
    NoteInput(input);
  }
  for (std::size_t i = 0; i < all.size(); i++)
  {
    for (std::size_t j = 0; j < i; j++)
    {
      if (SameFile(all[i], all[j]))
      {
        FailUsage(all[i] + " is named twice as output; give each its own name");
      }
    }
    for (const std::string& input : AllInputs(o))
    {
      if (SameFile(all[i], input))
      {
        FailUsage(all[i] + " is an input file; write somewhere else");
      }
    }
  }
}

void CheckDrawing(Options& o)
{
  o.View.Mapping = o.Depth == "log" ? wfv::DepthMapping::Logarithmic
    : o.Depth == "reversed"         ? wfv::DepthMapping::Reversed
                                    : wfv::DepthMapping::Linear;
  const bool wide = wfv::FindProjection(o.Projection)->Axis != wfv::Family::Planar;
  const bool drawn =
    wide || (o.ExactPerspective && wfv::FitsFrame(o.View) && !HasTwoEyes(o) && o.Screens.empty());
  const bool stock = o.Technique == Technique::CubeMap || !drawn;
  if (stock &&
    (o.DebugView || o.Overlay || o.Zenith || o.Depth != "linear" || !o.DumpShaders.empty()))
  {
    FailUsage("--debug-view, --overlay, --zenith, --depth and --dump-shaders are for what this "
              "module draws, not for " +
      std::string(wide ? "--technique cubemap" : "a perspective that stock VTK draws") +
      "; leave them out");
  }
}

void CheckScalarBar(Options& o)
{
  const std::vector<double>& at = o.ScalarBarAt;
  if (at.empty())
  {
    return;
  }
  if (std::abs(at[0]) > 360 || std::abs(at[1]) > 90 || (at.size() > 2 && !(at[2] > 0)))
  {
    FailUsage("--scalar-bar-at: the azimuth is in [-360, 360], the elevation in [-90, 90], the "
              "depth above 0");
  }
  if (o.Technique == Technique::CubeMap || !o.Screens.empty())
  {
    FailUsage("--scalar-bar-at goes neither with --technique cubemap nor with --screens; give "
              "--scalar-bar instead");
  }
  if (at.size() < 3 && HasTwoEyes(o))
  {
    FailUsage("--scalar-bar-at needs a depth for two eyes, AZ,EL,DEPTH: what is nearer hides it");
  }
  const std::array<double, 2>& clip = o.View.Radii;
  if (at.size() > 2 && o.HasClip && !(at[2] > clip[0] && at[2] < clip[1]))
  {
    FailUsage("--scalar-bar-at: the depth is not between the radii of --clip");
  }
}

void CheckTechnique(Options& o)
{
  o.Technique = TechniqueOf(o.TechniqueName);
  if (o.Technique != Technique::CubeMap)
  {
    return;
  }
  if (o.Part)
  {
    FailUsage("--borders does not go with --technique cubemap; leave one of them out");
  }
  const std::string cubemap = "--technique cubemap is VTK's own pass, which ";
  if (o.Projection != "equirectangular" && o.Projection != "azimuthal-equidistant")
  {
    FailUsage(cubemap + "knows equirectangular and azimuthal-equidistant only");
  }
  if (o.Projection == "equirectangular" && o.View.VerticalFov != 180)
  {
    FailUsage(cubemap + "always shows 180 degrees vertically; leave --vfov out");
  }
  if (o.View.Lens != wfv::ViewOptions().Lens || o.View.Measured.IsSet() || o.HasClip ||
    !o.Aov.empty() || !o.Sky.empty())
  {
    FailUsage(cubemap + "has no --lens, --circle, --clip, --aov or --sky; leave them out");
  }
}
}

void SetField(Options& o, double across)
{
  const wfv::Projection& p = *wfv::FindProjection(o.Projection);
  const double up = p.Axis == wfv::Family::Planar ? PlanarFov(across, o.Size[0], o.Size[1])
    : p.Axis == wfv::Family::Azimuthal            ? across
                                                  : across * o.Size[1] / o.Size[0];
  o.View.HorizontalFov = across;
  o.View.VerticalFov = std::min(up, p.MaxVerticalFov);
}

void CheckTiles(const Options& o)
{
  if (o.Tile && (o.Technique == Technique::CubeMap || (HasTwoEyes(o) && o.Layout == "split")))
  {
    FailUsage("--tile goes neither with --technique cubemap nor with --layout split; leave it out");
  }
  if (o.Part && !EyesFitTiles(o))
  {
    FailUsage("--borders does not go with --layout " + o.Layout +
      " and these stereo options; choose another layout");
  }
}

void CheckDrawn(Options& o)
{
  CheckTechnique(o);
  CheckDrawing(o);
  CheckStereo(o);
  CheckTiles(o);
  CheckScalarBar(o);
}

void CheckScene(Options& o, const FieldsOfView& fov)
{
  if (!OnlyLists(o))
  {
    CheckInput(o);
    CompleteRoom(o, fov);
    o.HasFov = fov.Horizontal || fov.Vertical || fov.Round || !o.Borders.empty();
    CompleteView(o, fov);
    CheckCamera(o);
    CheckFirstView(o);
    CheckDrawn(o);
  }
}

void CheckTogether(Options& o, const FieldsOfView& fov)
{
  CheckScene(o, fov);
  if (!OnlyLists(o) && !o.Info)
  {
    CheckFiles(o);
    CheckFilm(o);
    CheckWeb(o);
    CheckOutput(o);
  }
}
}
