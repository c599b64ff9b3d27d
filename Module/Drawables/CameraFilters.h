// SPDX-License-Identifier: BSD-3-Clause
// Filters that ask a camera how large, how deep or whether something is seen: what of it a wide
// view can answer, and a line where it cannot.
#ifndef WideFoVCameraFilters_h
#define WideFoVCameraFilters_h

#include "vtkWideFoVAbi.h"

#include "vtkWeakPointer.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDistanceToCamera;
class vtkMapper;
class vtkRenderer;
class vtkWideFoVCamera;
VTK_ABI_NAMESPACE_END

namespace wfv
{
struct Projection;

class CameraFilters
{
public:
  // Before the props of a frame are asked for their bounds: filters that do not know that the view
  // has changed become modified. True if there are any.
  bool Begin(vtkRenderer* renderer, vtkWideFoVCamera* camera);

  // Looks for such filters in what a mapper's input comes from. True if there are some that no
  // frame has had before: they are modified, and size what they make for a wide view from then on.
  bool Watch(vtkMapper* mapper);

private:
  std::vector<vtkWeakPointer<vtkDistanceToCamera>> Sizing;
  const Projection* Map = nullptr;            // of the last frame
  std::array<double, 14> View{ { 0, 0, 0 } }; // fields, tilt, lens, size
};
}

#endif
