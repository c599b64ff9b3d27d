// SPDX-License-Identifier: BSD-3-Clause
// Options that a file or a preset gives where the command line does not.
#ifndef WideFoVPresetChoice_h
#define WideFoVPresetChoice_h

#include "Options.h"

namespace widefov
{
// Where the picture goes: a file has the preset's size and layout, a window keeps its own and takes
// the preset's proportions.
enum class Target
{
  File,
  Window
};

void DeclarePresets(CLI::App& app, Options& options);

// After the command line was parsed, before options are checked together: sets what --config and
// then --preset give beside it, and how much is said. Throws a Failure.
void CompleteFromPreset(CLI::App& app, Options& options, Target target);

// --list-presets, for people or as JSON.
std::string PresetList(bool json);
}

#endif
