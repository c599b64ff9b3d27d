// SPDX-License-Identifier: BSD-3-Clause
// Clusters of the blocks of composite data, classified as those of single meshes are. How a
// composite mapper is given what classifies them (vtkWideFoVCompositeHelper) differs from VTK to
// VTK: BlockHelpers.cxx up to 9.2, BlockDelegator.cxx from 9.3 on.
#ifndef WideFoVBlockClusters_h
#define WideFoVBlockClusters_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkMapper;
class vtkObject;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Before a mapper draws; does nothing from VTK 9.3 on.
void ClassifyBlocksOf(vtkMapper* mapper, vtkWindow* window);

// For the factory of the module (Overrides.h); nullptr up to VTK 9.2.
vtkObject* MakeBlockDelegator();
}

#endif
