// SPDX-License-Identifier: BSD-3-Clause
// Files that a file of data names, as .vtm and .gltf do.
#ifndef WideFoVNamedFiles_h
#define WideFoVNamedFiles_h

#include <string>
#include <vector>

namespace widefov
{
// The paths of all files that the file names; none for a format that names none.
std::vector<std::string> NamedFiles(const std::string& path);
}

#endif
