// SPDX-License-Identifier: BSD-3-Clause
// Colours on the command line.
#ifndef WideFoVColorValue_h
#define WideFoVColorValue_h

#include "Scenes/Look.h"

#include <string>

namespace widefov
{
// Red, green and blue, 0 to 1, of three numbers with commas, a name of CSS or of VTK in any case,
// or #rrggbb. Throws a Failure with ExitUsage that names the option.
Vector3 ParseColor(const std::string& option, const std::string& value);
}

#endif
