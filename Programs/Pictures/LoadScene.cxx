// SPDX-License-Identifier: BSD-3-Clause
#include "LoadScene.h"

#include "Scenes/Normals.h"
#include "Scenes/Pipeline.h"
#include "Scenes/Readers.h"
#include "Scenes/Scenes.h"
#include "System/MessageCatcher.h"
#include "System/Progress.h"
#include "Text/Messages.h"

namespace widefov
{
namespace
{
// Pixels: in smaller pictures nobody reads the numbers of a bar.
constexpr std::array<int, 2> RoomForBar{ { 200, 100 } };
}

Look LookOf(const Options& options)
{
  Look look = options.Look;
  // what stock VTK's pass and the float channels do not show
  look.UsualVolume =
    look.UsualVolume && options.Technique != Technique::CubeMap && options.Aov.empty();
  look.UsualBar =
    look.UsualBar && options.Size[0] >= RoomForBar[0] && options.Size[1] >= RoomForBar[1];
  return look;
}

void Prepare(Scene& scene, const Look& look)
{
  ApplyLook(scene, look);
  if (scene.FromFiles && look.Smooth)
  {
    SmoothNormals(scene);
  }
  const std::string error = MessageCatcher::TakeFirstError();
  if (!error.empty())
  {
    Fail("the data cannot be prepared: " + error + "; check them");
  }
}

Scene LoadFixed(const Options& options)
{
  Scene scene;
  if (!options.Scene.empty())
  {
    const Progress progress("making the scene " + options.Scene);
    scene = MakeScene(options.Scene);
  }
  else
  {
    scene = ReadScene(options.Files);
  }
  const Progress progress("preparing the data");
  Prepare(scene, LookOf(options));
  return scene;
}

void TellOfScene(const Scene& scene)
{
  const PrimitiveCount count = CountPrimitives(scene);
  std::string text = std::to_string(scene.Props.size()) + " props of " +
    std::to_string(count.Triangles) + " triangles, " + std::to_string(count.Lines) + " lines and " +
    std::to_string(count.Points) + " points";
  for (const SceneVolume& volume : scene.Volumes)
  {
    const int* const d = volume.Data->GetDimensions();
    text += ", and a volume of " + std::to_string(d[0]) + "x" + std::to_string(d[1]) + "x" +
      std::to_string(d[2]) + " points";
  }
  Tell(text);
}
}
