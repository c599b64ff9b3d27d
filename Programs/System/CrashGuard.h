// SPDX-License-Identifier: BSD-3-Clause
// Damaged files can crash a reader that we do not own.
#ifndef WideFoVCrashGuard_h
#define WideFoVCrashGuard_h

#include <csignal>
#include <string>

namespace widefov
{
// While one of these lives, a crash (a wild pointer, an abort) ends the program with
// one line and ExitFailed instead of a signal. Not to be nested.
class CrashGuard
{
public:
  explicit CrashGuard(const std::string& message);
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;

private:
  static constexpr int Count = 5;
  struct sigaction Before[Count];
};
}

#endif
