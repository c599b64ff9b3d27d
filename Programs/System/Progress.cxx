// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "Text/Messages.h"

#include <chrono>
#include <cmath>

namespace widefov
{
namespace
{
constexpr std::chrono::seconds FirstAfter{ 2 };
constexpr std::chrono::seconds AgainAfter{ 10 };
}

Progress::Progress(const std::string& what)
  : What(what)
  , Watcher([this] { this->Watch(); })
{
}

Progress::~Progress()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Done = true;
  }
  this->Ended.notify_all();
  this->Watcher.join();
}

void Progress::Watch()
{
  const auto start = std::chrono::steady_clock::now();
  auto next = start + FirstAfter;
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (!this->Ended.wait_until(lock, next, [this] { return this->Done; }))
  {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(next - start).count();
    const double fraction = this->Fraction;
    const std::string share =
      fraction < 0 ? "" : std::to_string(std::lround(100 * fraction)) + " %, ";
    Say(this->What + " (" + share + std::to_string(seconds) + " s)");
    next += AgainAfter;
  }
}
}
