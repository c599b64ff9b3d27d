// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/FrameRate.h"

#include <algorithm>

namespace
{
// Fractions of its share: a frame that takes less leaves time for one a level better, of which the
// pixels are up to four times as many; and for one of any level.
constexpr double Spare = 0.5;
constexpr double MuchSpare = 0.2;

// What a level may take at the most of the time of the one before it, to be worth it.
constexpr double Worth = 0.9;
}

namespace wfv
{
void FrameRate::Stand()
{
  this->Moves = false;
  this->Level = 0;
}

// The next allowed level, within what this motion has left; the same one where there is none.
int FrameRate::Step(int level, int by, const Allowed& allowed) const
{
  for (int i = level + by; i >= this->Least && i <= this->Most; i += by)
  {
    if (allowed[i])
    {
      return i;
    }
  }
  return level;
}

void FrameRate::Adapt(double took, double share, const Allowed& allowed)
{
  const bool first = this->Took[this->Level] == 0;
  this->Took[this->Level] = took;
  if (first)
  {
    return; // some drivers finish programs when they are first drawn with
  }
  if (this->Level > this->From && took > Worth * this->Took[this->From])
  {
    this->Most = this->Level = this->From;
    return;
  }
  this->From = this->Level;
  if (took > share)
  {
    this->Least = std::min(this->Level + 1, this->Most);
    this->Level = this->Step(this->Level, 1, allowed);
  }
  else if (took < Spare * share)
  {
    this->Least = took < MuchSpare * share ? 0 : this->Least;
    this->Level = this->From = this->Step(this->Level, -1, allowed);
  }
}

int FrameRate::Move(double took, double share, const Allowed& allowed)
{
  if (this->Moves)
  {
    this->Adapt(took, share, allowed);
  }
  else
  {
    // what a frame took that stood says nothing of one that moves, but that it had time
    this->Moves = true;
    this->Least = 0;
    this->Most = Levels - 1;
    this->From = this->Level = took > share ? this->Settled : 0;
  }
  if (!allowed[this->Level])
  {
    const int up = this->Step(this->Level, 1, allowed);
    this->Level = this->From = up != this->Level ? up : this->Step(this->Level, -1, allowed);
  }
  this->Settled = this->Level;
  return this->Level;
}
}
