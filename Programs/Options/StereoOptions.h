// SPDX-License-Identifier: BSD-3-Clause
// The stereo options of the command line.
#ifndef WideFoVStereoOptions_h
#define WideFoVStereoOptions_h

#include "OptionGroup.h"
#include "Options.h"

namespace widefov
{
void DeclareStereo(CLI::App& app, Options& options);

// After the projection is known and before wfv::CheckOptions: sets the model. Throws a Failure
// with ExitUsage where an option is given that the model does not have.
void CompleteStereo(Options& options);

// After everything is known.
void CheckStereo(const Options& options);

// The same, of what is written to files.
void CheckFiles(const Options& options);

// Colours of light; a mask of vtkRenderWindow is one more than the index.
const std::vector<std::string>& AnaglyphColors();

// Can both eyes be drawn in tiles? Not where each has half of the window, or both go into one file
// apart, nor where pairs of rows become one and the topmost tiles have an odd number of them.
bool EyesFitTiles(const Options& options);
}

#endif
