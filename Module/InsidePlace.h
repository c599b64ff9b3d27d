// SPDX-License-Identifier: BSD-3-Clause
// A place for an eye that looks all round.
#ifndef WideFoVInsidePlace_h
#define WideFoVInsidePlace_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// The middle of the bounds (xmin, xmax, .., zmax; world) where there is room round it; else, of
// places in the middle half of the bounds, the one that is farthest from the surfaces of visible
// actors.
void FindInsidePlace(vtkRenderer* renderer, const double bounds[6], double place[3]);
}

#endif
