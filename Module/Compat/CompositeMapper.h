// SPDX-License-Identifier: BSD-3-Clause
// The mapper that draws all blocks of composite data itself. Up to VTK 9.2 this is
// vtkCompositePolyDataMapper2 of the OpenGL module; from 9.3 on it is vtkCompositePolyDataMapper,
// which hands the blocks in lots to mappers of its own, and the other is deprecated (gone in 9.5).
#ifndef WideFoVCompositeMapper_h
#define WideFoVCompositeMapper_h

#include "vtkWideFoVAbi.h"

#include "vtkVersionMacros.h"
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
using vtkWideFoVCompositeMapper = vtkCompositePolyDataMapper;
#define WIDEFOV_CLASSIFIES_BLOCKS 0
#else
#include "vtkCompositePolyDataMapper2.h"
using vtkWideFoVCompositeMapper = vtkCompositePolyDataMapper2;
#define WIDEFOV_CLASSIFIES_BLOCKS 1
#endif

VTK_ABI_NAMESPACE_BEGIN
class vtkObjectBase;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Whether it draws blocks, and their clusters are classified (Frame/BlockClusters.h).
bool ClassifiesBlocks(vtkObjectBase* mapper);

// Whether it is the mapper above and no class derived from it, which may draw more than its input;
// or one of those that it hands its blocks to.
bool IsStockComposite(vtkObjectBase* mapper);
bool DrawsBlocks(vtkObjectBase* mapper);
}

#endif
