// SPDX-License-Identifier: BSD-3-Clause
// Draws a scene once a screen and once a pose of a head: one window, one set of buffers.
#ifndef WideFoVSightsJob_h
#define WideFoVSightsJob_h

#include "RenderJob.h"
#include "System/OutputFiles.h"

namespace widefov
{
// Every picture goes to the files as soon as it is drawn. A frame of the figures is all screens
// and eyes of one pose. Throws a Failure as Render does.
RenderStats RenderSights(const Scene& scene, const Options& options, OutputFiles& files);
}

#endif
