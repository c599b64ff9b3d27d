// SPDX-License-Identifier: BSD-3-Clause
// A list of places that one has looked from, which a film may fly through.
#ifndef WideFoVPoseList_h
#define WideFoVPoseList_h

#include "Scenes/Look.h"

#include <cstddef>
#include <string>

namespace widefov
{
// Adds a line to the file, which is made where there is none: eye, direction and up, nine numbers
// with blanks between. The number of its lines then. Throws a Failure with ExitFailed where it
// cannot be written; then it is as it was.
std::size_t AppendPose(
  const std::string& path, const Vector3& eye, const Vector3& direction, const Vector3& up);
}

#endif
