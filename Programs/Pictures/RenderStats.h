// SPDX-License-Identifier: BSD-3-Clause
// What a run found out.
#ifndef WideFoVRenderStats_h
#define WideFoVRenderStats_h

#include "vtkWideFoVAbi.h"

#include "System/Display.h"

#include <array>
#include <chrono>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkWideFoVPass;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// Frames before those that are timed: they make programs and buffers.
constexpr int WarmUpFrames = 2;

// Shader programs that were made, and the time that took. Unknown where stock VTK draws.
struct ShaderCost
{
  std::optional<double> FirstFrame; // milliseconds; of everything, also where stock VTK draws
  std::optional<int> Programs;
  std::optional<double> Milliseconds;
  std::optional<int> Later; // programs made after the warm-up frames
};

// Milliseconds that the parts of a run took, one after the other. Unknown: what it did not do, or
// stock VTK did.
struct PartTimes
{
  std::optional<double> Reading;  // of files, or making a scene
  std::optional<double> Clusters; // making them
  std::optional<double> Shaders;  // their text and programs
  std::optional<double> Drawing;  // all else, with opening a window; of tiles writing as well
  std::optional<double> Writing;  // of pictures: encoding, and into files
};

// From when it is made on.
class Stopwatch
{
public:
  double GetMilliseconds() const
  {
    const std::chrono::duration<double, std::milli> time =
      std::chrono::steady_clock::now() - this->Start;
    return time.count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

// A figure that is not known stays empty.
struct RenderStats
{
  GlStrings Gl;
  std::vector<double> Milliseconds; // one a frame
  int PropsTotal = 0;
  std::optional<int> PropsDrawn;
  std::optional<int> PropsCulled;
  std::optional<int> Clusters; // of triangles, that were classified
  std::optional<int> ClustersCulled;
  std::optional<long long> Triangles; // those of clusters
  std::optional<long long> TrianglesCulled;
  std::optional<long long> TrianglesProjected;
  std::optional<int> ChosenProps;      // anew in the last frame
  std::optional<int> ClassifiedMeshes; // anew in the last frame
  ShaderCost Shaders;
  PartTimes Parts;
  std::optional<int> PlainDraws;
  std::optional<int> PreClipDraws;
  std::optional<int> TessellateDraws;
  std::optional<int> ExactDraws;
  std::optional<std::array<int, 2>> Tiles; // of a picture in tiles: columns and rows
};

// What the pass counted in its last frame. others: props drawn that are none of the scene's.
void TakeCounts(vtkWideFoVPass* pass, int others, RenderStats& stats);

// What it made in all frames; programsAtFirst of them before frames were timed.
void TakeShaders(vtkWideFoVPass* pass, int programsAtFirst, RenderStats& stats);
}

#endif
