// SPDX-License-Identifier: BSD-3-Clause
// The OpenGL loader of this VTK.
#ifndef vtkWideFoVGl_h
#define vtkWideFoVGl_h

#include "vtkVersionMacros.h"
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
