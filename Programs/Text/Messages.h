// SPDX-License-Identifier: BSD-3-Clause
// What the program says: one line a message, on standard error, beginning with the
// program's name.
#ifndef WideFoVMessages_h
#define WideFoVMessages_h

#include <stdexcept>
#include <string>

namespace widefov
{
// Exit codes of every program here.
constexpr int ExitDone = 0;
constexpr int ExitFailed = 1; // a file, the data, the display or the disk
constexpr int ExitUsage = 2;  // the command line

// Ends the program with one line and an exit code.
class Failure : public std::runtime_error
{
public:
  Failure(int exitCode, const std::string& message)
    : std::runtime_error(message)
    , ExitCode(exitCode)
  {
  }

  const int ExitCode;
};

// Throw a Failure: at run time, or because of the command line.
[[noreturn]] void Fail(const std::string& message);
[[noreturn]] void FailUsage(const std::string& message);

// The name that begins every line (default "widefov-render").
void SetProgramName(const std::string& name);
const std::string& GetProgramName();

// The text as one printable line: line breaks and runs of blanks become one blank.
std::string OneLine(const std::string& text);

// One line on standard error. Nothing is lost when standard error itself is
// redirected by QuietStandardError. Say: unless the program is to be quiet; SayError: always;
// Tell: where it is to be verbose.
void Say(const std::string& message);
void SayError(const std::string& message);
void Tell(const std::string& message);

// Writes to standard output. A reader that went away (`... | head`) has all it wants; throws a
// Failure with ExitFailed where the text did not get out for another reason.
void Print(const std::string& text);

// How much the program says: errors alone; warnings and progress too; what it does as well.
enum class Verbosity
{
  Quiet,
  Normal,
  Verbose
};
void SetVerbosity(Verbosity verbosity);

// Numbers as people write them: no trailing zeros.
std::string Text(double value);

// While one of these lives, what libraries print to standard error by themselves goes
// nowhere; Say still reaches the user. One inside another does nothing.
class QuietStandardError
{
public:
  QuietStandardError();
  ~QuietStandardError();
  QuietStandardError(const QuietStandardError&) = delete;
  QuietStandardError& operator=(const QuietStandardError&) = delete;

private:
  bool Quiets = false;
};

// The file descriptor that reaches the user, whatever QuietStandardError did.
int UserErrorDescriptor();
}

#endif
