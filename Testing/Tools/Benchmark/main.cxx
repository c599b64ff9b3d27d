// SPDX-License-Identifier: BSD-3-Clause
// widefov-bench: run time against error, every technique beside VTK's cubemap pass.
#include "Bench.h"
#include "Text/Messages.h"
#include "System/OutputFiles.h"
#include "System/Program.h"

namespace
{
int Run(int argc, char** argv)
{
  wfv::bench::BenchOptions options;
  if (const std::optional<int> done = wfv::bench::ParseBenchOptions(argc, argv, options))
  {
    return *done;
  }
  widefov::CheckWritable(options.Output);
  const std::string text = wfv::bench::RunBenchmark(options).dump(2) + "\n";
  widefov::OutputFiles files;
  files.Write(options.Output, text.data(), text.size());
  files.Commit();
  return widefov::ExitDone;
}
}

int main(int argc, char** argv)
{
  return widefov::RunProgram("widefov-bench", [=] { return Run(argc, argv); });
}
