// SPDX-License-Identifier: BSD-3-Clause
#include "BenchOptions.h"

#include "BenchScenes.h"
#include "Text/Messages.h"
#include "Options/OptionGroup.h"
#include "Plan.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace wfv
{
namespace bench
{
namespace
{
// Of --quick and of the paper's table.
constexpr std::array<int, 2> SmallSize{ { 1024, 512 } };

// Degrees before each frame, where none are given.
constexpr double UsualTurn = 1;

void Declare(CLI::App& app, BenchOptions& o, std::string& mode)
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
    "the only one of auto, pixels; without it there are several");
  group.Size("--size", o.Size, "pixels; with --quick or --table1 1024x512");
  group.Choice("--mode", mode, ModeNames(), {},
    "of the cameras: they stand, turn, go round in a circle, or jump to new places before each "
    "frame; no errors and no floor but of those that stand");
  group.Number("--turn", "DEGREES", o.Motion.Degrees, { -180, 180 },
    "--mode turn, by so much about the up axis; degrees, 1 where that mode is given alone");
  group.Integer("--samples", o.Samples, 0, 64,
    "a pixel, of every window but that of cubemap-ss, which stands beside several; what is "
    "compared with the ray caster has one");
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

bool Asks(const BenchOptions& o, const std::string& method)
{
  return std::find(o.Methods.begin(), o.Methods.end(), method) != o.Methods.end();
}

// --turn came first: alone, it says the mode too.
void SetMotion(bench::Motion& motion, const std::string& mode, bool modeGiven, bool turnGiven)
{
  motion.Mode = ModeOf(mode);
  if (turnGiven && !modeGiven && motion.Degrees != 0)
  {
    motion.Mode = Mode::Turn;
  }
  if (!turnGiven && motion.Mode == Mode::Turn)
  {
    motion.Degrees = UsualTurn;
  }
  if (turnGiven && modeGiven && motion.Mode != Mode::Turn)
  {
    widefov::FailUsage("--turn and --mode " + mode + " exclude each other; give one");
  }
  if (motion.Mode == Mode::Turn && motion.Degrees == 0)
  {
    widefov::FailUsage("--turn 0 does not turn; choose other degrees, or --mode still");
  }
}

// What has no meaning while the cameras move.
void CheckMotion(const BenchOptions& o)
{
  if (o.Motion.Mode == Mode::Still)
  {
    return;
  }
  const std::string option = "--mode " + NameOf(o.Motion.Mode);
  if (o.Table1)
  {
    widefov::FailUsage(option + " and --table1 exclude each other; give one");
  }
  if (Asks(o, "floor"))
  {
    widefov::FailUsage(option + ": the floor does not move; leave floor out of --methods");
  }
}

void CheckSmooth(const BenchOptions& o)
{
  if (Asks(o, SmoothCubeMap) && o.Samples <= 1)
  {
    widefov::FailUsage(std::string(SmoothCubeMap) +
      " stands beside several samples; give --samples N of 2 or more, or leave it out of "
      "--methods");
  }
}
}

std::optional<int> ParseBenchOptions(int argc, char** argv, BenchOptions& o)
{
  CLI::App app("Run time against error of wide projections, as JSON.", "widefov-bench");
  const std::array<int, 2> usual = o.Size;
  o.Data = WIDEFOV_DATA_FOLDER;
  std::string mode = NameOf(o.Motion.Mode);
  Declare(app, o, mode);
  if (const std::optional<int> done = widefov::ParseCommandLine(app, argc, argv))
  {
    return done;
  }
  if (o.Version)
  {
    widefov::Print("widefov-bench " WIDEFOV_VERSION "\n");
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
  SetMotion(o.Motion, mode, app.count("--mode") > 0, app.count("--turn") > 0);
  CheckMotion(o);
  CheckSmooth(o);
  if (app.count("--size") == 0)
  {
    o.Size = o.Quick || o.Table1 ? SmallSize : usual;
  }
  return std::nullopt;
}
}
}
