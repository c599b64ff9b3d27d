// SPDX-License-Identifier: BSD-3-Clause
// Texts that stand in the scene: flagpole labels and billboards, for the time of a frame.
#ifndef WideFoVPluginSceneTexts_h
#define WideFoVPluginSceneTexts_h

#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

class vtkFlagpoleLabel;
class vtkRenderer;

namespace wfvplugin
{
// Pole and flag are lines and a rectangle of the scene that turns to the eye. But the rectangle is
// as large as VTK's angle of view makes it, which is not that of a wide camera: a thousand texels
// of its text are to be as high as the picture is, times its size.
class SceneTexts
{
public:
  // Where the renderer's camera is wide.
  void Begin(vtkRenderer* renderer);
  void End();

private:
  std::vector<std::pair<vtkSmartPointer<vtkFlagpoleLabel>, double>> Before;
};
}

#endif
