# SPDX-License-Identifier: BSD-3-Clause
# The whole build of the flavour WIDEFOV_PARAVIEW, in the scope of the top folder. Module
# and plugin end up in one folder that ParaView's plugin manager can load from.
find_package(ParaView 5.11 REQUIRED)
find_package(glm REQUIRED)
get_target_property(WIDEFOV_PARAVIEW_LIBRARIES ParaView::RemotingViews LOCATION)
get_filename_component(WIDEFOV_PARAVIEW_LIBRARIES "${WIDEFOV_PARAVIEW_LIBRARIES}" DIRECTORY)

add_subdirectory("${PROJECT_SOURCE_DIR}/Module/Metadata" metadata)

# scanned, and built without having to ask
set(_paraview_plugin_default_WideFoV ON)
paraview_plugin_scan(
  PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS widefov_plugins
  REQUIRES_MODULES widefov_required_modules
  HIDE_PLUGINS_FROM_CACHE ON)
foreach(module IN LISTS widefov_required_modules)
  if(NOT TARGET "${module}")
    message(FATAL_ERROR "This ParaView was built without ${module}, which the plugin needs")
  endif()
endforeach()
paraview_plugin_build(
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_COMPONENT plugin
  PLUGINS ${widefov_plugins})

if(WIDEFOV_BUILD_TESTING)
  enable_testing()
  add_subdirectory(Testing/ParaView)
endif()
include(Utilities/Packages/Packages.cmake)
