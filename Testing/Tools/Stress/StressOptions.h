// SPDX-License-Identifier: BSD-3-Clause
// The command line of widefov-stress.
#ifndef WideFoVStressOptions_h
#define WideFoVStressOptions_h

#include "Check.h"

#include <optional>
#include <string>
#include <vector>

namespace wfv
{
namespace stress
{
struct StressOptions
{
  std::string Output;
  int Primitives = 1000000; // of each projection, at least
  int Seed = 1;
  std::vector<std::string> Projections; // all
  std::vector<std::string> Techniques{ "exact", "auto" };
  std::vector<std::string> Cases; // all
  double Tolerance = 0.02;        // of auto, pixels
  int Batch = -1;                 // this batch of each case alone
  bool Version = false;

  // Of the process that draws, which the program starts itself.
  bool Worker = false;
  int Skip = 0;     // so many batches of the plan are done already
  int AbortAt = -1; // crash at this batch: for the test of what happens then
};

// Parses and checks. Throws a Failure with ExitUsage; returns an exit code where nothing
// is left to do.
std::optional<int> ParseStressOptions(int argc, char** argv, StressOptions& options);

std::vector<Technique> TechniquesOf(const StressOptions& options);

// The batches of one projection, in the order in which they are drawn.
std::vector<BatchId> PlanOf(const StressOptions& options, const std::string& projection);
}
}

#endif
