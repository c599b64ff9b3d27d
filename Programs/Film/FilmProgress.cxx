// SPDX-License-Identifier: BSD-3-Clause
#include "FilmProgress.h"

#include "Text/Messages.h"

#include <cmath>
#include <unistd.h>

namespace widefov
{
namespace
{
constexpr std::chrono::milliseconds OnTerminal{ 500 };
constexpr std::chrono::seconds FirstAfter{ 2 };
constexpr std::chrono::seconds AgainAfter{ 10 };

const char* const ClearLine = "\r\033[K";

void WriteRaw(const std::string& text)
{
  const ssize_t ignored = write(UserErrorDescriptor(), text.data(), text.size());
  static_cast<void>(ignored); // there is nobody to tell
}

// 75: 1:15
std::string Duration(double seconds)
{
  const long all = std::lround(seconds);
  const auto two = [](long n) { return (n < 10 ? "0" : "") + std::to_string(n); };
  return all < 60 ? std::to_string(all) + " s"
                  : (all < 3600 ? std::to_string(all / 60)
                                : std::to_string(all / 3600) + ":" + two(all / 60 % 60)) +
      ":" + two(all % 60);
}

std::string Size(long long bytes)
{
  const double megabytes = static_cast<double>(bytes) / 1e6;
  if (megabytes < 0.1)
  {
    return bytes > 0 ? ", " + Text(std::ceil(1000 * megabytes)) + " kB" : "";
  }
  return ", " + Text(megabytes < 100 ? std::round(10 * megabytes) / 10 : std::round(megabytes)) +
    " MB";
}
}

FilmProgress::FilmProgress(int total, int done, bool quiet)
  : Total(total)
  , First(done)
  , Quiet(quiet)
  , Terminal(isatty(UserErrorDescriptor()) != 0)
  , Next(Start + FirstAfter)
{
}

FilmProgress::~FilmProgress()
{
  if (this->Shown)
  {
    WriteRaw(ClearLine);
  }
}

std::string FilmProgress::TextOf(int done, long long bytes) const
{
  const std::chrono::duration<double> gone = Clock::now() - this->Start;
  const int drawn = done - this->First;
  const std::string left = drawn > 0
    ? ", " + Duration(gone.count() / drawn * (this->Total - done)) + " left"
    : std::string();
  const std::string number = done == 0 ? "the first frame" : "frame " + std::to_string(done);
  return number + " of " + std::to_string(this->Total) + left + Size(bytes);
}

void FilmProgress::Update(int done, long long bytes)
{
  if (this->Quiet || Clock::now() < this->Next)
  {
    return;
  }
  if (this->Terminal)
  {
    WriteRaw(ClearLine + GetProgramName() + ": " + this->TextOf(done, bytes) + "\r");
    this->Shown = true;
    this->Next = Clock::now() + OnTerminal;
    return;
  }
  Say(this->TextOf(done, bytes));
  this->Next = Clock::now() + AgainAfter;
}
}
