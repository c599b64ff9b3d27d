// SPDX-License-Identifier: BSD-3-Clause
// Lights as constants of the shaders.
#ifndef WideFoVSteadyLights_h
#define WideFoVSteadyLights_h

#include "vtkWideFoVAbi.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Lights that stand still before the camera, headlights and camera lights without a position, mean
// the same to every frame. As uniforms each of their numbers would be fetched anew for every pixel
// on software rendering, also for those that are hidden later. Lights that have changed since the
// last frame stay uniforms until they are the same in two frames: a shader for each step of a fade
// would take longer.
class SteadyLights
{
public:
  // The lights of the renderer as they are now; true where the constants have changed.
  bool Look(vtkRenderer* renderer);

  // A line for each uniform of the stock text that is a constant now, "NAME VALUE"; may be empty.
  const std::string& GetConstants() const { return this->Constants; }

private:
  std::vector<double> Seen; // in the last frame
  std::vector<double> Now;
  bool Looked = false;  // there was one
  bool Current = false; // the constants are those of Seen
  std::string Constants;
};
}

#endif
