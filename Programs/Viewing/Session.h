// SPDX-License-Identifier: BSD-3-Clause
// A file of options that shows again what the window showed.
#ifndef WideFoVSession_h
#define WideFoVSession_h

#include "Options/Settings.h"

#include <string>
#include <vector>

namespace widefov
{
// As --config reads it, with whole names of files, so that it may lie anywhere. Throws a Failure
// with ExitFailed for a value that no line can hold.
std::string SessionText(const std::vector<Setting>& settings);

// Writes that, whole or not at all. Throws a Failure with ExitFailed.
void WriteSession(const std::string& path, const std::vector<Setting>& settings);
}

#endif
