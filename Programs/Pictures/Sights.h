// SPDX-License-Identifier: BSD-3-Clause
// Where one run draws several pictures: one a screen of a room, one a pose of a head.
#ifndef WideFoVSights_h
#define WideFoVSights_h

#include "Options/Options.h"

#include <string>
#include <vector>

namespace widefov
{
// What an observer of a head and a file of screens make of the options: each picture's own. The
// observer is asked for one pose after the other; without one there is the head at the origin.
class Sights
{
public:
  // Reads the files that the options name. Throws a Failure with ExitFailed.
  explicit Sights(const Options& options);

  // The options, and what the files add to them: the distance between the eyes.
  const Options& GetGiven() const { return this->Given; }

  bool HasScreens() const { return !this->Screens.empty(); }

  // In the room's unit; one at its origin where no file was named.
  const std::vector<HeadPose>& GetPoses() const { return this->Poses; }

  // What somebody sees with these options, in the order of the screens: one picture a screen, or
  // one. Throws a Failure with ExitFailed where the volume cannot be behind its screen.
  std::vector<Options> See(const Options& options, const HeadPose& head) const;

  // Throws a Failure with ExitFailed where with these options an eye of any pose is not before a
  // screen.
  void Check(const Options& options) const;

  // The options of the pictures of one pose, in the order of the screens; none after the last.
  // Throws a Failure with ExitFailed where an eye is not before a screen.
  std::vector<Options> Next();

private:
  std::vector<Options> Through(const Options& options, const HeadPose& head) const;
  std::vector<Options> At(const Options& options, std::size_t pose) const;
  void CheckEyes(const Options& sight, std::size_t pose) const;
  void PlaceVolume(Options& sight) const;

  Options Given;
  std::vector<NamedScreen> Screens; // the room's unit; none: the display is on the head
  std::vector<HeadPose> Poses;
  std::size_t Taken = 0;
};

// Reads all that the options name of a room, and throws as Sights does.
void CheckSights(const Options& options);
}

#endif
