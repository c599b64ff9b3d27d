// SPDX-License-Identifier: BSD-3-Clause
// What the header of a PLY file promises.
#ifndef WideFoVPlyFile_h
#define WideFoVPlyFile_h

#include <string>

namespace widefov
{
// Whether the file holds what its header announces: of one that was cut off VTK 9.6 makes zeros
// and says nothing, and earlier ones crash. An empty string, or what is wrong.
std::string DamagedPly(const std::string& path);
}

#endif
