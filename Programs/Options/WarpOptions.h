// SPDX-License-Identifier: BSD-3-Clause
// Pictures for projectors: --warp, --display.
#ifndef WideFoVWarpOptions_h
#define WideFoVWarpOptions_h

#include "OptionGroup.h"
#include "Options.h"

namespace widefov
{
void DeclareWarp(CLI::App& app, Options& options);

// Replaces a complete view by a direction map, and keeps the view as the picture that the
// calibration refers to. Throws a Failure with ExitUsage for options that do not go with
// projectors.
void TakeWarp(Options& options);
}

#endif
