# SPDX-License-Identifier: BSD-3-Clause
# What differs between the versions of VTK in CMake's own files. For C++ see the headers beside
# this one.
#
# Left alone: the keys SPDX_* of vtk.module (read since 9.3 where SPDX files are generated, an
# error before) and INCLUDE_MARSHAL (since 9.4, for classes that can be serialized).

# The newest VTK that the tests ran with.
set(WIDEFOV_NEWEST_VTK 9.6)

# The modules with OpenGL itself, as components of VTK: glad since 9.4, glew and opengl before.
# They are optional, for before VTK is found nothing tells its version.
set(widefov_gl_components glad glew opengl)

# widefov_gl_modules(VARIABLE): those of them that this VTK has.
function(widefov_gl_modules variable)
  set(found)
  foreach(component IN LISTS widefov_gl_components)
    if(TARGET "VTK::${component}")
      list(APPEND found "VTK::${component}")
    endif()
  endforeach()
  set("${variable}" "${found}" PARENT_SCOPE)
endfunction()

# widefov_compat_sources(VARIABLE): what some versions need, below Module/. How composite mappers
# are given what draws their blocks: see Frame/BlockClusters.h.
function(widefov_compat_sources variable)
  if(VTK_VERSION VERSION_LESS 9.3)
    set("${variable}" Frame/BlockHelpers.cxx PARENT_SCOPE)
  else()
    set("${variable}" Frame/BlockDelegator.cxx PARENT_SCOPE)
  endif()
endfunction()

# A newer VTK is tried: what it changed of its shaders is reported when a scene is drawn.
function(widefov_check_vtk_version)
  string(REGEX MATCH "^[0-9]+\\.[0-9]+" release "${VTK_VERSION}")
  if(release VERSION_GREATER WIDEFOV_NEWEST_VTK)
    message(WARNING "VTK ${VTK_VERSION} is newer than ${WIDEFOV_NEWEST_VTK}, "
      "the newest that this module was tested with")
  endif()
endfunction()
