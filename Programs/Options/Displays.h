// SPDX-License-Identifier: BSD-3-Clause
// Pictures that others know by name, as direction maps: a mirror ball, two fisheyes side by side,
// the faces of a cube.
#ifndef WideFoVDisplays_h
#define WideFoVDisplays_h

#include "Projections/DirectionMap.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace widefov
{
// One of them. Places are -1 to 1 over the picture, x to the right, y up; directions in view
// coordinates, of any length.
struct Display
{
  const char* Name;
  std::array<int, 2>
    Size;     // pixels, where none are asked for: as wide and high as one of its parts is
  bool Round; // circles stay circles in pictures of other shapes
  wfv::WfvRay (*Ray)(const wfv::vec2& place);
};

// All there are.
std::vector<std::string> DisplayNames();

// nullptr: there is none of that name.
const Display* FindDisplay(const std::string& name);

// The directions of a picture of this size.
std::shared_ptr<const wfv::DirectionMap> MakeDisplay(const Display& display, int width, int height);
}

#endif
