// SPDX-License-Identifier: BSD-3-Clause
// The command line of widefov-viewer.
#ifndef WideFoVViewerOptions_h
#define WideFoVViewerOptions_h

#include "Options/Options.h"

#include <optional>
#include <string>

namespace widefov
{
struct ViewerOptions
{
  Options Picture; // what widefov-render takes, too
  Options Asked;   // the same, before what is left open of the view was chosen for the data
  bool FullScreen = false;
  int Monitor = 0;                     // from 1; 0: the primary one
  std::array<int, 2> Wall{ { 1, 1 } }; // columns and rows of windows
  bool NoText = false;
  bool Panel = false;
  std::string PoseList = "widefov-viewer-poses.txt"; // that a key adds to
  std::string Session;                               // read at the start; a key writes it
  double PoseRate = 0;                               // head poses a second; 0: as their times say
  bool PoseOnce = false;                             // the last pose stays
  double TimeRate = 10;                              // time steps a second, on average
  double UpdateRate = 20;        // frames a second that moving keeps to; 0: drawn as when still
  std::string Log;               // of states, one JSON object a line
  int Frames = 0;                // draw so many and end; 0: until the window is closed
  bool HasStandardInput = false; // among the files, under the name of a temporary one
};

// Parses and checks. Throws a Failure with ExitUsage; returns an exit code where nothing
// is left to do (--help was printed).
std::optional<int> ParseViewerOptions(int argc, char** argv, ViewerOptions& options);
}

#endif
