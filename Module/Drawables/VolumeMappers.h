// SPDX-License-Identifier: BSD-3-Clause
// Which volumes can be drawn in a wide view.
#ifndef WideFoVVolumeMappers_h
#define WideFoVVolumeMappers_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace volume
{
// True of a volume whose mapper makes the rays of a flat picture itself, on the processor or of
// tetrahedra. Warns once of each kind of mapper.
bool IsFlatVolume(vtkProp* prop);
}
}

#endif
