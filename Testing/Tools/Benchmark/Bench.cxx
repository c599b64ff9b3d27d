// SPDX-License-Identifier: BSD-3-Clause
#include "Bench.h"

#include "BenchStage.h"
#include "System/Display.h"
#include "Environment.h"
#include "ErrorMeasure.h"
#include "Text/Messages.h"
#include "Plan.h"
#include "System/Progress.h"
#include "Options/StereoChoice.h"
#include "Summary.h"

#include <algorithm>
#include <cstdlib>

namespace wfv
{
namespace bench
{
namespace
{
constexpr int WarmUpFrames = 2; // a frame that compiles shaders, and one that does not
constexpr int LeastFrames = 3;
constexpr int MostFrames = 25;

// What the timed frames of one scene may take, all runs together, seconds; the least
// number of frames may take longer.
constexpr double QuickBudget = 12;
constexpr double FullBudget = 120;

std::vector<Record> MakeRecords(BenchStage& stage)
{
  std::vector<Record> records;
  for (const BenchEntry& entry : stage.GetEntries())
  {
    Record record;
    record.Scene = stage.GetScene().Name;
    record.Triangles = stage.GetScene().Triangles;
    record.Run = entry.Run;
    records.push_back(record);
  }
  return records;
}

// Returns what one frame of every run takes, milliseconds.
double WarmUp(BenchStage& stage, std::vector<Record>& records)
{
  double all = 0;
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    BenchEntry& entry = stage.GetEntries()[i];
    double last = 0;
    for (int frame = 0; frame < WarmUpFrames; ++frame)
    {
      last = stage.Draw(entry).Passed;
    }
    all += records[i].Note.empty() ? last : 0;
  }
  return all;
}

// Round robin: what slows the machine down for a while slows every run.
void Time(BenchStage& stage, std::vector<Record>& records, int frames)
{
  widefov::Progress progress("timing " + stage.GetScene().Name);
  for (int frame = 0; frame < frames; ++frame)
  {
    for (std::size_t i = 0; i < records.size(); ++i)
    {
      if (records[i].Note.empty())
      {
        const FrameTime time = stage.Draw(stage.GetEntries()[i]);
        records[i].Milliseconds.push_back(time.Passed);
        records[i].ProcessorMilliseconds.push_back(time.Processor);
      }
    }
    progress.Update(double(frame + 1) / frames);
  }
}

void CountFragments(BenchStage& stage, std::vector<Record>& records)
{
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    if (records[i].Note.empty())
    {
      records[i].Fragments = stage.CountFragments(stage.GetEntries()[i]);
    }
  }
}

void FitFloors(BenchStage& stage, ErrorMeasure& measure, std::vector<Record>& records)
{
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    BenchEntry& entry = stage.GetEntries()[i];
    if (entry.Run.Method == "floor")
    {
      records[i].Covered = stage.FitFloor(entry, measure.CountHits(entry));
    }
  }
}

void MeasureErrors(BenchStage& stage, ErrorMeasure& measure, std::vector<Record>& records)
{
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    BenchEntry& entry = stage.GetEntries()[i];
    if (HasTwoEyes(entry.Run.Options) || entry.Run.Method == SmoothCubeMap)
    {
      continue; // the tests compare each eye; pixels of four times as many are not those cast
    }
    if (records[i].Note.empty())
    {
      records[i].Error = measure.Measure(entry);
    }
    if (!records[i].Covered)
    {
      records[i].Covered = measure.CountHits(entry);
    }
  }
}

// Shaders are compiled as on a machine that never drew them, which keeps nothing of them on disk.
void CompileAnew()
{
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
  setenv("__GL_SHADER_DISK_CACHE", "0", 0);
}

// The first frame of every method, each in a window of its own that is gone before the next one.
// None but where first frames are asked for: each takes seconds.
std::vector<std::optional<double>> TimeFirstFrames(
  const BenchScene& scene, const std::vector<Run>& plan)
{
  const widefov::Progress progress("first frames of " + scene.Name);
  std::vector<std::optional<double>> ms;
  for (const Run& run : plan)
  {
    ms.emplace_back();
    if (run.Motion.Mode == Mode::First)
    {
      BenchStage stage(scene, { run });
      ms.back() = stage.Draw(stage.GetEntries().front()).Passed;
    }
  }
  return ms;
}

using MapPointer = std::shared_ptr<const DirectionMap>;

std::vector<Record> MeasureScene(
  const BenchScene& scene, const BenchOptions& o, const MapPointer& map)
{
  PlanRequest request{ o.Size, o.Quick, o.Methods, o.Motion, o.Projection, o.Tolerance, map,
    o.Samples };
  const std::vector<Run> plan =
    o.Table1 ? MakeTable1(request, scene.Camera) : MakePlan(request, scene.Camera);
  const std::vector<std::optional<double>> first = TimeFirstFrames(scene, plan);
  BenchStage stage(scene, plan);
  std::vector<Record> records = MakeRecords(stage);
  ErrorMeasure measure(stage);
  // the ray caster's picture is of the view that stands
  const bool compared = !o.Table1 && o.Motion.Mode == Mode::Still;
  if (compared)
  {
    FitFloors(stage, measure, records);
  }
  const double round = WarmUp(stage, records);
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    records[i].FirstMilliseconds = records[i].Note.empty() ? first[i] : std::nullopt;
  }
  const double budget = 1000 * (o.Quick ? QuickBudget : FullBudget);
  const int fitting = int(std::clamp(budget / round, double(LeastFrames), double(MostFrames)));
  Time(stage, records, o.Frames > 0 ? o.Frames : fitting);
  CountFragments(stage, records);
  if (compared)
  {
    MeasureErrors(stage, measure, records);
  }
  return records;
}

std::vector<std::string> ScenesOf(const BenchOptions& o)
{
  if (!o.Scenes.empty())
  {
    return o.Scenes;
  }
  return o.Table1 ? std::vector<std::string>{ "cornell", "atrium" } : BenchSceneNames();
}
}

Json RunBenchmark(const BenchOptions& o)
{
  if (o.Motion.Mode == Mode::First)
  {
    CompileAnew();
  }
  const widefov::DisplayConnection display;
  Json json = { { "environment", DescribeEnvironment() }, { "records", Json::array() } };
  Json skipped = Json::array();
  const MapPointer map = o.Sampled ? MakeDirectionMap(o.Projection, o.Size) : nullptr;
  std::vector<Record> records;
  for (const std::string& name : ScenesOf(o))
  {
    BenchScene scene;
    try
    {
      scene = LoadBenchScene(name, o.Data);
    }
    catch (const widefov::Failure& failure)
    {
      if (!o.Scenes.empty())
      {
        throw;
      }
      widefov::Say("warning: the scene " + name + " is left out: " + failure.what());
      skipped.push_back({ { "scene", name }, { "reason", failure.what() } });
      continue;
    }
    const std::vector<Record> measured = MeasureScene(scene, o, map);
    records.insert(records.end(), measured.begin(), measured.end());
  }
  for (const Record& record : records)
  {
    json["records"].push_back(ToJson(record));
  }
  json["summary"] = o.Table1 ? SummarizeTable1(records) : Summarize(records);
  json["skipped"] = skipped;
  return json;
}
}
}
