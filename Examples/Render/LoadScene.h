// SPDX-License-Identifier: BSD-3-Clause
// The scene that the options name.
#ifndef WideFoVLoadScene_h
#define WideFoVLoadScene_h

#include "Options.h"
#include "Scene.h"

namespace widefov
{
// Reads the files, or makes the built-in scene, and gives it the look that the options ask
// for. Throws a Failure with ExitFailed.
Scene LoadScene(const Options& options);
}

#endif
