// SPDX-License-Identifier: BSD-3-Clause
// The command line of widefov-bench.
#ifndef WideFoVBenchOptions_h
#define WideFoVBenchOptions_h

#include "Motion.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace wfv
{
namespace bench
{
struct BenchOptions
{
  std::string Output;
  std::vector<std::string> Scenes;  // as asked for; empty: all
  std::vector<std::string> Methods; // empty: all
  std::array<int, 2> Size{ { 2048, 1024 } };
  bool Quick = false;
  bool Table1 = false;                        // the table of the paper instead
  std::string Projection = "equirectangular"; // of the techniques
  bool Sampled = false;                       // that as a direction map
  double Tolerance = 0;                       // of auto, pixels; 0: several
  int Samples = 0;                            // a pixel of the windows; 0: no multisampling
  bench::Motion Motion;                       // of the cameras
  int Frames = 0;   // timed frames a run; 0: as many as fit the time, at least three
  std::string Data; // folder of office.binary.vtk
  bool Version = false;
};

// Parses and checks. Throws a Failure with ExitUsage; returns an exit code where nothing
// is left to do.
std::optional<int> ParseBenchOptions(int argc, char** argv, BenchOptions& options);
}
}

#endif
