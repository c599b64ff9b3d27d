// SPDX-License-Identifier: BSD-3-Clause
// widefov-bench-scale: what many props, large meshes and narrow fields of view cost.
#include "System/Display.h"
#include "Environment.h"
#include "Memory.h"
#include "Text/Messages.h"
#include "Options/OptionGroup.h"
#include "System/OutputFiles.h"
#include "System/Program.h"
#include "ScaleScenes.h"
#include "ScaleStage.h"
#include "System/Spread.h"

#include <CLI/CLI.hpp>
#include <vtkWideFoVPolyDataMapper.h>

#include <algorithm>
#include <iostream>

namespace
{
using namespace wfv::scale;
using wfv::bench::Json;

struct ScaleOptions
{
  std::string Output;
  std::vector<std::string> Cases{ "props", "fields", "arrows", "memory" };
  int Props = 10000;
  int Triangles = 10000000;
  int Frames = 20;
  std::string Weigh; // for the processes that are weighed
  std::string Program;
};

vtkSmartPointer<vtkPolyDataMapper> MakeStock()
{
  return vtkSmartPointer<vtkOpenGLPolyDataMapper>::New();
}

vtkSmartPointer<vtkPolyDataMapper> MakeWide()
{
  return vtkSmartPointer<vtkWideFoVPolyDataMapper>::New();
}

// Medians, and the ratios of each run to the first one.
Json Times(const std::vector<ScaleRun>& runs)
{
  Json json;
  const double first = widefov::SpreadOf(runs[0].Milliseconds).Median;
  for (const ScaleRun& run : runs)
  {
    const widefov::Spread spread = widefov::SpreadOf(run.Milliseconds);
    json[run.Name] = {
      { "ms", { { "median", spread.Median }, { "min", spread.Least }, { "max", spread.Most } } },
      { "ratio", spread.Median / first }
    };
    if (run.Pass)
    {
      json[run.Name]["culled_props"] = run.Pass->GetNumberOfCulledProps();
    }
  }
  return json;
}

void Turn(const ScaleRun& run, int)
{
  if (run.Camera)
  {
    run.Camera->Yaw(0.1);
  }
  else
  {
    run.Renderer->GetActiveCamera()->Roll(0.1);
  }
}

void StandStill(const ScaleRun&, int) {}

// Many props, all of them seen by both.
Json RunProps(const ScaleOptions& o, bool moves)
{
  const vtkSmartPointer<vtkRenderWindow> window = MakeWindow(512, 256, moves);
  std::vector<ScaleRun> runs;
  runs.push_back(MakeStockRun("stock", MakeBalls(o.Props, MakeStock), 0));
  runs.push_back(MakeWideRun("pass", MakeBalls(o.Props, MakeStock), "equirectangular", 360, 180));
  runs.push_back(MakeWideRun("own", MakeBalls(o.Props, MakeWide), "equirectangular", 360, 180));
  DrawInTurn(window, runs, o.Frames, moves ? Turn : StandStill);
  return Times(runs);
}

// A vertex-bound scene all round: what a third of the field of view costs.
Json RunFields(const ScaleOptions& o)
{
  const vtkSmartPointer<vtkRenderWindow> window = MakeWindow(512, 256, true);
  const vtkSmartPointer<vtkPolyData> sphere = MakeSphere(std::min(o.Triangles, 1000000));
  Json json;
  const auto run = [&](const char* name, const Actors& all, const Actors& part) {
    std::vector<ScaleRun> runs;
    runs.push_back(MakeWideRun("360", all, "equirectangular", 360, 180));
    runs.push_back(MakeWideRun("120", part, "equirectangular", 120, 180));
    DrawInTurn(window, runs, o.Frames, Turn);
    json[name] = Times(runs);
  };
  run("mesh", { MakeSurface(sphere, MakeWide) }, { MakeSurface(sphere, MakeWide) });
  const int props = std::max(1, o.Props / 5);
  run("props", MakeBalls(props, MakeWide), MakeBalls(props, MakeWide));
  return json;
}

Json RunArrows(const ScaleOptions& o)
{
  const vtkSmartPointer<vtkRenderWindow> window = MakeWindow(512, 512, true);
  const int count = std::max(1, o.Props / 2);
  std::vector<ScaleRun> runs;
  runs.push_back(MakeStockRun("perspective", MakeArrowsAndLines(count, MakeStock), 90));
  runs.push_back(
    MakeWideRun("dome", MakeArrowsAndLines(count, MakeWide), "azimuthal-equidistant", 180, 180));
  runs.push_back(MakeWideRun(
    "dome-vertex", MakeArrowsAndLines(count, MakeWide), "azimuthal-equidistant", 180, 180));
  runs.back().Pass->SetTechniqueToVertex();
  DrawInTurn(window, runs, o.Frames, Turn);
  return Times(runs);
}

Json RunCases(const ScaleOptions& o)
{
  Json json{ { "environment", wfv::bench::DescribeEnvironment() } };
  for (const std::string& name : o.Cases)
  {
    if (name == "props")
    {
      json["props_moving"] = RunProps(o, true);
      json["props_still"] = RunProps(o, false);
    }
    else if (name == "fields")
    {
      json["fields"] = RunFields(o);
    }
    else if (name == "arrows")
    {
      json["arrows"] = RunArrows(o);
    }
    else
    {
      json["memory"] = CompareMemory(o.Program, o.Triangles);
    }
  }
  return json;
}

std::optional<int> Parse(int argc, char** argv, ScaleOptions& o)
{
  CLI::App app(
    "What many props, large meshes and narrow fields of view cost.", "widefov-bench-scale");
  widefov::OptionGroup group(app, "Options");
  group.Name("--output", "FILE.json", o.Output, "where the figures go");
  group.Choices("--cases", o.Cases, { "props", "fields", "arrows", "memory" }, "what is measured");
  group.Integer("--props", o.Props, 1, 1000000, "props");
  group.Integer("--triangles", o.Triangles, 4, 1000000000, "triangles of the large mesh");
  group.Integer("--frames", o.Frames, 1, 10000, "frames to time");
  group.Name("--weigh", "stock|wide", o.Weigh, "draw the large mesh, print what it takes, end");
  if (const std::optional<int> done = widefov::ParseCommandLine(app, argc, argv))
  {
    return done;
  }
  if (o.Output.empty() == o.Weigh.empty())
  {
    widefov::FailUsage("give --output FILE.json");
  }
  o.Program = argv[0];
  return std::nullopt;
}

int Run(int argc, char** argv)
{
  ScaleOptions o;
  if (const std::optional<int> done = Parse(argc, argv, o))
  {
    return *done;
  }
  const widefov::DisplayConnection display;
  if (!o.Weigh.empty())
  {
    std::cout << DrawAndWeigh(o.Weigh, o.Triangles).dump() << std::endl;
    return widefov::ExitDone;
  }
  widefov::CheckWritable(o.Output);
  const std::string text = RunCases(o).dump(2) + "\n";
  widefov::OutputFiles files;
  files.Write(o.Output, text.data(), text.size());
  files.Commit();
  return widefov::ExitDone;
}
}

int main(int argc, char** argv)
{
  return widefov::RunProgram("widefov-bench-scale", [=] { return Run(argc, argv); });
}
