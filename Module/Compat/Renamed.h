// SPDX-License-Identifier: BSD-3-Clause
// What VTK 9.6 calls by another name, and warns of by the old one.
#ifndef WideFoVRenamed_h
#define WideFoVRenamed_h

#include "vtkCellTypes.h"
#include "vtkDataSet.h"
#include "vtkProp.h"
#include "vtkVersionMacros.h"

namespace wfv
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
inline void FindCellTypes(vtkDataSet* data, vtkCellTypes* types)
{
  data->GetDistinctCellTypes(types);
}

inline vtkInformationDoubleVectorKey* TextureTransform()
{
  return vtkProp::GENERAL_TEXTURE_TRANSFORM();
}
#else
inline void FindCellTypes(vtkDataSet* data, vtkCellTypes* types)
{
  data->GetCellTypes(types);
}

inline vtkInformationDoubleVectorKey* TextureTransform()
{
  return vtkProp::GeneralTextureTransform();
}
#endif
}

#endif
