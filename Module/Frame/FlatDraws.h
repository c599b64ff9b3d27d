// SPDX-License-Identifier: BSD-3-Clause
// What of a wide frame was left out, for its shaders know no stage.
#ifndef WideFoVFlatDraws_h
#define WideFoVFlatDraws_h

#include "vtkWideFoVAbi.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
class vtkObject;
class vtkProp;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Once for each name: of the props, those that were not drawn by a stage, which is told by their
// keys; where all were, of those that are drawn by a mapper of another class than most.
void WarnOfFlatDraws(vtkObject* reporter, const std::vector<vtkProp*>& props,
  std::vector<const vtkInformation*> drawn);
}

#endif
