// SPDX-License-Identifier: BSD-3-Clause
// The flat screens of a wall or CAVE, as ParaView's configuration files (.pvx) describe them.
#ifndef WideFoVScreensFile_h
#define WideFoVScreensFile_h

#include "Stereo/Screen.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace widefov
{
struct NamedScreen
{
  std::string Name;                    // of its machine, fit for a file's name; no two are alike
  wfv::Screen Corners;                 // room coordinates, the file's unit
  std::array<int, 2> Size{ { 0, 0 } }; // pixels; 0 where the file says nothing of its window
};

struct ScreensFile
{
  std::vector<NamedScreen> Screens;
  std::optional<double> EyeSeparation; // the file's unit
};

// Of the machines of all processes that draw: elements Machine of pvx itself, or of a Process of
// the type server or renderserver. Throws a Failure with ExitFailed that names the file and what
// is wrong with it: missing, no XML, not pvx, without screens, corners that make no screen.
ScreensFile ReadScreens(const std::string& path);
}

#endif
