// SPDX-License-Identifier: BSD-3-Clause
// Numbered frames that are there already: which film they are of, and whether they are whole.
#ifndef WideFoVFrameOwner_h
#define WideFoVFrameOwner_h

#include <string>

namespace widefov
{
enum class FrameState
{
  Missing,
  Cut, // a file, but no whole picture
  Whole
};

// Reads the end of the file; of formats without a mark there, all of it.
FrameState StateOfFrame(const std::string& path);

// Throws a Failure with ExitFailed, which names what differs, unless the frame is of the film of
// these options (FilmOptions::Command).
void CheckOwner(const std::string& path, const std::string& command);
}

#endif
