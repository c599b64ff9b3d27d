// SPDX-License-Identifier: BSD-3-Clause
// What --color-by, --vectors and --streamlines may name.
#ifndef WideFoVArrayList_h
#define WideFoVArrayList_h

#include <string>

namespace widefov
{
// The arrays of a file, or of the first step of a series: where they are, their names, components,
// types and ranges; a line each, or JSON. Throws a Failure with ExitFailed where the file cannot be
// read.
std::string ArrayListOf(const std::string& path, bool json);
}

#endif
