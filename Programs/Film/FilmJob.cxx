// SPDX-License-Identifier: BSD-3-Clause
#include "FilmJob.h"

#include "Ffmpeg.h"
#include "FilmParts.h"
#include "FilmPath.h"
#include "FilmProgress.h"
#include "FilmSink.h"
#include "FilmWriter.h"
#include "Options/Codecs.h"
#include "Options/FilmOptions.h"
#include "Pictures/DirectionMapFile.h"
#include "Pictures/EyeDistance.h"
#include "Pictures/FilmScenes.h"
#include "Pictures/FirstView.h"
#include "Pictures/Listing.h"
#include "Pictures/LoadScene.h"
#include "Pictures/RenderStats.h"
#include "Pictures/SightsStage.h"
#include "Pictures/SkyPicture.h"
#include "System/Display.h"
#include "System/OutputFiles.h"
#include "System/Progress.h"
#include "System/Signals.h"
#include "System/StandardInput.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace widefov
{
namespace
{
using Sinks = std::vector<std::unique_ptr<FilmSink>>;

constexpr double UsualSeconds = 10;

// Along the way, where eyes are fitted to the nearest thing.
constexpr int PlacesToFit = 8;

void CheckPlaces(const Options& o)
{
  for (const std::string& output : o.Outputs)
  {
    for (const std::string& file : FilesOfFilm(o, output))
    {
      if (FindContainer(file) != nullptr)
      {
        CheckMakeable(file);
      }
    }
  }
  if (!o.Stats.empty())
  {
    CheckWritable(o.Stats);
  }
}

FilmPlan PlanOf(const FilmOptions& film, std::size_t steps)
{
  FilmPlan plan;
  const bool each = film.Seconds == 0 && film.Kind == "time";
  const double seconds = film.Seconds > 0 ? film.Seconds : UsualSeconds;
  plan.Frames =
    each ? static_cast<int>(steps) : std::max(1, static_cast<int>(std::lround(seconds * film.Fps)));
  const auto begin = [&](long long part) {
    return static_cast<int>(part * plan.Frames / film.Parts);
  };
  plan.First = begin(film.Part - 1);
  plan.End = begin(film.Part);
  return plan;
}

bool IsSmooth(const FilmOptions& film, const FilmPath& path)
{
  return film.Ease == "smooth" || (film.Ease == "auto" && !path.Closed);
}

std::vector<int> MissingFrames(const Sinks& sinks, const FilmPlan& plan)
{
  std::vector<int> missing;
  for (int frame = plan.First; frame < plan.End; frame++)
  {
    const bool there = std::all_of(
      sinks.begin(), sinks.end(), [frame](const auto& sink) { return sink->Has(frame); });
    if (!there)
    {
      missing.push_back(frame);
    }
  }
  return missing;
}

long long BytesOf(const Sinks& sinks)
{
  long long bytes = 0;
  for (const std::unique_ptr<FilmSink>& sink : sinks)
  {
    bytes += sink->GetBytes();
  }
  return bytes;
}

void Place(Options& o, const Pose& pose)
{
  o.LookAt.reset();
  o.Eye = pose.Eye;
  o.Direction = pose.Direction;
  o.Up = pose.Up;
}

// One frame after the other, in one window.
class FilmDrawing
{
public:
  FilmDrawing(const Options& o, FilmScenes& scenes, const FilmPath& path, const FilmPlan& plan)
    : Sight(o)
    , Scenes(scenes)
    , Path(path)
    , Plan(plan)
  {
  }

  // The pictures of a frame.
  std::vector<Picture> Draw(int frame);

  RenderStats TakeStats() { return this->Stats; }

private:
  void ShowStep(std::size_t step);

  Options Sight; // changes from frame to frame
  FilmScenes& Scenes;
  const FilmPath& Path;
  FilmPlan Plan;
  const DisplayConnection Display;
  std::optional<SightsStage> Stage;
  std::optional<std::size_t> Step;
  std::vector<Picture> Last;
  RenderStats Stats;
};

void FilmDrawing::ShowStep(std::size_t step)
{
  const Scene& scene = this->Scenes.GetScene(step);
  if (!this->Stage)
  {
    this->Stage.emplace(scene, this->Sight);
    this->Stats.Gl = this->Stage->GetStrings();
  }
  else
  {
    this->Stage->SetScene(scene, this->Sight);
  }
  this->Stats.PropsTotal = static_cast<int>(scene.Props.size());
  this->Step = step;
}

std::vector<Picture> FilmDrawing::Draw(int frame)
{
  const FilmOptions& film = this->Sight.Film;
  const std::size_t step = this->Scenes.StepAt(static_cast<double>(frame) / this->Plan.Frames);
  const bool same = this->Step == step;
  if (!same)
  {
    this->ShowStep(step);
  }
  if (film.Kind == "time" && same)
  {
    return this->Last; // nothing moves
  }
  const double share =
    ShareOfWay(frame, this->Plan.Frames, this->Path.Closed, IsSmooth(film, this->Path));
  Place(this->Sight, this->Path.At(share));
  const Stopwatch watch;
  std::vector<Picture> drawn = this->Stage->Take(this->Sight);
  this->Stats.Milliseconds.push_back(watch.GetMilliseconds());
  if (film.Kind == "time")
  {
    this->Last = drawn;
  }
  return drawn;
}

void DrawAll(FilmDrawing& drawing, const FilmPlan& plan, bool quiet, Sinks& sinks)
{
  const std::vector<int> missing = MissingFrames(sinks, plan);
  const int there = plan.End - plan.First - static_cast<int>(missing.size());
  FilmWriter writer(sinks);
  FilmProgress progress(plan.End - plan.First, there, quiet);
  const QuietStandardError silent;
  for (const int frame : missing)
  {
    if (Interrupts::Came())
    {
      Fail("interrupted");
    }
    writer.Push({ frame, drawing.Draw(frame) });
    progress.Update(there + writer.GetWritten(), BytesOf(sinks));
  }
  writer.Drain();
}

// One distance between the eyes for the whole film, which fits where something is nearest.
void FitEyesAlong(Options& o, const Scene& scene, const FilmPath& path)
{
  double least = HUGE_VAL;
  for (int i = 0; i < (o.EyesByDepth ? PlacesToFit : 1); i++)
  {
    Options there = o;
    Place(there, path.At(static_cast<double>(i) / PlacesToFit));
    FitEyes(there, scene);
    least = std::min(least, there.View.Stereo.InterpupillaryDistance);
  }
  o.View.Stereo.InterpupillaryDistance = least;
}

// What went wrong, and what is not lost.
[[noreturn]] void FailKeeping(const Failure& failure, const FilmPlan& plan, const Sinks& sinks)
{
  for (const std::unique_ptr<FilmSink>& sink : sinks)
  {
    sink->Keep();
  }
  const auto missing = static_cast<int>(MissingFrames(sinks, plan).size());
  const bool some = BytesOf(sinks) > 0 || missing < plan.End - plan.First;
  throw Failure(failure.ExitCode,
    failure.what() +
      std::string(some ? "; frames that are finished are kept, and --resume goes on" : ""));
}

// In one line: how many frames are in each file that is whole.
void SayWhere(const Options& o, const FilmPlan& plan)
{
  const std::string count = std::to_string(plan.Frames);
  const std::string all = count + (plan.Frames == 1 ? " frame is" : " frames are");
  const std::string part = o.Film.Parts == 1 ? all
                                             : "frames " + std::to_string(plan.First + 1) + " to " +
      std::to_string(plan.End) + " of " + count + " are";
  std::string text;
  for (const std::string& output : o.Outputs)
  {
    for (const std::string& file : FilesOfFilm(o, output))
    {
      const bool film = FindContainer(file) != nullptr;
      std::error_code error;
      if (!film || !std::filesystem::exists(FilmParts::FolderOf(file), error))
      {
        text += (text.empty() ? "" : "; ") + (film ? all : part) + " in " + file;
      }
    }
  }
  if (!text.empty())
  {
    Say(text);
  }
}

void WriteStats(const Options& o, const Scene& scene, const RenderStats& stats)
{
  if (!o.Stats.empty())
  {
    OutputFiles files;
    const std::string text = StatsText(o, scene, stats);
    files.Write(o.Stats, text.data(), text.size());
    files.Commit();
  }
}
}

Scene MakeFilm(Options& o)
{
  CheckPlaces(o);
  CheckFfmpeg(o);
  LoadDirectionMap(o);
  LoadSky(o);
  const StandardInput input(o.Files);
  FilmScenes scenes(o);
  CheckPlaces(o); // of files that the data name, too
  const Scene first = scenes.GetFirstFilled();
  TellOfScene(first);
  const bool placed = o.Eye || SaysWhereTheEyeGoes(o.Film);
  ChooseView(o, first, placed ? vtkBoundingBox() : scenes.FindBounds());
  const FilmPath path = MakeFilmPath(first, o);
  FitEyesAlong(o, first, path);
  const FilmPlan plan = PlanOf(o.Film, scenes.GetNumberOfSteps());
  FilmDrawing drawing(o, scenes, path, plan);
  const Interrupts interrupts;
  Sinks sinks = OpenSinks(o, plan);
  try
  {
    DrawAll(drawing, plan, o.Quiet, sinks);
    const Progress progress("joining the film");
    for (const std::unique_ptr<FilmSink>& sink : sinks)
    {
      sink->Finish();
    }
  }
  catch (const Failure& failure)
  {
    FailKeeping(failure, plan, sinks);
  }
  const RenderStats stats = drawing.TakeStats();
  WriteStats(o, first, stats);
  Tell("drawn by " + stats.Gl.Renderer + ", OpenGL " + stats.Gl.Version);
  SayWhere(o, plan);
  return first;
}
}
