// SPDX-License-Identifier: BSD-3-Clause
// What a shell needs to complete the command line.
#ifndef WideFoVCompletion_h
#define WideFoVCompletion_h

#include <string>

namespace CLI
{
class App;
}

namespace widefov
{
// A script for bash: options, the names that an option takes, files for the others.
std::string BashCompletion(const CLI::App& app);
}

#endif
