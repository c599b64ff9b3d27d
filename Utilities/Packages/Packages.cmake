# SPDX-License-Identifier: BSD-3-Clause
# Debian packages of what this build installs, a component each. Utilities/package.sh makes them:
# it tells CPack the version and the time, so that one commit gives the same bytes each time.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME widefov)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_CONTACT "WideFoV maintainers <maintainers@widefov.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/finish.cmake")
set(CPACK_WIDEFOV_SOURCE "${PROJECT_SOURCE_DIR}")
set(CPACK_COMPONENTS_ALL)

# widefov_package(COMPONENT NAME SECTION SUMMARY DESCRIPTION)
macro(widefov_package component name section summary description)
  string(TOUPPER "${component}" upper)
  list(APPEND CPACK_COMPONENTS_ALL "${component}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION "${section}")
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${description}")
endmacro()

# widefov_same(VARIABLE PACKAGE VERSION): the version it was built with, whatever Debian mended in it
function(widefov_same variable package version)
  string(REGEX MATCH "^(.*[^0-9])?([0-9]+)$" _ "${version}")
  math(EXPR next "${CMAKE_MATCH_2} + 1")
  set(${variable} "${package} (>= ${version}), ${package} (<< ${CMAKE_MATCH_1}${next}~)" PARENT_SCOPE)
endfunction()

if(WIDEFOV_PARAVIEW)
  widefov_package(plugin paraview-widefov science
    "wide fields of view in ParaView: panoramas and domes"
    "A plugin for ParaView with a view that shows all directions in one picture,\nfor panoramas, Hammer maps, domes and two eyes. Load it by ParaView's menu\nTools, Manage Plugins.")
  set(paraview_version "${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
  widefov_same(CPACK_DEBIAN_PLUGIN_PACKAGE_DEPENDS paraview "${paraview_version}")
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${WIDEFOV_PARAVIEW_LIBRARIES}")
  include(CPack)
  return()
endif()

set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
# (named as VTK's: what a minor version adds may change the rest)
set(library "libwidefov${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
widefov_package(runtime "${library}" libs
  "wide field-of-view rendering for VTK, library"
  "Draws VTK scenes in non-planar projections with fields of view up to 360\ndegrees, in one pass: panoramas, Hammer maps and domes without a cube map\nbetween the scene and the picture.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/triggers")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
widefov_same(of_vtk libvtk9-dev "${VTK_VERSION}")
widefov_package(development libwidefov-dev libdevel
  "wide field-of-view rendering for VTK, headers and CMake files"
  "What a program needs to be built with ${library}: in CMake,\nfind_package(VTKWideFoV).")
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS runtime)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${of_vtk}, libglm-dev")

if(TARGET vtkRenderingWideFoVPython)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  widefov_same(of_python python3 "${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
  widefov_same(of_vtk python3-vtk9 "${VTK_VERSION}")
  widefov_package(python python3-widefov python
    "wide field-of-view rendering for VTK, Python module"
    "The classes of ${library} beside those of VTK's Python modules,\nand a picture in one call.")
  set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${of_python}, ${of_vtk}, python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS widefov) # the viewer of widefov.show
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${CMAKE_CURRENT_LIST_DIR}/postinst;${CMAKE_CURRENT_LIST_DIR}/prerm")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
endif()

if(TARGET widefov-viewer)
  widefov_package(programs widefov science
    "panoramas, dome masters and stereo pictures of scientific data"
    "Turns files that VTK reads into pictures of all directions round the eye:\npanoramas for viewers of 360 degrees, dome masters, maps, screens of a CAVE,\nfor one eye or two. A viewer shows them in a window; a launcher makes the\nviews of programs of others wide.")
  set(CPACK_COMPONENT_PROGRAMS_DEPENDS runtime)
  set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "ffmpeg, libgl1-mesa-dri, ferret-datasets")
  set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "python3-widefov, paraview-widefov, xvfb")
  get_property(panel GLOBAL PROPERTY WIDEFOV_VIEWER_HAS_PANEL)
  if(panel) # the viewer has a copy of the library in it, whose licence asks to be said
    set(CPACK_WIDEFOV_PROGRAMS_COPYRIGHT /usr/share/doc/libimgui-dev/copyright)
  endif()
  install(FILES "${CMAKE_CURRENT_LIST_DIR}/widefov-viewer.desktop"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
  install(FILES "${CMAKE_CURRENT_LIST_DIR}/widefov.xml"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages")
  install(FILES "${PROJECT_SOURCE_DIR}/Plugin/Window/Icons/presets.svg"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps" RENAME widefov.svg)
endif()
include(CPack)
