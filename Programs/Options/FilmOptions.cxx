// SPDX-License-Identifier: BSD-3-Clause
#include "FilmOptions.h"

#include "Codecs.h"
#include "FilmIdentity.h"
#include "OptionGroup.h"
#include "OutputNames.h"
#include "Presets/Presets.h"
#include "Scenes/NumberPattern.h"
#include "StereoChoice.h"
#include "StereoLayout.h"
#include "Text/Messages.h"
#include "Text/OptionValues.h"

#include <algorithm>
#include <filesystem>

namespace widefov
{
namespace
{
constexpr double LongestFilm = 86400; // seconds
constexpr double MostFps = 1000;
constexpr double MostSweep = 36000; // degrees
constexpr int MostParts = 10000;

// "25", "29.97" or "30000/1001".
double ParseFps(const std::string& option, const std::string& text)
{
  const std::size_t slash = text.find('/');
  const Range range{ 0, slash == std::string::npos ? MostFps : 1e9, true };
  const double above = ParseNumber(option, text.substr(0, slash), range);
  const double fps =
    slash == std::string::npos ? above : above / ParseNumber(option, text.substr(slash + 1), range);
  if (!(fps >= 0.01 && fps <= MostFps))
  {
    FailUsage(option + ": '" + text + "' is not in [0.01, 1000]");
  }
  return fps;
}

void ParsePart(const std::string& option, const std::string& text, FilmOptions& film)
{
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos)
  {
    FailUsage(option + ": '" + text + "' is not K/N, such as 2/4");
  }
  film.Parts = ParseInteger(option, text.substr(slash + 1), 1, MostParts);
  film.Part = ParseInteger(option, text.substr(0, slash), 1, film.Parts);
}

// Of a file that is no picture.
bool IsVideo(const std::string& output)
{
  return FindContainer(output) != nullptr;
}

void CheckQuality(const FilmOptions& film, const Codec& codec)
{
  if (film.Quality >= 0 && !codec.HasQuality)
  {
    FailUsage("--quality is not for " + codec.Name + ", which keeps all; leave it out");
  }
  if (film.Quality > codec.MostQuality)
  {
    FailUsage("--quality: " + std::to_string(film.Quality) + " is not in [0, " +
      std::to_string(codec.MostQuality) + "], which " + codec.Name + " takes");
  }
}

void CheckVideo(const Options& o, const std::string& output)
{
  const Container& container = *FindContainer(output);
  const std::string codec = CodecNameFor(o.Film, output);
  if (!container.Takes(codec))
  {
    FailUsage("--codec " + codec + " does not go into " + container.Ending + "; choose one of " +
      Join(container.Codecs) + ", or another ending");
  }
  CheckQuality(o.Film, *FindCodec(codec));
  if (HasTwoEyes(o) && FindStereoLayout(o.Layout).MultiView)
  {
    FailUsage("--layout " + o.Layout + " is for pictures; choose another layout for a film");
  }
  const std::array<int, 2> size = SizeOfFile(o);
  if (size[0] % 2 != 0 || size[1] % 2 != 0)
  {
    FailUsage("--size: a frame of " + std::to_string(size[0]) + "x" + std::to_string(size[1]) +
      " cannot be encoded; width and height must be even");
  }
}

void CheckFrames(const std::string& output)
{
  if (!NumberPattern::Parse(output))
  {
    FailUsage("--output: '" + output + "' is no film; give a name that ends in " +
      Join(VideoEndings()) + ", or one for numbered frames, such as frames/%05d.png");
  }
  CheckPictureName(output);
}

void CheckOthers(const Options& o)
{
  const std::pair<bool, const char*> others[] = {
    { !o.Aov.empty(), "--aov" },
    { o.Frames > 0, "--frames" },
    { o.Tile.has_value(), "--tile" },
    { !o.DumpShaders.empty(), "--dump-shaders" },
    { !o.Screens.empty(), "--screens" },
    { !o.Poses.empty(), "--pose" },
    { o.Technique == Technique::CubeMap, "--technique cubemap" },
    { o.ConvergeOnDepth, "a convergence or an offset that is auto" },
    { o.Time.has_value(), "--time" },
    { o.DryRun, "--dry-run" },
  };
  for (const auto& [given, name] : others)
  {
    if (given)
    {
      FailUsage(std::string("--film does not go with ") + name + "; leave one of them out");
    }
  }
}

void CheckKind(const Options& o)
{
  const FilmOptions& film = o.Film;
  if ((film.Kind == "path") == film.Path.empty())
  {
    FailUsage(film.Kind == "path" ? "--film path needs --path FILE, a pose a line"
                                  : "--path goes with --film path alone; leave it out");
  }
  // in a tube along the way nothing else would be seen
  if (film.Kind == "fly" && (o.Look.Vectors.empty() || !o.Look.StreamLines.empty()))
  {
    FailUsage("--film fly follows a stream line of the array of --vectors; give that, and no "
              "--streamlines, whose tubes would hide the rest");
  }
}

// frames/%05d.png of the left eye: frames/left/%05d.png
std::string InFolderOf(const std::string& output, const char* folder)
{
  const std::filesystem::path file(output);
  return (file.parent_path() / folder / file.filename()).string();
}

// An option that only films have: the setter, and a note that it was given.
OptionGroup::Setter Noting(FilmOptions& film, const OptionGroup::Setter& set)
{
  return [&film, set](const std::string& option, const std::string& value) {
    film.Given.push_back(option);
    set(option, value);
  };
}

void DeclareWay(OptionGroup& group, FilmOptions& film)
{
  group.Choice("--film", film.Kind, { "turn", "orbit", "path", "fly", "time" }, {},
    "frames instead of a picture: how the camera moves");
  group.Add("--seconds", "S", "10, or a frame each time step", "length of the film",
    Noting(film, [&film](const std::string& option, const std::string& value) {
      film.Seconds = ParseNumber(option, value, { 0, LongestFilm, true });
    }));
  group.Add("--fps", "N", film.FpsText, "frames a second: 25, 29.97, 30000/1001",
    Noting(film, [&film](const std::string& option, const std::string& value) {
      film.Fps = ParseFps(option, value);
      film.FpsText = value;
    }));
  group.Name("--path", "FILE", film.Path,
    "poses of --film path, a line each: x y z of the eye, of the direction, and, if you like, of "
    "up");
  group.Add("--sweep", "DEG", Text(film.Sweep), "how far a turn or an orbit goes, to the right",
    Noting(film, [&film](const std::string& option, const std::string& value) {
      film.Sweep = ParseNumber(option, value, { -MostSweep, MostSweep });
    }));
  group.Choice("--ease", film.Ease, { "auto", "smooth", "none" }, {},
    "slow at both ends; auto: but for whole turns");
}
}

void DeclareFilm(CLI::App& app, Options& o)
{
  OptionGroup group(app, "Film");
  FilmOptions& film = o.Film;
  DeclareWay(group, film);
  group.Choice("--codec", film.Codec, CodecNames(), {},
    "codec; auto: the preset's, or by the ending of the file");
  group.Add("--quality", "CRF", "the codec's", "0 (best) to 51 of x264 and x265, to 63 of vp9",
    Noting(film, [&film](const std::string& option, const std::string& value) {
      film.Quality = ParseInteger(option, value, 0, 63);
    }));
  group.Name("--audio", "FILE", film.Audio, "sound of the film, cut to its length");
  group.Add("--part", "K/N", "1/1", "draw one of N parts; whoever is last joins them",
    Noting(film, [&film](const std::string& option, const std::string& value) {
      ParsePart(option, value, film);
    }));
  group.Flag("--resume", film.Resume, "keep the frames that are there, and draw the others");
  group.Flag("--strict", film.Strict, "end at a time step that cannot be read");
}

void CompleteFilm(const CLI::App& app, Options& o)
{
  o.Film.Command = FilmIdentity(app);
  o.Film.PresetCodec = o.Preset.empty() ? "" : wfv::FindPreset(o.Preset)->Codec;
}

bool HasFilm(const Options& o)
{
  return !o.Film.Kind.empty();
}

bool SaysWhereTheEyeGoes(const FilmOptions& film)
{
  return film.Kind == "path" || film.Kind == "fly";
}

void CheckFilm(const Options& o)
{
  const FilmOptions& film = o.Film;
  if (!HasFilm(o))
  {
    const bool named = film.Codec != "auto" || !film.Audio.empty() || !film.Path.empty() ||
      film.Ease != "auto" || film.Resume || film.Strict;
    if (!film.Given.empty() || named)
    {
      FailUsage((film.Given.empty() ? "--codec, --audio, --path, --ease, --resume or --strict"
                                    : film.Given.front()) +
        " is for films; give --film, or leave it out");
    }
    return;
  }
  CheckOthers(o);
  CheckKind(o);
  if (o.Outputs.empty())
  {
    FailUsage("--film: nothing to write; give -o film.mp4 or -o frames/%05d.png");
  }
  for (const std::string& output : o.Outputs)
  {
    IsVideo(output) ? CheckVideo(o, output) : CheckFrames(output);
  }
  if (!film.Audio.empty() && std::none_of(o.Outputs.begin(), o.Outputs.end(), IsVideo))
  {
    FailUsage("--audio goes into a film of one file, not beside numbered frames; leave it out");
  }
}

std::vector<std::string> FilesOfFilm(const Options& o, const std::string& output)
{
  const StereoLayout& layout = FindStereoLayout(o.Layout);
  if (!HasTwoEyes(o) || !layout.Separate)
  {
    return { output };
  }
  return IsVideo(output)
    ? std::vector<std::string>{ FileOfEye(layout, output, 0), FileOfEye(layout, output, 1) }
    : std::vector<std::string>{ InFolderOf(output, "left"), InFolderOf(output, "right") };
}
}
