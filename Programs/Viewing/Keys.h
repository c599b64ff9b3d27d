// SPDX-License-Identifier: BSD-3-Clause
// Which key does what: one table for the viewer, its help and its documentation.
#ifndef WideFoVKeys_h
#define WideFoVKeys_h

#include <optional>
#include <string>
#include <vector>

namespace widefov
{
enum class Action
{
  NextProjection,
  PreviousProjection,
  NextTechnique,
  PreviousTechnique,
  ToggleDebugView,
  NextStereo,
  PreviousStereo,
  NextLayout,
  PreviousLayout,
  ZoomIn,
  ZoomOut,
  TurnLeft,
  TurnRight,
  TurnUp,
  TurnDown,
  Reset,
  Screenshot,
  AddPose,
  SaveSession,
  PrintCommand,
  ToggleCrosshair,
  NextPreview,
  TogglePlay, // time steps and head poses
  NextStep,   // of time
  PreviousStep,
  ToggleText,
  ToggleNumbers, // what a frame took
  ToggleHelp,
  TogglePanel,
  ToggleFullScreen,
  NextMonitor,
  Leave, // help, full screen, or the program
  Quit
};

// What a held key moves the eye along; components of -1, 0 or 1.
struct Motion
{
  int Right;
  int Up;
  int Ahead;
};

// `key` and `shift` as GLFW has them. Nothing where the key has no meaning.
std::optional<Action> ActionOf(int key, bool shift);
std::optional<Motion> MotionOf(int key);

// Does holding the key repeat the action?
bool Repeats(Action action);

// Lines of "keys   what they do".
std::string HelpText();
}

#endif
