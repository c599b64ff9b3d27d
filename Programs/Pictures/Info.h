// SPDX-License-Identifier: BSD-3-Clause
// What files hold: --info.
#ifndef WideFoVInfo_h
#define WideFoVInfo_h

#include "Options/Options.h"

#include <string>

namespace widefov
{
// Empty where the options do not ask for it. Of each file kind, points, cells, triangles of its
// surface, bounds, arrays with their ranges, times; of a series all but the times is of its first
// step; as text, or with --json as one object {"files": [...]}. Throws a Failure with ExitFailed
// where one cannot be read.
std::string InfoText(const Options& options);
}

#endif
