// SPDX-License-Identifier: BSD-3-Clause
// Draws a film.
#ifndef WideFoVFilmJob_h
#define WideFoVFilmJob_h

#include "Options/Options.h"

namespace widefov
{
// Everything of a run with --film, after the options are checked. Throws a Failure; frames that
// were finished by then are kept, and its text says so.
void MakeFilm(Options& options);
}

#endif
