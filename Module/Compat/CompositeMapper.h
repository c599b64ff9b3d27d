// SPDX-License-Identifier: BSD-3-Clause
// The mapper that draws all blocks of composite data itself. Up to VTK 9.2 this is
// vtkCompositePolyDataMapper2 of the OpenGL module; from 9.3 on it is vtkCompositePolyDataMapper,
// which hands the blocks in batches to mappers of its own, and the other is deprecated (gone
// in 9.5).
#ifndef WideFoVCompositeMapper_h
#define WideFoVCompositeMapper_h

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

namespace wfv
{
// Of the mapper above, and of what it hands blocks to.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
constexpr const char* CompositeMapperName = "vtkCompositePolyDataMapper";
constexpr const char* BlockMapperName = "vtkOpenGLBatchedPolyDataMapper";
#else
constexpr const char* CompositeMapperName = "vtkCompositePolyDataMapper2";
constexpr const char* BlockMapperName = "vtkCompositeMapperHelper2";
#endif
}

#endif
