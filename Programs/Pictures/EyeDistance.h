// SPDX-License-Identifier: BSD-3-Clause
// How far apart two eyes should be, and whether they are.
#ifndef WideFoVEyeDistance_h
#define WideFoVEyeDistance_h

#include "Options/Options.h"
#include "Scenes/Scene.h"

namespace widefov
{
// For --ipd auto sets the distance between the eyes by the nearest thing that the picture shows.
// Of a given one says, in one line, that nobody will see depth by it, that it is uncomfortable, or
// that things are between the eyes. Does nothing for one eye, or before screens.
void FitEyes(Options& options, const Scene& scene);
}

#endif
