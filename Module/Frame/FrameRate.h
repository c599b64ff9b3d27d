// SPDX-License-Identifier: BSD-3-Clause
// By how much frames give way while they take longer than they may.
#ifndef WideFoVFrameRate_h
#define WideFoVFrameRate_h

#include <array>

namespace wfv
{
// Goes by what frames took, level by level. One is tried only where the one before it took too
// long, and given up where it saves next to nothing; in one motion none that took too long is tried
// again, so a picture does not flicker between two of them. What was found out in one motion is
// where the next begins. The very first frame of a level says nothing.
class FrameRate
{
public:
  static constexpr int Levels = 5; // 0: as a frame that stands

  // Which of them may be used.
  using Allowed = std::array<bool, Levels>;

  // A frame that may take its time.
  void Stand();

  // The level of an interactive frame. took, share: seconds of the frame before, and what it
  // may take.
  int Move(double took, double share, const Allowed& allowed);

private:
  void Adapt(double took, double share, const Allowed& allowed);
  int Step(int level, int by, const Allowed& allowed) const;

  bool Moves = false;
  int Level = 0;                     // of the frame before
  int From = 0;                      // that it was reached from, because that one took too long
  int Settled = 0;                   // of the last frame that moved
  int Least = 0;                     // in this motion: those below took too long,
  int Most = 0;                      // those above save nothing
  std::array<double, Levels> Took{}; // seconds of the last frame of each
};
}

#endif
