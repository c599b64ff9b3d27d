// SPDX-License-Identifier: BSD-3-Clause
// Makes the pictures of projectors from calibrations and display files.
#ifndef WideFoVWarp_h
#define WideFoVWarp_h

#include "ImageOutput.h"
#include "Options/Options.h"

#include <vector>

namespace widefov
{
// Reads the calibration that the options name into their view, with its light. Throws a Failure
// with ExitFailed that says what is wrong with the file.
void LoadWarp(Options& options);

// Reads the display that the options name: a projector each, with its name, size, view and light,
// in the order of the file; of the one that is asked for alone. Throws as LoadWarp does.
std::vector<Options> LoadProjectors(const Options& options);

// The options with what another has of a projector.
Options WithProjector(const Options& options, const Options& projector);

// Darkens and lifts the rows of a picture, the first of which is `firstRow` of the whole one, from
// the top. Nothing without a light.
void ApplyLight(const Options& options, Picture& picture, int firstRow = 0);
}

#endif
