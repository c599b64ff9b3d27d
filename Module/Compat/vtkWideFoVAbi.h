// SPDX-License-Identifier: BSD-3-Clause
// VTK's own namespace. From 9.3 on VTK can be built with one (VTK_ABI_NAMESPACE_NAME), so that two
// VTKs live in one process; what declares a class of VTK, or is a class beside them, is written
// between these words. Before 9.3 there are none.
#ifndef vtkWideFoVAbi_h
#define vtkWideFoVAbi_h

#if __has_include("vtkABINamespace.h")
#include "vtkABINamespace.h"
#else
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif
