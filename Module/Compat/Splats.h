// SPDX-License-Identifier: BSD-3-Clause
// Point gaussians: how far a splat is drawn, in radii of its gaussian. Called the scale of the
// triangle round it up to VTK 9.3, and the scale of its bound since 9.4 (the commit is of October
// 2023: the VTK of ParaView 5.13, 9.3.20240617, has it), which draws squares.
#ifndef WideFoVSplats_h
#define WideFoVSplats_h

#include "vtkPointGaussianMapper.h"
#include "vtkVersionMacros.h"

namespace wfv
{
inline float SplatBound(vtkPointGaussianMapper* mapper)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20231026)
  return mapper->GetBoundScale();
#else
  return mapper->GetTriangleScale();
#endif
}
}

#endif
