// SPDX-License-Identifier: BSD-3-Clause
// Draws a film.
#ifndef WideFoVFilmJob_h
#define WideFoVFilmJob_h

#include "Options/Options.h"
#include "Scenes/Scene.h"

namespace widefov
{
// Everything of a run with --film, after the options are checked. Throws a Failure; frames that
// were finished by then are kept, and its text says so. Returns the scene of the first time step.
Scene MakeFilm(Options& options);
}

#endif
