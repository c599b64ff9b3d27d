// SPDX-License-Identifier: BSD-3-Clause
// Data that are read beside the window, which goes on meanwhile.
#ifndef WideFoVLoader_h
#define WideFoVLoader_h

#include "Options.h"
#include "Scene.h"

#include <chrono>
#include <memory>
#include <string>

namespace widefov
{
// True where reading what the options name takes longer than people notice: large files.
bool TakesLong(const Options& options);

// What is read, for people.
std::string NameOf(const Options& options);

// Reads them, and with `fits` sets the distance between two eyes for them (FitEyes). Throws what
// LoadScene throws, and what is wrong with the place that they are to be looked at from.
Scene LoadFitted(Options& options, bool fits);

// Does that in a thread of its own. Nothing else may use VTK meanwhile: its messages are of one
// program. One that is not done when this object goes is left to itself, and must not outlive the
// program's data: end the program then.
class Loader
{
public:
  Loader(const Options& options, bool fits);

  // Waits so long at most. True where all is read, or failed.
  bool Wait(std::chrono::milliseconds time);

  // Once, after Wait was true. The options are set to what they are then. Throws what LoadFitted
  // threw.
  Scene Take(Options& options);

private:
  struct Work;
  std::shared_ptr<Work> Shared;
};
}

#endif
