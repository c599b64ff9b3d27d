// SPDX-License-Identifier: BSD-3-Clause
// Texts that stand in the scene: flagpole labels and billboards.
#ifndef WideFoVPluginSceneTexts_h
#define WideFoVPluginSceneTexts_h

#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

class vtkFlagpoleLabel;
class vtkRenderer;

namespace wfvplugin
{
// Pole and flag are lines and a rectangle of the scene that turns to the eye. The rectangle is as
// large as the camera's angle of view makes it, which is that of a wide view while a frame is drawn
// alone: before, when the clip spheres are fitted, it would be too small.
class SceneTexts
{
public:
  // Between these two, labels have the bounds that they will be drawn in, where the renderer's
  // camera is wide.
  void BeginBounds(vtkRenderer* renderer);
  void EndBounds();

private:
  std::vector<std::pair<vtkSmartPointer<vtkFlagpoleLabel>, double>> Before;
};
}

#endif
