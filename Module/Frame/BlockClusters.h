// SPDX-License-Identifier: BSD-3-Clause
// Clusters of the blocks of composite data.
#ifndef WideFoVBlockClusters_h
#define WideFoVBlockClusters_h

#include "Compat/CompositeMapper.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkMapper;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Before a composite mapper draws: the clusters of its blocks are to be classified as those of
// single meshes are. Where VTK's mappers leave no way to do that, blocks are drawn as the prop's
// stage says.
#if WIDEFOV_CLASSIFIES_BLOCKS
void ClassifyBlocksOf(vtkMapper* mapper, vtkWindow* window); // vtkWideFoVCompositeHelper.cxx
#else
inline void ClassifyBlocksOf(vtkMapper*, vtkWindow*) {}
#endif
}

#endif
