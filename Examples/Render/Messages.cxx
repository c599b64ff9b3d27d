// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include <cctype>
#include <cstdio>
#include <fcntl.h>
#include <iostream>
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
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  const std::string line = ProgramName() + ": " + OneLine(message) + "\n";
  std::size_t done = 0;
  while (done < line.size())
  {
    const ssize_t n = write(UserErrorDescriptor(), line.data() + done, line.size() - done);
    if (n <= 0)
    {
      return; // nobody listens: there is nowhere left to say so
    }
    done += static_cast<std::size_t>(n);
  }
}

void CheckStandardOutput()
{
  std::cout.flush();
  if (!std::cout)
  {
    Fail("standard output cannot be written; check where it goes");
  }
}

std::string Text(double value)
{
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), "%.10g", value);
  return buffer;
}

QuietStandardError::QuietStandardError()
{
  std::fflush(stderr);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const int saved = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (nowhere >= 0 && saved >= 0)
  {
    dup2(nowhere, STDERR_FILENO);
    QuietedDescriptor = saved;
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
  if (QuietedDescriptor >= 0)
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
