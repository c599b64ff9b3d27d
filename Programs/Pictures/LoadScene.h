// SPDX-License-Identifier: BSD-3-Clause
// The scene that the options name.
#ifndef WideFoVLoadScene_h
#define WideFoVLoadScene_h

#include "Options/Options.h"
#include "Scenes/Scene.h"

namespace widefov
{
// Reads files that do not change with time, or makes the built-in scene, and gives it the look that
// the options ask for. Throws a Failure with ExitFailed.
Scene LoadFixed(const Options& options);

// The look that the options ask for, as far as they can show it.
Look LookOf(const Options& options);

// Gives what was read that look. Throws a Failure with ExitFailed.
void Prepare(Scene& scene, const Look& look);

// For --verbose: what is to be drawn.
void TellOfScene(const Scene& scene);
}

#endif
