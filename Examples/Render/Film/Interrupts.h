// SPDX-License-Identifier: BSD-3-Clause
// INT, TERM and HUP, which end a program in good order.
#ifndef WideFoVInterrupts_h
#define WideFoVInterrupts_h

#include <csignal>

namespace widefov
{
// While one of these lives, the first of these signals is noted instead of ending the program; the
// second one ends it. Not to be nested.
class Interrupts
{
public:
  Interrupts();
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  // A signal came.
  static bool Came();

private:
  static constexpr int Count = 3;
  struct sigaction Before[Count];
};
}

#endif
