// SPDX-License-Identifier: BSD-3-Clause
#ifndef WideFoVDirectionMapFile_h
#define WideFoVDirectionMapFile_h

#include "Options/Options.h"

namespace widefov
{
// Reads the direction map that the options name, if any, into their view, and takes its size
// for the picture where none was asked for. Throws a Failure that says what is wrong with
// the file: it is missing or no OpenEXR image, lacks the channels X, Y, Z (or R, G, B), its
// size is not that of the picture, or its directions make no map.
void LoadDirectionMap(Options& options);
}

#endif
