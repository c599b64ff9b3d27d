// SPDX-License-Identifier: BSD-3-Clause
#include "Signals.h"

namespace widefov
{
namespace
{
constexpr int Ends[] = { SIGINT, SIGTERM, SIGHUP };

enum class Work
{
  NotAsked, // the first signal ends the program
  Asked,
  Told
};

std::atomic<Work> Asking{ Work::NotAsked };

// Those that are not ignored: nohup wants it so.
sigset_t Watched()
{
  sigset_t set;
  sigemptyset(&set);
  for (const int number : Ends)
  {
    struct sigaction action = {};
    if (sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
    {
      sigaddset(&set, number);
    }
  }
  return set;
}
}

SignalWatch::SignalWatch(std::function<void()> cleanUp)
  : CleanUp(std::move(cleanUp))
  , Signals(Watched())
{
  pthread_sigmask(SIG_BLOCK, &this->Signals, nullptr);
  // the thread has it blocked from the start: it may be woken before it has run
  sigset_t wakes;
  sigset_t before;
  sigemptyset(&wakes);
  sigaddset(&wakes, SIGUSR1);
  pthread_sigmask(SIG_BLOCK, &wakes, &before);
  this->Watcher = std::thread([this] { this->Watch(); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

SignalWatch::~SignalWatch()
{
  this->Ended = true;
  // blocked whether it is watched or not: it wakes the thread and nobody else
  pthread_kill(this->Watcher.native_handle(), SIGUSR1);
  this->Watcher.join();
  pthread_sigmask(SIG_UNBLOCK, &this->Signals, nullptr);
}

void SignalWatch::Watch()
{
  sigset_t set = this->Signals;
  sigaddset(&set, SIGUSR1);
  while (!this->Ended)
  {
    int number = 0;
    if (sigwait(&set, &number) != 0 || number == SIGUSR1)
    {
      continue;
    }
    Work asked = Work::Asked;
    if (Asking.compare_exchange_strong(asked, Work::Told))
    {
      continue;
    }
    this->CleanUp();
    std::signal(number, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &this->Signals, nullptr);
    std::raise(number);
  }
}

Interrupts::Interrupts()
{
  Asking = Work::Asked;
}

Interrupts::~Interrupts()
{
  Asking = Work::NotAsked;
}

bool Interrupts::Came()
{
  return Asking == Work::Told;
}
}
