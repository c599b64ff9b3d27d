// SPDX-License-Identifier: BSD-3-Clause
#include "CrashGuard.h"

#include "Text/Messages.h"

#include <unistd.h>

namespace widefov
{
namespace
{
constexpr int Crashes[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT };

// Ready before anything goes wrong: a signal handler must not allocate.
std::string LastWords;
int LastDescriptor = STDERR_FILENO;

void Handle(int)
{
  const ssize_t ignored = write(LastDescriptor, LastWords.data(), LastWords.size());
  static_cast<void>(ignored);
  _exit(ExitFailed);
}
}

CrashGuard::CrashGuard(const std::string& message)
{
  LastWords = GetProgramName() + ": " + OneLine(message) + "\n";
  LastDescriptor = UserErrorDescriptor();
  struct sigaction action = {};
  action.sa_handler = Handle;
  sigemptyset(&action.sa_mask);
  for (int i = 0; i < Count; i++)
  {
    sigaction(Crashes[i], &action, &this->Before[i]);
  }
}

CrashGuard::~CrashGuard()
{
  for (int i = 0; i < Count; i++)
  {
    sigaction(Crashes[i], &this->Before[i], nullptr);
  }
}
}
