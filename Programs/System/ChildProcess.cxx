// SPDX-License-Identifier: BSD-3-Clause
#include "ChildProcess.h"

#include "Text/Messages.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ; // NOLINT: POSIX names it so

namespace widefov
{
namespace
{
std::string ReadAll(std::FILE* file)
{
  std::string text;
  std::rewind(file);
  char part[4096];
  for (std::size_t n = 0; (n = std::fread(part, 1, sizeof part, file)) > 0;)
  {
    text.append(part, n);
  }
  return text;
}

std::FILE* NewFile()
{
  std::FILE* const file = std::tmpfile();
  if (file == nullptr)
  {
    Fail(std::string("no temporary file can be made: ") + std::strerror(errno) +
      "; make room, or set TMPDIR to a folder that can be written to");
  }
  fcntl(fileno(file), F_SETFD, FD_CLOEXEC);
  return file;
}

// What a child is not to inherit: signals that are ignored here.
void SetSignals(posix_spawnattr_t* attributes)
{
  sigset_t all;
  sigset_t none;
  sigemptyset(&none);
  sigemptyset(&all);
  sigaddset(&all, SIGPIPE);
  sigaddset(&all, SIGINT);
  sigaddset(&all, SIGTERM);
  sigaddset(&all, SIGHUP);
  posix_spawnattr_setsigdefault(attributes, &all);
  posix_spawnattr_setsigmask(attributes, &none);
  posix_spawnattr_setpgroup(attributes, 0);
  posix_spawnattr_setflags(
    attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
}
}

ChildProcess::ChildProcess(const std::vector<std::string>& command)
  : OutputFile(NewFile())
  , ErrorFile(NewFile())
{
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
  {
    Fail(command[0] + " cannot be started: " + std::strerror(errno) + "; close other programs");
  }
  this->Input = ends[1];
  this->Start(command, ends[0]);
}

void ChildProcess::Start(const std::vector<std::string>& command, int input)
{
  std::vector<char*> words;
  for (const std::string& word : command)
  {
    words.push_back(const_cast<char*>(word.c_str())); // posix_spawn changes none
  }
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(this->OutputFile.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(this->ErrorFile.get()), STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  SetSignals(&attributes);
  const int error =
    posix_spawnp(&this->Process, words[0], &actions, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(input);
  if (error != 0)
  {
    this->Process = -1;
    close(this->Input);
    this->Input = -1;
    Fail("the program " + command[0] + " cannot be started: " + std::strerror(error) +
      "; install it (Debian: apt install " + command[0] + ")");
  }
}

ChildProcess::~ChildProcess()
{
  if (this->Input >= 0)
  {
    close(this->Input);
  }
  if (this->Process > 0)
  {
    kill(this->Process, SIGKILL);
    this->Wait();
  }
}

bool ChildProcess::Write(const void* bytes, std::size_t count)
{
  const auto* at = static_cast<const char*>(bytes);
  while (count > 0)
  {
    const ssize_t n = write(this->Input, at, count);
    if (n < 0 && errno == EINTR)
    {
      continue;
    }
    if (n <= 0)
    {
      return false;
    }
    at += n;
    count -= static_cast<std::size_t>(n);
  }
  return true;
}

int ChildProcess::Wait()
{
  int status = -1;
  while (waitpid(this->Process, &status, 0) < 0 && errno == EINTR)
  {
    // a signal that is somebody else's
  }
  this->Process = -1;
  return status;
}

bool ChildProcess::Finish()
{
  close(this->Input);
  this->Input = -1;
  const int status = this->Wait();
  this->Output = ReadAll(this->OutputFile.get());
  this->Errors = ReadAll(this->ErrorFile.get());
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string ChildProcess::GetComplaint() const
{
  const std::size_t end = this->Errors.find_last_not_of("\r\n ");
  if (end == std::string::npos)
  {
    return "it said nothing";
  }
  const std::size_t begin = this->Errors.find_last_of("\r\n", end);
  return OneLine(this->Errors.substr(begin + 1, end - begin)); // npos + 1 is 0
}

std::unique_ptr<ChildProcess> RunToEnd(const std::vector<std::string>& command, bool& well)
{
  auto process = std::make_unique<ChildProcess>(command);
  well = process->Finish();
  return process;
}
}
