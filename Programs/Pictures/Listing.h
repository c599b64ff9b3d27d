// SPDX-License-Identifier: BSD-3-Clause
// What the program knows, for people and for machines.
#ifndef WideFoVListing_h
#define WideFoVListing_h

#include "Options/Options.h"
#include "RenderStats.h"
#include "Scenes/Scene.h"

#include <string>

namespace widefov
{
// --list-projections, --list-scenes, --version: the text for standard output, empty
// where none of them was asked for.
std::string ListingText(const Options& options);

// The contents of the --stats file.
std::string StatsText(const Options& options, const Scene& scene, const RenderStats& stats);
}

#endif
