// SPDX-License-Identifier: BSD-3-Clause
// What projections are called, here and elsewhere.
#ifndef WideFoVProjectionNames_h
#define WideFoVProjectionNames_h

#include "NameMatch.h"

namespace widefov
{
// All of them, that of a direction map among them.
std::vector<std::string> ProjectionNames();

// What makers of lenses, panorama tools and ffmpeg's v360 call them.
const std::vector<Alias>& ProjectionAliases();
}

#endif
