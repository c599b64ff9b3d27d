// SPDX-License-Identifier: BSD-3-Clause
// What props and mappers do for the frustum of a camera, and must not do in a wide view.
#ifndef WideFoVFlatHabits_h
#define WideFoVFlatHabits_h

#include "vtkWideFoVAbi.h"

#include "vtkSmartPointer.h"

#include <deque>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkProp;
class vtkWideFoVCamera;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// For a frame: glyphs are neither culled nor simplified by a frustum; images are not resampled to
// the pixels of a perspective; followers look at the eye upright, for the direction they are seen
// in. Nothing counts as modified by it.
class FlatHabits
{
public:
  // aspect: of the picture.
  void Stop(vtkProp* prop, vtkWideFoVCamera* camera, double aspect);

  // As they were.
  void Restore();

private:
  void Face(vtkProp* prop, vtkWideFoVCamera* camera, double aspect);

  std::vector<std::function<void()>> Undo;
  std::deque<vtkSmartPointer<vtkCamera>> Cameras; // kept from frame to frame
  std::size_t UsedCameras = 0;
};
}

#endif
