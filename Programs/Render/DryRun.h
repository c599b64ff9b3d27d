// SPDX-License-Identifier: BSD-3-Clause
// What would be drawn.
#ifndef WideFoVDryRun_h
#define WideFoVDryRun_h

#include "Options/Options.h"
#include "Scenes/Scene.h"

namespace widefov
{
// Of complete options and their scene, for --dry-run: a line each, or JSON.
std::string DryRunText(const Options& options, const Scene& scene);
}

#endif
