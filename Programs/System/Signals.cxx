// SPDX-License-Identifier: BSD-3-Clause
#include "Signals.h"

namespace widefov
{
namespace
{
constexpr int Ends[] = { SIGINT, SIGTERM, SIGHUP };

// Blocked in the watching thread alone, which it ends.
constexpr int Wake = SIGUSR1;

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
  // the thread begins with what is blocked here
  sigset_t wake;
  sigemptyset(&wake);
  sigaddset(&wake, Wake);
  sigset_t before;
  pthread_sigmask(SIG_BLOCK, &wake, &before);
  pthread_sigmask(SIG_BLOCK, &this->Signals, nullptr);
  this->Watcher = std::thread([this] { this->Watch(); });
  if (sigismember(&before, Wake) == 0)
  {
    pthread_sigmask(SIG_UNBLOCK, &wake, nullptr);
  }
}

SignalWatch::~SignalWatch()
{
  this->Ended = true;
  pthread_kill(this->Watcher.native_handle(), Wake);
  this->Watcher.join();
  pthread_sigmask(SIG_UNBLOCK, &this->Signals, nullptr);
}

void SignalWatch::Watch()
{
  sigset_t set = this->Signals;
  sigaddset(&set, Wake);
  while (!this->Ended)
  {
    int number = 0;
    if (sigwait(&set, &number) != 0 || number == Wake)
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
