// SPDX-License-Identifier: BSD-3-Clause
// Times and compares every run.
#ifndef WideFoVBench_h
#define WideFoVBench_h

#include "BenchOptions.h"
#include "Record.h"

namespace wfv
{
namespace bench
{
// {"environment", "records", "summary"}; scenes whose data are not there are named under
// "skipped", unless they were asked for: then it throws a Failure with ExitFailed.
Json RunBenchmark(const BenchOptions& options);
}
}

#endif
