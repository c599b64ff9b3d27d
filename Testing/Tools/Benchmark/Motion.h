// SPDX-License-Identifier: BSD-3-Clause
// What cameras do from frame to frame.
#ifndef WideFoVMotion_h
#define WideFoVMotion_h

#include "Pictures/CameraSetup.h"

#include <string>
#include <vector>

namespace wfv
{
namespace bench
{
enum class Mode
{
  Still, // the same picture again and again
  Turn,  // about the up axis, by the same angle before each frame
  Film,  // along a circle round the place of the view, and turning: an eye that moves on
  First  // to a place and a direction far from the last, where no frame was drawn before
};

struct Motion
{
  bench::Mode Mode = Mode::Still;
  double Degrees = 0; // of a turn, before each frame
};

// The words of the command line and of the records, in the order above.
std::vector<std::string> ModeNames();
std::string NameOf(Mode mode);
Mode ModeOf(const std::string& name); // one of those names

// Of the circle that eyes are on, as a share of the scene's diagonal.
constexpr double CircleShare = 0.05;

// Where the camera is for a frame, counted from 1, that started at `start`; always the same.
// `radius`: of the circle, in scene units.
widefov::Pose PoseAt(const widefov::Pose& start, double radius, const Motion& motion, int frame);
}
}

#endif
