// SPDX-License-Identifier: BSD-3-Clause
// What the viewer shows, as JSON lines for programs.
#ifndef WideFoVStateLog_h
#define WideFoVStateLog_h

#include "Options/Options.h"
#include "Scenes/Look.h"
#include "ViewerStage.h"

#include <array>
#include <cstdio>
#include <map>
#include <optional>
#include <string>

namespace widefov
{
struct ViewerState
{
  std::string Event; // frame, or press and release of a button, release of a key that flies
  long long Frame = 0;
  std::array<double, 2> Cursor{ { 0, 0 } }; // pixels of the picture, from the upper left
  std::string Screen;                       // that the cursor is in; empty: there are none
  std::optional<std::size_t> Pose;          // number of the head's, from 1
  bool Paused = false;
  struct TimeState
  {
    std::size_t Step = 1; // from 1
    std::size_t Steps = 1;
    double Time = 0;
    bool Plays = false;
  };
  std::optional<TimeState> Time;      // nothing where the data do not change
  std::optional<Vector3> Crosshair;   // world; nothing where it is not shown
  std::optional<Vector3> UnderCursor; // direction in the world, where the map has one
  double Yaw = 0;                     // degrees
  double Pitch = 0;
  bool Pending = false; // something is still to be drawn
  bool FullScreen = false;
  bool Help = false;
  bool Text = false;
  bool Numbers = false; // of the frame, with the text
  bool HasPanel = false;
  std::map<std::string, std::array<double, 4>> Widgets; // of the panel: left, top, right, bottom
  std::string Message;
  FrameCost Cost; // of the last frame
};

// The object of one line, with its line break.
std::string StateLine(const ViewerState& state, const Options& options);

class StateLog
{
public:
  // Empty: nothing is written. Throws a Failure with ExitFailed where the file cannot be
  // made.
  explicit StateLog(const std::string& path);
  ~StateLog();
  StateLog(const StateLog&) = delete;
  StateLog& operator=(const StateLog&) = delete;

  bool IsOpen() const { return this->File != nullptr; }

  // One whole line, at once. Throws a Failure with ExitFailed where the disk is full.
  void Write(const ViewerState& state, const Options& options);

private:
  std::string Path;
  std::FILE* File = nullptr;
};
}

#endif
