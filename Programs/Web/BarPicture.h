// SPDX-License-Identifier: BSD-3-Clause
// A picture of the bar of the colours alone.
#ifndef WideFoVBarPicture_h
#define WideFoVBarPicture_h

#include "Pictures/Picture.h"
#include "Scenes/Scene.h"

#include <optional>

namespace widefov
{
// Draws the bar of the scene's colour map on black. Empty if the scene has none. Throws a Failure
// with ExitFailed if there is no display.
std::optional<Picture> DrawBar(const Scene& scene);
}

#endif
