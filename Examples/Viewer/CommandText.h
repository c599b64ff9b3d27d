// SPDX-License-Identifier: BSD-3-Clause
// The command that draws what the window shows.
#ifndef WideFoVCommandText_h
#define WideFoVCommandText_h

#include "Options.h"

#include <string>

namespace widefov
{
// A command line of widefov-render for a shell: `now` is what is shown, `given` what the
// viewer was started with.
std::string CommandText(const Options& given, const Options& now);
}

#endif
