// SPDX-License-Identifier: BSD-3-Clause
// Where there is no display.
#ifndef vtkWideFoVCompatDisplay_h
#define vtkWideFoVCompatDisplay_h

#include "vtkVersionMacros.h"

namespace wfv
{
namespace compat
{
// From 9.4 on VTK looks at run time for what can open a window: X, then EGL, then OSMesa. Before,
// the window of a build for X aborts the program where no display can be opened.
constexpr bool WindowsNeedADisplay = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0);

// What that VTK reads: begin with this window, and do not warn of a display that is not there. It
// still goes on to OSMesa.
constexpr const char* WindowVariable = "VTK_DEFAULT_OPENGL_WINDOW";
constexpr const char* WindowWithoutDisplay = "vtkEGLRenderWindow";
}
}

#endif
