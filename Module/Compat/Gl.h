// SPDX-License-Identifier: BSD-3-Clause
// The OpenGL loader of this VTK: glad in the place of GLEW since 9.4.
#ifndef WideFoVGl_h
#define WideFoVGl_h

#include "vtkVersionMacros.h"
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#include "vtk_glad.h"
#define WIDEFOV_LOADER_IS_GLAD 1 // which is told where to find OpenGL's functions
#define WIDEFOV_HAS_GL(extension) (GLAD_GL_##extension != 0)
#else
#include "vtk_glew.h"
#define WIDEFOV_LOADER_IS_GLAD 0
#define WIDEFOV_HAS_GL(extension) (GLEW_##extension != 0)
#endif

#endif
