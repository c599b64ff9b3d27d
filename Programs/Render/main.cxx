// SPDX-License-Identifier: BSD-3-Clause
// widefov-render: pictures of VTK data in wide and non-planar projections.
#include "DryRun.h"
#include "Film/FilmJob.h"
#include "Options/FilmOptions.h"
#include "Options/Options.h"
#include "Options/OutputNames.h"
#include "Options/ParseOptions.h"
#include "Options/RoomOptions.h"
#include "Pictures/CameraSetup.h"
#include "Pictures/DirectionMapFile.h"
#include "Pictures/EyeDistance.h"
#include "Pictures/FilmScenes.h"
#include "Pictures/FirstView.h"
#include "Pictures/Info.h"
#include "Pictures/Listing.h"
#include "Pictures/LoadScene.h"
#include "Pictures/PictureFiles.h"
#include "Pictures/Sights.h"
#include "Pictures/SkyPicture.h"
#include "Pictures/Warp.h"
#include "RenderJob.h"
#include "SightsJob.h"
#include "System/OutputFiles.h"
#include "System/Program.h"
#include "System/Progress.h"
#include "System/StandardInput.h"
#include "Text/Messages.h"
#include "Web/WebPage.h"

#include <algorithm>

namespace
{
using namespace widefov;

void CheckPictures(const Options& options)
{
  for (const std::string& output : options.Outputs)
  {
    for (const std::string& file : FilesOf(options, output))
    {
      CheckWritable(file);
    }
  }
}

void CheckOutputs(const Options& options)
{
  CheckPictures(options);
  for (const std::string& output : { options.Aov, options.Stats })
  {
    if (!output.empty())
    {
      CheckWritable(output);
    }
  }
  if (!options.Web.empty())
  {
    CheckWebPage(options);
  }
  if (!options.DumpShaders.empty())
  {
    CheckFolder(options.DumpShaders);
  }
}

// Once more, before drawing: by now all files that are read are known, and all sights of a room.
void CheckInputsStay(const Options& options, const std::vector<Options>& projectors)
{
  for (const Options& projector : projectors)
  {
    CheckPictures(projector);
  }
  Sights all(options);
  for (std::vector<Options> sights = all.Next(); HasRoom(options) && !sights.empty();)
  {
    std::for_each(sights.begin(), sights.end(), CheckPictures);
    sights = all.Next();
  }
  CheckOutputs(options);
}

void WriteAll(const Options& options, const Scene& scene, RenderResult& result, OutputFiles& files)
{
  const Progress progress("writing");
  const Stopwatch watch;
  for (const std::string& output : options.Outputs)
  {
    for (const auto& [name, bytes] : EncodeFiles(options, output, result.Colors))
    {
      files.Write(name, bytes.data(), bytes.size());
    }
  }
  if (result.Aov)
  {
    const std::vector<unsigned char> bytes = EncodeFloats(*result.Aov, DescribePanorama(options));
    files.Write(options.Aov, bytes.data(), bytes.size());
  }
  if (!options.Stats.empty())
  {
    result.Stats.Parts.Writing = watch.GetMilliseconds();
    const std::string text = StatsText(options, scene, result.Stats);
    files.Write(options.Stats, text.data(), text.size());
  }
  files.Commit();
}

void DrawSights(const Options& options, const Scene& scene, double reading)
{
  OutputFiles files;
  const Stopwatch watch;
  RenderStats stats = RenderSights(scene, options, files);
  stats.Parts.Reading = reading;
  stats.Parts.Drawing = watch.GetMilliseconds();
  if (!options.Stats.empty())
  {
    const std::string text = StatsText(options, scene, stats);
    files.Write(options.Stats, text.data(), text.size());
  }
  files.Commit();
}

// For --verbose.
void TellOfPictures(const Options& options, const RenderStats& stats)
{
  Tell("drawn by " + stats.Gl.Renderer + ", OpenGL " + stats.Gl.Version);
  for (const std::string& output : options.Outputs)
  {
    for (const std::string& file : FilesOf(options, output))
    {
      Tell("written: " + file);
    }
  }
}

// Prints what is asked for instead of a picture, or makes the film.
bool DoOtherWork(Options& options)
{
  const std::string told = ListingText(options) + InfoText(options);
  if (!told.empty())
  {
    Print(told);
    return true;
  }
  if (HasFilm(options))
  {
    if (!options.Web.empty())
    {
      CheckWebPage(options);
    }
    const Scene scene = MakeFilm(options);
    if (!options.Web.empty())
    {
      WriteFilmPage(options, scene);
    }
    return true;
  }
  return false;
}

void DrawOne(const Options& options, const Scene& scene, double reading)
{
  OutputFiles files;
  RenderResult result = Render(scene, options, files);
  result.Stats.Parts.Reading = reading;
  WriteAll(options, scene, result, files);
  if (!options.Web.empty())
  {
    WritePicturePage(options, scene, result.Tiled.empty() ? result.Colors : result.Tiled);
  }
  TellOfPictures(options, result.Stats);
}

// projectors: those of a display, a picture each; none: one picture.
void Draw(const Options& options, const std::vector<Options>& projectors, const Scene& scene,
  double reading)
{
  TellOfScene(scene);
  if (HasRoom(options))
  {
    DrawSights(options, scene, reading);
    return;
  }
  for (const Options& projector : projectors)
  {
    DrawOne(WithProjector(options, projector), scene, reading);
  }
  if (projectors.empty())
  {
    DrawOne(options, scene, reading);
  }
}

// Reads the display. The names of the files are known then, and the first projector's view stands
// for all where the eye is chosen.
std::vector<Options> TakeProjectors(Options& options)
{
  if (options.Projectors.empty())
  {
    return {};
  }
  std::vector<Options> projectors = LoadProjectors(options);
  for (const Options& projector : projectors)
  {
    if (!options.DryRun)
    {
      CheckOutputs(projector);
    }
  }
  options = WithProjector(options, projectors[0]);
  return projectors;
}

int Run(int argc, char** argv)
{
  Options options;
  if (const std::optional<int> done = ParseOptions(argc, argv, options))
  {
    return *done;
  }
  if (DoOtherWork(options))
  {
    return ExitDone;
  }
  if (!options.DryRun && options.Projectors.empty())
  {
    CheckOutputs(options);
  }
  LoadDirectionMap(options);
  const std::vector<Options> projectors = TakeProjectors(options);
  LoadSky(options);
  CheckSights(options);
  const Stopwatch watch;
  const StandardInput input(options.Files);
  const Scene scene = LoadScene(options);
  ChooseView(options, scene);
  const double reading = watch.GetMilliseconds();
  MakePose(scene, options); // complains before a window is opened
  FitEyes(options, scene);
  if (options.DryRun)
  {
    Print(DryRunText(options, scene));
    return ExitDone;
  }
  CheckInputsStay(options, projectors);
  Draw(options, projectors, scene, reading);
  return ExitDone;
}
}

int main(int argc, char** argv)
{
  return RunProgram("widefov-render", [=] { return Run(argc, argv); });
}
