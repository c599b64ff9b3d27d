// SPDX-License-Identifier: BSD-3-Clause
// A scene with fewer triangles, for frames while the view moves.
#ifndef WideFoVCoarseScene_h
#define WideFoVCoarseScene_h

#include "Scenes/Scene.h"

namespace widefov
{
// The same props, in the same order, whose meshes have about so many triangles and lines in all;
// those of balls, sticks and outlines stay as they are. Empty surfaces show nothing.
Scene MakeCoarse(const Scene& scene, long long most);
}

#endif
