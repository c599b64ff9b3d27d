// SPDX-License-Identifier: BSD-3-Clause
// VTK's own namespace. From 9.3 on VTK can be built with one (VTK_ABI_NAMESPACE_NAME), so that two
// VTKs live in one process; what declares a class of VTK, or is a class beside them, is written
// between these words. Before 9.3 there are none. (VTK's own parser reads this too, which before
// 9.3 knows neither __has_include nor macros with arguments.)
#ifndef vtkWideFoVAbi_h
#define vtkWideFoVAbi_h

#include "vtkVersionMacros.h"
#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 3)
#include "vtkABINamespace.h"
#else
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif
