// SPDX-License-Identifier: BSD-3-Clause
// What draws the blocks of composite data: up to VTK 9.2 vtkCompositeMapperHelper2, from 9.3 on
// vtkOpenGLBatchedPolyDataMapper, which is the same with other names for what it knows of a block.
#ifndef WideFoVBlockMapper_h
#define WideFoVBlockMapper_h

#include "Compat/Gl.h" // before whatever brings OpenGL with it

#include "vtkVersionMacros.h"
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkOpenGLBatchedPolyDataMapper.h"
#else
#include "vtkColor.h" // which VTK 9.1's header of the helper takes for granted
#include "vtkCompositeMapperHelper2.h"
#endif

#include <vector>

namespace wfv
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
class BlockMapper : public vtkOpenGLBatchedPolyDataMapper
{
protected:
  using BlockOfMapper = GLBatchElement;

  static const BatchElement& LooksOf(const BlockOfMapper& block) { return block.Parent; }

  template <typename F>
  void ForEachBlock(const F& call)
  {
    for (const auto& each : this->VTKPolyDataToGLBatchElement)
    {
      call(each.second->Parent.PolyData, *each.second);
    }
  }
};
#else
class BlockMapper : public vtkCompositeMapperHelper2
{
protected:
  using BlockOfMapper = vtkCompositeMapperHelperData;

  static const BlockOfMapper& LooksOf(const BlockOfMapper& block) { return block; }

  template <typename F>
  void ForEachBlock(const F& call)
  {
    for (const auto& each : this->Data)
    {
      call(each.first, *each.second);
    }
  }
};
#endif
}

#endif
