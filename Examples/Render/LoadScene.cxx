// SPDX-License-Identifier: BSD-3-Clause
#include "LoadScene.h"

#include "MessageCatcher.h"
#include "Messages.h"
#include "Pipeline.h"
#include "Progress.h"
#include "Readers.h"
#include "Scenes.h"

namespace widefov
{
Scene LoadScene(const Options& options)
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
  ApplyLook(scene, options.Look);
  const std::string error = MessageCatcher::TakeFirstError();
  if (!error.empty())
  {
    Fail("the data cannot be prepared: " + error + "; check them");
  }
  return scene;
}
}
