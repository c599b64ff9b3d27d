// SPDX-License-Identifier: BSD-3-Clause
// Options from elsewhere than the command line: what it does not give.
#ifndef WideFoVSettings_h
#define WideFoVSettings_h

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace widefov
{
// The value of an option.
struct Setting
{
  std::string Option; // with its hyphens; "FILE" for data
  std::string Value;  // of a flag: what means yes or no, or nothing, which is yes
  std::string Where;  // begins the message about a value that is wrong; may be empty
};

// Sets, after the command line was parsed, the options that were not given so far, nor one that
// they exclude. Throws a Failure with ExitUsage for one that the program does not have.
void ApplySettings(CLI::App& app, const std::vector<Setting>& settings);

// The settings of a file: a line each, NAME = VALUE or the name of a flag; # begins a remark.
// Throws a Failure with ExitFailed where it cannot be read, with ExitUsage for a line that says
// nothing.
std::vector<Setting> ReadSettings(const std::string& path);
}

#endif
