// SPDX-License-Identifier: BSD-3-Clause
// What the stereo model is that the options name.
#ifndef WideFoVStereoChoice_h
#define WideFoVStereoChoice_h

#include "Options.h"

#include <array>

namespace widefov
{
// The stereo model that the options name.
const wfv::StereoModel& StereoOf(const Options& options);

// It shows each eye something else.
bool HasTwoEyes(const Options& options);

// Its eyes look at the cube of the map with its depth.
bool ShowsCube(const Options& options);

// Width and height of the picture in a file, with both eyes if the layout puts them into one.
std::array<int, 2> SizeOfFile(const Options& options);
}

#endif
