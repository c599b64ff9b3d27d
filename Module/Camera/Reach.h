// SPDX-License-Identifier: BSD-3-Clause
#ifndef WideFoVReach_h
#define WideFoVReach_h

#include <algorithm>
#include <limits>

namespace wfv
{
// From where to where, seen from the eye, there is something to see; scene units.
struct Reach
{
  double Nearest = std::numeric_limits<double>::infinity();
  double Farthest = 0;    // 0: there is nothing
  bool IsBounded = false; // the view shows a frustum alone

  void Add(const Reach& other)
  {
    const bool first = this->Farthest == 0;
    this->Nearest = std::min(this->Nearest, other.Nearest);
    this->Farthest = std::max(this->Farthest, other.Farthest);
    this->IsBounded = (first || this->IsBounded) && other.IsBounded;
  }
};
}

#endif
