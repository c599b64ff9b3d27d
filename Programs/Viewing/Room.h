// SPDX-License-Identifier: BSD-3-Clause
// Whose head looks, and through which screens: what the files of screens and poses make of a view.
#ifndef WideFoVRoom_h
#define WideFoVRoom_h

#include "Options/Options.h"
#include "Pictures/Sights.h"
#include "PlayedHead.h"

#include <optional>
#include <string>
#include <vector>

namespace widefov
{
// The viewer moves the room through the scene; the head moves in the room.
class Room
{
public:
  // Throws a Failure with ExitFailed: files that are broken, an eye of any pose that is not
  // before a screen, times that cannot be played.
  // poseRate: head poses a second; 0: as their times say. poseOnce: the last pose stays.
  Room(const Options& options, double poseRate, bool poseOnce);

  // The options, and what the files add to them.
  const Options& GetGiven() const { return this->All.GetGiven(); }

  bool HasScreens() const { return this->All.HasScreens(); }

  // So many seconds pass. True where that brings another pose.
  bool Advance(double seconds);

  // Until then, seconds; nothing where there will be no other.
  std::optional<double> GetPause() const { return this->Played.GetPause(); }

  // Of the pose, from 1; nothing where there is one at most.
  std::optional<std::size_t> GetNumber() const;

  // What is seen with these options: a picture a screen, or one.
  std::vector<Options> See(const Options& options) const;

  // Why that cannot be drawn for every pose, or an empty text.
  std::string WhyNot(const Options& options) const;

private:
  Sights All;
  PlayedHead Played;
  HeadPose Head;
};

// The direction in which a place of a picture is seen (NDC), as Navigator has it: coordinates of
// the room, unit length. Nothing where the map has none.
std::optional<Vector3> RayOf(const Options& sight, double x, double y);

// The scene seen from the room grows (factor below 1) or shrinks, and the place `center` of it
// stays where it is in the room; `eye` is the room's place in the scene.
void ScaleRoom(Options& options, Vector3& eye, const Vector3& center, double factor);
}

#endif
