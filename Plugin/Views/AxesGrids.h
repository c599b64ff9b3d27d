// SPDX-License-Identifier: BSD-3-Clause
// The axes grids of a view, of the view itself and of data, for the time of a frame.
#ifndef WideFoVPluginAxesGrids_h
#define WideFoVPluginAxesGrids_h

#include <memory>
#include <vector>

class vtkRenderer;

namespace wfvplugin
{
class AxesGrid;

class AxesGrids
{
public:
  AxesGrids();
  ~AxesGrids();

  // Before the renderer gathers what is visible: those that draw right, in place of ParaView's,
  // where the camera is wide.
  void Begin(vtkRenderer* renderer);

  // After the frame: as it was.
  void End();

private:
  std::vector<std::unique_ptr<AxesGrid>> Grids;
  std::vector<AxesGrid*> Shown; // of this frame
};
}

#endif
