// SPDX-License-Identifier: BSD-3-Clause
#ifndef WideFoVScreenshot_h
#define WideFoVScreenshot_h

#include "Options/Options.h"
#include "Pictures/ImageOutput.h"

#include <string>

namespace widefov
{
// Writes the picture as a new .png file of this folder and returns its name. Throws a
// Failure with ExitFailed.
std::string WriteScreenshot(const Picture& picture, const Options& options);
}

#endif
