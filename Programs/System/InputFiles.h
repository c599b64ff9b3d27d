// SPDX-License-Identifier: BSD-3-Clause
// Files that the program reads: no output overwrites them.
#ifndef WideFoVInputFiles_h
#define WideFoVInputFiles_h

#include <string>
#include <vector>

namespace widefov
{
// Remembers a file that is read, by its name at this time.
void NoteInput(const std::string& path);

// All files that were noted, without links in their names.
std::vector<std::string> NotedInputs();

// The name of the file without links, existing or not.
std::string PlainName(const std::string& path);

// Throws a Failure with ExitFailed if the file was noted.
void CheckNoInput(const std::string& path);
}

#endif
