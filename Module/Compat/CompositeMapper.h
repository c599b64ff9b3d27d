// SPDX-License-Identifier: BSD-3-Clause
// The mapper that draws all blocks of composite data itself, and what it hands them to. Up to
// VTK 9.2 these are vtkCompositePolyDataMapper2 of the OpenGL module and its helpers; from 9.3 on
// vtkCompositePolyDataMapper, and the mappers of batches that its delegators have (the other is
// deprecated there, and gone in 9.5).
#ifndef WideFoVCompositeMapper_h
#define WideFoVCompositeMapper_h

#include "vtkVersionMacros.h"
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
using vtkWideFoVCompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using vtkWideFoVCompositeMapper = vtkCompositePolyDataMapper2;
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
