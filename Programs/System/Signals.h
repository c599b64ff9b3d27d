// SPDX-License-Identifier: BSD-3-Clause
// INT, TERM and HUP: they end a program in good order.
#ifndef WideFoVSignals_h
#define WideFoVSignals_h

#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

namespace widefov
{
// While it lives, one of these signals ends the program as it does everywhere, but for what
// `cleanUp` does before, in a thread of its own. Those that were ignored stay so. Made before any
// other thread, which would have the signal else; one at a time.
class SignalWatch
{
public:
  explicit SignalWatch(std::function<void()> cleanUp);
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

private:
  void Watch();

  std::function<void()> CleanUp;
  sigset_t Signals;
  std::atomic<bool> Ended{ false };
  std::thread Watcher;
};

// While one of these lives, the first signal is left to the work under way, which asks for it; the
// second one ends the program. One at a time.
class Interrupts
{
public:
  Interrupts();
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  // A signal came.
  static bool Came();
};
}

#endif
