// SPDX-License-Identifier: BSD-3-Clause
// Data that are read beside the window, which goes on meanwhile.
#ifndef WideFoVLoader_h
#define WideFoVLoader_h

#include "Options/Options.h"
#include "Pictures/FilmScenes.h"
#include "Scenes/Scene.h"

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <vector>

namespace widefov
{
// True where reading what the options name takes longer than people notice: large files.
bool TakesLong(const Options& options);

// The same of these files alone.
bool AreLarge(const std::vector<std::string>& files);

// What is read, for people.
std::string NameOf(const Options& options);

// What was read: a scene, and what reads the other steps of data that change with time.
struct Loaded
{
  Scene What;
  std::shared_ptr<FilmScenes> Steps; // none: they do not change
};

// Reads them, and with `fits` sets the distance between two eyes for them (FitEyes). Throws what
// LoadScene throws, and what is wrong with the place that they are to be looked at from.
Loaded LoadFitted(Options& options, bool fits);

// Does something in a thread of its own. Nothing else may use VTK meanwhile: its messages are of
// one program. What is not done when this object goes is left to itself, and must not outlive the
// program's data: end the program then.
class Loader
{
public:
  explicit Loader(std::function<void()> work);

  // Waits so long at most. True where it is done, or failed.
  bool Wait(std::chrono::milliseconds time);

  // Once, after Wait was true. Throws what it threw.
  void Finish() { this->Done.get(); }

private:
  std::future<void> Done;
};
}

#endif
