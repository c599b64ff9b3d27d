// SPDX-License-Identifier: BSD-3-Clause
// What every test of volumes asks: the picture is the march's.
#ifndef WideFoVVolumeCheck_h
#define WideFoVVolumeCheck_h

#include "VolumeScene.h"

namespace wfv
{
namespace test
{
// The wavelet from a place inside it, or from outside.
Shot ShotOf(const char* projection, bool inside);

// A file in the folder that the variable WIDEFOV_PICTURES names; empty without one.
std::string PictureName(const std::string& name);

// Draws, prints a row and asserts. The picture is written as name-projection.png to that folder.
VolumeError Check(VolumeScene& scene, const Shot& shot, const std::string& name);
}
}

#endif
