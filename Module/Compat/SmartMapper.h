// SPDX-License-Identifier: BSD-3-Clause
// vtkSmartVolumeMapper and vtkVolumeMapper, of a VTK that has them: their inline and virtual
// functions alone, the module does not link to them.
#ifndef WideFoVSmartMapper_h
#define WideFoVSmartMapper_h

#include "vtkAbstractVolumeMapper.h"

#if __has_include("vtkSmartVolumeMapper.h")
#include "vtkSmartVolumeMapper.h"
#include "vtkVolumeMapper.h"
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

// What one mapper of images shows, and how, for another. False where this VTK has none.
inline bool CopyVolume(vtkAbstractVolumeMapper* from, vtkAbstractVolumeMapper* to)
{
#if WFV_SMART_MAPPER
  auto* const source = static_cast<vtkVolumeMapper*>(from);
  auto* const copy = static_cast<vtkVolumeMapper*>(to);
  copy->SetBlendMode(source->GetBlendMode());
  copy->SetAverageIPScalarRange(source->GetAverageIPScalarRange());
  copy->SetCropping(source->GetCropping());
  copy->SetCroppingRegionPlanes(source->GetCroppingRegionPlanes());
  copy->SetCroppingRegionFlags(source->GetCroppingRegionFlags());
#endif
  to->SetInputConnection(from->GetInputConnection(0, 0));
  to->SetClippingPlanes(from->GetClippingPlanes());
  to->SetScalarMode(from->GetScalarMode());
  if (from->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME)
  {
    to->SelectScalarArray(from->GetArrayName());
  }
  else
  {
    to->SelectScalarArray(from->GetArrayId());
  }
  return WFV_SMART_MAPPER != 0;
}
}

#endif
