// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <unistd.h>

namespace widefov
{
namespace
{
std::string& ProgramName()
{
  static std::string name = "widefov-render";
  return name;
}

int QuietedDescriptor = -1; // the user's standard error while it is redirected

std::atomic<Verbosity> Chosen{ Verbosity::Normal };

// 0, or the error.
int WriteWhole(int descriptor, const std::string& text)
{
  std::size_t done = 0;
  while (done < text.size())
  {
    const ssize_t n = write(descriptor, text.data() + done, text.size() - done);
    if (n < 0 && errno != EINTR)
    {
      return errno;
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(n, 0));
  }
  return 0;
}
}

void Fail(const std::string& message)
{
  throw Failure(ExitFailed, message);
}

void FailUsage(const std::string& message)
{
  throw Failure(ExitUsage, message);
}

void SetProgramName(const std::string& name)
{
  ProgramName() = name;
}

const std::string& GetProgramName()
{
  return ProgramName();
}

std::string OneLine(const std::string& text)
{
  std::string line;
  for (const char c : text)
  {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0 ||
      std::iscntrl(static_cast<unsigned char>(c)) != 0;
    if (!blank)
    {
      line += c;
    }
    else if (!line.empty() && line.back() != ' ')
    {
      line += ' ';
    }
  }
  while (!line.empty() && line.back() == ' ')
  {
    line.pop_back();
  }
  return line;
}

void Say(const std::string& message)
{
  if (Chosen != Verbosity::Quiet)
  {
    SayError(message);
  }
}

void SayError(const std::string& message)
{
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  // where nobody listens there is nowhere left to say so
  WriteWhole(UserErrorDescriptor(), ProgramName() + ": " + OneLine(message) + "\n");
}

void Tell(const std::string& message)
{
  if (Chosen == Verbosity::Verbose)
  {
    SayError(message);
  }
}

void Print(const std::string& text)
{
  const int error = WriteWhole(STDOUT_FILENO, text);
  if (error != 0 && error != EPIPE)
  {
    Fail("standard output cannot be written: " + std::string(std::strerror(error)) +
      "; check where it goes");
  }
}

void SetVerbosity(Verbosity verbosity)
{
  Chosen = verbosity;
}

std::string Text(double value)
{
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), "%.10g", value);
  return buffer;
}

QuietStandardError::QuietStandardError()
{
  if (QuietedDescriptor >= 0)
  {
    return;
  }
  std::fflush(stderr);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const int saved = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (nowhere >= 0 && saved >= 0)
  {
    dup2(nowhere, STDERR_FILENO);
    QuietedDescriptor = saved;
    this->Quiets = true;
  }
  else if (saved >= 0)
  {
    close(saved);
  }
  if (nowhere >= 0)
  {
    close(nowhere);
  }
}

QuietStandardError::~QuietStandardError()
{
  if (this->Quiets)
  {
    std::fflush(stderr);
    dup2(QuietedDescriptor, STDERR_FILENO);
    close(QuietedDescriptor);
    QuietedDescriptor = -1;
  }
}

int UserErrorDescriptor()
{
  return QuietedDescriptor >= 0 ? QuietedDescriptor : STDERR_FILENO;
}
}
