// SPDX-License-Identifier: BSD-3-Clause
// A flight with the flow.
#ifndef WideFoVStreamFlight_h
#define WideFoVStreamFlight_h

#include "Pictures/CameraSetup.h"
#include "Scenes/Look.h"
#include "Scenes/Scene.h"

#include <optional>
#include <vector>

namespace widefov
{
// Poses along a stream line of the array that --vectors or --streamlines names: of the one that
// begins at the eye, or without one of the longest of many. They look ahead. Throws a Failure with
// ExitFailed where there is no such line.
std::vector<Pose> FlightAlong(
  const Scene& scene, const Look& look, const std::optional<Vector3>& eye, const Vector3& up);
}

#endif
