// SPDX-License-Identifier: BSD-3-Clause
// Draws a scene as the options say.
#ifndef WideFoVRenderJob_h
#define WideFoVRenderJob_h

#include "Display.h"
#include "ImageOutput.h"
#include "Options.h"
#include "OutputFiles.h"
#include "Scene.h"

#include <array>
#include <optional>
#include <vector>

namespace widefov
{
// What a run found out. A figure that is not known stays empty.
struct RenderStats
{
  GlStrings Gl;
  std::vector<double> Milliseconds; // one a frame
  int PropsTotal = 0;
  std::optional<int> PropsDrawn;
  std::optional<int> PropsCulled;
  std::optional<int> Clusters; // runs of triangles that were looked at
  std::optional<int> ClustersCulled;
  std::optional<int> PlainDraws;
  std::optional<int> PreClipDraws;
  std::optional<int> TessellateDraws;
  std::optional<int> ExactDraws;
  std::optional<std::array<int, 2>> Tiles; // of a picture in tiles: columns and rows
};

struct RenderResult
{
  std::vector<Picture> Colors;     // where a picture was asked for: one, or one of each eye
  std::optional<FloatPicture> Aov; // where channels were asked for
  RenderStats Stats;
};

// Opens a window and draws. Throws a Failure with ExitFailed: no display, OpenGL too old,
// a picture beyond its limits, an error of the renderer. A picture that is drawn in tiles goes to
// `files` at once and is not in the result.
RenderResult Render(const Scene& scene, const Options& options, OutputFiles& files);
}

#endif
