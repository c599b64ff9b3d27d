// SPDX-License-Identifier: BSD-3-Clause
// The options of rooms: flat screens and head poses.
#ifndef WideFoVRoomOptions_h
#define WideFoVRoomOptions_h

#include "FieldsOfView.h"
#include "OptionGroup.h"
#include "Options.h"

namespace widefov
{
// Scene units a unit of the room, and one over the least.
constexpr double LargestRoomScale = 1e9;

void DeclareRoom(CLI::App& app, Options& options);

// Before the view is completed: with screens the projection is perspective. Throws a Failure with
// ExitUsage for options that do not go with screens.
void CompleteRoom(Options& options, const FieldsOfView& fov);

// True if there are screens or poses.
bool HasRoom(const Options& options);
}

#endif
