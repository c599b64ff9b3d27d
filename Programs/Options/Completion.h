// SPDX-License-Identifier: BSD-3-Clause
// What a shell needs to complete the command line.
#ifndef WideFoVCompletion_h
#define WideFoVCompletion_h

#include <map>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace widefov
{
// Values that a shell may complete an option to, by the name of the option; filled as options are
// declared.
std::map<std::string, std::vector<std::string>>& Completions();

// The long names of all options, with their hyphens.
std::vector<std::string> OptionNames(const CLI::App& app);

// A script for bash: options, the names that an option takes, files for the others.
std::string BashCompletion(const CLI::App& app);
}

#endif
