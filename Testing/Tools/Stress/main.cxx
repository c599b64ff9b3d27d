// SPDX-License-Identifier: BSD-3-Clause
// widefov-stress: random primitives that are hard to draw, against the ray caster.
#include "System/Display.h"
#include "Text/Messages.h"
#include "System/OutputFiles.h"
#include "System/Program.h"
#include "System/Progress.h"
#include "Report.h"
#include "Worker.h"

namespace
{
using namespace wfv::stress;

int Run(int argc, char** argv)
{
  StressOptions options;
  if (const std::optional<int> done = ParseStressOptions(argc, argv, options))
  {
    return *done;
  }
  if (options.Worker)
  {
    return RunWorker(options);
  }
  widefov::CheckWritable(options.Output);
  const widefov::DisplayConnection display;
  Report report(options);
  for (const std::string& projection : options.Projections)
  {
    widefov::Progress progress("stressing " + projection);
    const double all = double(PlanOf(options, projection).size());
    double done = 0;
    Supervise(options, projection, [&](const BatchId& id, const Json& result) {
      report.Add(id, result);
      progress.Update(++done / all);
    });
  }
  const std::string text = report.ToJson().dump(2) + "\n";
  widefov::OutputFiles files;
  files.Write(options.Output, text.data(), text.size());
  files.Commit();
  return widefov::ExitDone;
}
}

int main(int argc, char** argv)
{
  return widefov::RunProgram("widefov-stress", [=] { return Run(argc, argv); });
}
