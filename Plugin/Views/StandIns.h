// SPDX-License-Identifier: BSD-3-Clause
// Which props of a view are drawn by others, and when.
#ifndef WideFoVPluginStandIns_h
#define WideFoVPluginStandIns_h

#include <memory>
#include <vector>

class vtkRenderer;

namespace wfvplugin
{
class StandIn;

class StandIns
{
public:
  StandIns();
  ~StandIns();

  // Before the renderer gathers what is visible, where the camera is wide.
  void Begin(vtkRenderer* renderer);

  // After the frame: as it was.
  void End();

private:
  std::vector<std::unique_ptr<StandIn>> All;
  std::vector<StandIn*> Shown; // of this frame
};
}

#endif
