// SPDX-License-Identifier: BSD-3-Clause
// The process that draws: a crash ends it, and the program starts another.
#ifndef WideFoVStressWorker_h
#define WideFoVStressWorker_h

#include "Counts.h"
#include "StressOptions.h"

#include <functional>

namespace wfv
{
namespace stress
{
// Draws the batches of the first projection from options.Skip on. Prints a line of JSON
// before each technique and after each batch.
int RunWorker(const StressOptions& options);

// What the batches of one projection came to.
using Listener = std::function<void(const BatchId& id, const Json& result)>;

// Runs workers until every batch of the projection is done. The result of a batch is
// {"primitives", "techniques": {name: {"counts", "lines"}}}; where its process ended or
// did not answer, {"crash": why, "technique"}. Throws a Failure with ExitFailed where no worker can
// be started, or where it says so itself.
void Supervise(const StressOptions& options, const std::string& projection, const Listener& listen);
}
}

#endif
