// SPDX-License-Identifier: BSD-3-Clause
#include "SightsJob.h"

#include "Pictures/PictureFiles.h"
#include "Pictures/RenderStats.h"
#include "Pictures/SightsStage.h"
#include "System/Display.h"
#include "System/Progress.h"
#include "Text/Messages.h"

#include <algorithm>
#include <chrono>

namespace widefov
{
namespace
{
void Time(SightsStage& stage, const std::vector<Options>& sights, int frames, RenderStats& stats)
{
  for (int i = 0; i < WarmUpFrames + std::max(1, frames); i++)
  {
    const auto start = std::chrono::steady_clock::now();
    for (const Options& sight : sights)
    {
      for (std::size_t type = 0; type < CountEyes(sight); type++)
      {
        stage.Draw(sight, type);
      }
    }
    stage.WaitForCompletion();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    if (i >= WarmUpFrames)
    {
      stats.Milliseconds.push_back(time.count());
    }
  }
}

void Write(const Options& sight, const std::vector<Picture>& pictures, OutputFiles& files)
{
  for (const std::string& output : sight.Outputs)
  {
    for (const auto& [name, bytes] : EncodeFiles(sight, output, pictures))
    {
      CheckWritable(name);
      files.Write(name, bytes.data(), bytes.size());
    }
  }
}
}

RenderStats RenderSights(const Scene& scene, const Options& o, OutputFiles& files)
{
  Sights all(o);
  std::vector<Options> sights = all.Next();
  const DisplayConnection display;
  SightsStage stage(scene, o);
  const QuietStandardError quiet;
  const Progress progress("drawing");
  RenderStats stats;
  stats.Gl = stage.GetStrings();
  stats.PropsTotal = static_cast<int>(scene.Props.size());
  if (o.Frames > 0 || !o.Stats.empty())
  {
    Time(stage, sights, o.Frames, stats);
  }
  for (; !sights.empty() && !o.Outputs.empty(); sights = all.Next())
  {
    for (const Options& sight : sights)
    {
      Write(sight, stage.Take(sight), files);
    }
  }
  return stats;
}
}
