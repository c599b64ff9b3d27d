// SPDX-License-Identifier: BSD-3-Clause
// Pictures for projectors: --warp, --display.
#ifndef WideFoVWarpOptions_h
#define WideFoVWarpOptions_h

#include "OptionGroup.h"
#include "Options.h"

namespace widefov
{
void DeclareWarp(CLI::App& app, Options& options);

// Of a complete view: keeps it as what the calibration refers to, and asks for a direction map
// instead. Throws a Failure with ExitUsage for options that do not go with projectors.
void TakeWarp(Options& options);
}

#endif
