// SPDX-License-Identifier: BSD-3-Clause
// How the camera moves in a film.
#ifndef WideFoVFilmPath_h
#define WideFoVFilmPath_h

#include "Options/Options.h"
#include "Pictures/CameraSetup.h"
#include "Scenes/Scene.h"

#include <functional>
#include <vector>

namespace widefov
{
// Where the camera is when that share of the way, from 0 to 1, is over.
struct FilmPath
{
  std::function<Pose(double share)> At;
  bool Closed = false; // it ends where it begins, with the same speed
};

// What the options ask for, in the scene that the film begins with. Throws a Failure: a file of
// poses that cannot be used, no stream line.
FilmPath MakeFilmPath(const Scene& scene, const Options& options);

// Through all poses. The eye goes along a smooth curve, the view turns from one to the next along
// a great circle. A leg takes as long as it goes and turns, so that poses at one place give one
// angular speed. At least one pose.
FilmPath PathThrough(const std::vector<Pose>& poses);

// A pose a line: x y z of the eye, of the direction, and of up, which may be left out. Throws a
// Failure with ExitFailed that names the line.
std::vector<Pose> ReadPoses(const std::string& path, const Vector3& up);

// The share of the way that is over at a frame: of a closed way the last frame is the one before
// the first; any other ends with the last frame. Smooth: without a jerk at both ends, at one speed
// between them.
double ShareOfWay(int frame, int frames, bool closed, bool smooth);
}

#endif
