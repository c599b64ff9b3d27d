// SPDX-License-Identifier: BSD-3-Clause
// From data to what is drawn: glyphs, stream tubes, colours.
#ifndef WideFoVPipeline_h
#define WideFoVPipeline_h

#include "Look.h"
#include "Scene.h"

namespace widefov
{
// Applies the look to every prop: adds arrows and tubes, drops unusable cells, chooses the
// colours. Throws a Failure with ExitFailed where no prop has the
// array that is asked for, or where nothing is left to draw.
void ApplyLook(Scene& scene, const Look& look);
}

#endif
