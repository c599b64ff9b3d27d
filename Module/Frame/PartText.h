// SPDX-License-Identifier: BSD-3-Clause
// Texts that another prop draws and keeps to itself, such as the numbers of an axes grid.
#ifndef WideFoVPartText_h
#define WideFoVPartText_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// A vtkBillboardTextActor3D that shows itself where the map does when it is drawn in a wide frame.
// Those that stand in the scene themselves are Billboards.
vtkObject* MakePartText();
}

#endif
