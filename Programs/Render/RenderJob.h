// SPDX-License-Identifier: BSD-3-Clause
// Draws a scene as the options say.
#ifndef WideFoVRenderJob_h
#define WideFoVRenderJob_h

#include "Options/Options.h"
#include "Pictures/ImageOutput.h"
#include "Pictures/RenderStats.h"
#include "Scenes/Scene.h"
#include "System/Display.h"
#include "System/OutputFiles.h"

#include <optional>
#include <vector>

namespace widefov
{
struct RenderResult
{
  std::vector<Picture> Colors;     // where a picture was asked for: one, or one of each eye
  std::vector<Picture> Tiled;      // the same, drawn in tiles for a web page
  std::optional<FloatPicture> Aov; // where channels were asked for
  RenderStats Stats;
};

// Opens a window and draws. Throws a Failure with ExitFailed: no display, OpenGL too old,
// a picture beyond its limits, an error of the renderer. A picture that is drawn in tiles goes to
// `files` at once, and is in the result for a web page alone.
RenderResult Render(const Scene& scene, const Options& options, OutputFiles& files);
}

#endif
