// SPDX-License-Identifier: BSD-3-Clause
// Renderers of a window that are drawn with one depth buffer: one that keeps the depth of those
// before it (PreserveDepthBuffer), and these.
#ifndef WideFoVSharedDepth_h
#define WideFoVSharedDepth_h

#include "vtkWideFoVAbi.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Finds those whose depth a renderer shares, itself among them, in the order of drawing.
void FindRenderersOfDepth(vtkRenderer* renderer, std::vector<vtkRenderer*>& found);
}

#endif
