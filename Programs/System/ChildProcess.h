// SPDX-License-Identifier: BSD-3-Clause
// Another program, fed through its standard input.
#ifndef WideFoVChildProcess_h
#define WideFoVChildProcess_h

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace widefov
{
// What the program prints is kept. It is in a process group of its own, so that what ends this
// program from the keyboard leaves it to finish its file.
class ChildProcess
{
public:
  // Throws a Failure with ExitFailed where the program cannot be started.
  explicit ChildProcess(const std::vector<std::string>& command);

  // Ends it where it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // False where it reads no more.
  bool Write(const void* bytes, std::size_t count);

  // Closes its input and waits; true where it ended well. What it printed is known from then on.
  bool Finish();

  const std::string& GetOutput() const { return this->Output; }
  const std::string& GetErrors() const { return this->Errors; }

  // The last line that it complained in.
  std::string GetComplaint() const;

private:
  struct CloseFile
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, CloseFile>;

  void Start(const std::vector<std::string>& command, int input);
  int Wait();

  pid_t Process = -1;
  int Input = -1;
  File OutputFile;
  File ErrorFile;
  std::string Output;
  std::string Errors;
};

// Runs it to its end. Throws a Failure with ExitFailed where it cannot be started.
std::unique_ptr<ChildProcess> RunToEnd(const std::vector<std::string>& command, bool& well);
}

#endif
