// SPDX-License-Identifier: BSD-3-Clause
#include "BenchOptions.h"

#include "BenchScenes.h"
#include "Messages.h"
#include "OptionGroup.h"
#include "Plan.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>

namespace wfv
{
namespace bench
{
namespace
{
// Of --quick and of the paper's table.
constexpr std::array<int, 2> SmallSize{ { 1024, 512 } };

void Declare(CLI::App& app, BenchOptions& o)
{
  widefov::OptionGroup group(app, "Options");
  group.Name("--output", "FILE.json", o.Output, "what was measured");
  group.Flag("--quick", o.Quick, "every scene at 1024x512, fewer parameters, few frames");
  group.Flag("--table1", o.Table1, "the paper's table 1 instead: cornell and atrium at 1024x512");
  group.Choices("--scenes", o.Scenes, AllSceneNames(), "scenes");
  group.Choices("--methods", o.Methods, MethodNames(), "methods");
  group.Choice("--projection", o.Projection, ProjectionNames(), {},
    "what the techniques draw, at its widest; the cubemap and the floor stay as they are");
  group.Flag("--as-direction-map", o.Sampled,
    "the directions of that projection, one a pixel, as a direction map in its stead");
  group.Number("--tolerance", "PX", o.Tolerance, { 0.001, 1e6 },
    "the only one of auto and tessellate, pixels; without it they have several");
  group.Size("--size", o.Size, "pixels; with --quick or --table1 1024x512");
  group.Number("--turn", "DEGREES", o.Turn, { -180, 180 },
    "before each frame every camera turns about its up axis; no errors and no floor then; degrees");
  group.Integer("--samples", o.Samples, 0, 64,
    "a pixel, of every window; what is compared with the ray caster has one");
  group.Integer("--frames", o.Frames, 1, 10000, "timed frames a run; 0: as many as fit the time");
  group.Name("--data", "FOLDER", o.Data, "where office.binary.vtk is");
  group.Flag("--version", o.Version, "print the version");
}

// The paper's table has its own.
void CheckTable1(const BenchOptions& o)
{
  if (o.Table1 && o.Projection != BenchOptions().Projection)
  {
    widefov::FailUsage("--projection and --table1 exclude each other; give one");
  }
  if (o.Table1 && o.Sampled)
  {
    widefov::FailUsage("--as-direction-map and --table1 exclude each other; give one");
  }
  if (o.Table1 && o.Samples != 0)
  {
    widefov::FailUsage("--samples and --table1 exclude each other; give one");
  }
  if (o.Table1 && o.Tolerance != 0)
  {
    widefov::FailUsage("--tolerance and --table1 exclude each other; give one");
  }
}

// What has no meaning while the cameras turn.
void CheckTurn(const BenchOptions& o)
{
  if (o.Turn == 0)
  {
    return;
  }
  if (o.Table1)
  {
    widefov::FailUsage("--turn and --table1 exclude each other; give one");
  }
  if (std::find(o.Methods.begin(), o.Methods.end(), "floor") != o.Methods.end())
  {
    widefov::FailUsage("--turn: the floor does not turn; leave floor out of --methods");
  }
}
}

std::optional<int> ParseBenchOptions(int argc, char** argv, BenchOptions& o)
{
  CLI::App app("Run time against error of wide projections, as JSON.", "widefov-bench");
  const std::array<int, 2> usual = o.Size;
  o.Data = WIDEFOV_DATA_FOLDER;
  Declare(app, o);
  if (const std::optional<int> done = widefov::ParseCommandLine(app, argc, argv))
  {
    return done;
  }
  if (o.Version)
  {
    std::cout << "widefov-bench " WIDEFOV_VERSION "\n" << std::flush;
    widefov::CheckStandardOutput();
    return widefov::ExitDone;
  }
  if (o.Output.empty())
  {
    widefov::FailUsage("nothing to write; give --output FILE.json");
  }
  if (o.Quick && o.Table1)
  {
    widefov::FailUsage("--quick and --table1 exclude each other; give one");
  }
  CheckTable1(o);
  CheckTurn(o);
  if (app.count("--size") == 0)
  {
    o.Size = o.Quick || o.Table1 ? SmallSize : usual;
  }
  return std::nullopt;
}
}
}
