// SPDX-License-Identifier: BSD-3-Clause
// What the window shows, as options and as the command that draws it.
#ifndef WideFoVCommandText_h
#define WideFoVCommandText_h

#include "Options/Options.h"
#include "Options/Settings.h"

#include <string>
#include <vector>

namespace widefov
{
// Options that both programs take: `now` is what is shown, `given` what the viewer was started
// with.
std::vector<Setting> SettingsOf(const Options& given, const Options& now);

// A command line of widefov-render with these, for a shell.
std::string CommandText(const Options& given, const Options& now);
}

#endif
