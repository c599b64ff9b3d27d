# SPDX-License-Identifier: BSD-3-Clause
# Display.h for CMake: what tests are run through, and for scripts, in CMakeCache.txt, whether a
# display is needed. From 9.4 on VTK opens windows without one; told to, it does not look for one first.
set(needs_display OFF)
if(VTK_VERSION VERSION_LESS 9.4)
  set(needs_display ON)
  set(WIDEFOV_WITH_DISPLAY bash "${PROJECT_SOURCE_DIR}/Utilities/with-display.sh")
else()
  set(WIDEFOV_WITH_DISPLAY "${CMAKE_COMMAND}" -E env VTK_DEFAULT_OPENGL_WINDOW=vtkEGLRenderWindow)
endif()
set(WIDEFOV_NEEDS_DISPLAY ${needs_display} CACHE INTERNAL "VTK opens windows on a display alone")
