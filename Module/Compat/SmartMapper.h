// SPDX-License-Identifier: BSD-3-Clause
// vtkSmartVolumeMapper, of a VTK that has it: its inline functions alone, the module does not link
// to it.
#ifndef WideFoVSmartMapper_h
#define WideFoVSmartMapper_h

#include "vtkAbstractVolumeMapper.h"

#if __has_include("vtkSmartVolumeMapper.h")
#include "vtkSmartVolumeMapper.h"
#define WFV_SMART_MAPPER 1
#else
#define WFV_SMART_MAPPER 0
#endif

namespace wfv
{
// False where it is told to draw otherwise than by GPU ray casting; for a mapper that is one.
inline bool MayDrawByGpu(vtkAbstractVolumeMapper* mapper)
{
#if WFV_SMART_MAPPER
  const int mode = static_cast<vtkSmartVolumeMapper*>(mapper)->GetRequestedRenderMode();
  return mode == vtkSmartVolumeMapper::DefaultRenderMode ||
    mode == vtkSmartVolumeMapper::GPURenderMode;
#else
  return mapper != nullptr;
#endif
}
}

#endif
