# SPDX-License-Identifier: BSD-3-Clause
# Run by CPack over the folders that packages are made of: adds what Debian wants in each, takes out
# what is of a build tree alone, and gives all the time of the commit.
set(moment "$ENV{SOURCE_DATE_EPOCH}")
file(GLOB folders LIST_DIRECTORIES ON "${CPACK_TEMPORARY_DIRECTORY}/*")
foreach(folder IN LISTS folders)
  get_filename_component(component "${folder}" NAME)
  string(TOUPPER "${component}" upper)
  set(package "${CPACK_DEBIAN_${upper}_PACKAGE_NAME}")
  set(documents "${folder}/usr/share/doc/${package}")
  file(MAKE_DIRECTORY "${documents}")
  file(READ "${CPACK_WIDEFOV_SOURCE}/LICENSE" licence)
  if(CPACK_WIDEFOV_${upper}_COPYRIGHT)
    if(NOT EXISTS "${CPACK_WIDEFOV_${upper}_COPYRIGHT}")
      message(FATAL_ERROR "${CPACK_WIDEFOV_${upper}_COPYRIGHT} is not there, for dpkg leaves out documents here; "
        "let it take /usr/share/doc/*/copyright, and install libimgui-dev again")
    endif()
    file(READ "${CPACK_WIDEFOV_${upper}_COPYRIGHT}" of_imgui)
    string(APPEND licence "\n\nThe program widefov-viewer holds Dear ImGui, of which its package of Debian says:\n\n${of_imgui}")
  endif()
  set(viewer "${folder}/usr/share/widefov/web/licences.txt")
  if(EXISTS "${viewer}")
    file(READ "${viewer}" of_viewer)
    string(APPEND licence "\n\nThe viewer in /usr/share/widefov/web is made of:\n\n${of_viewer}")
  endif()
  file(WRITE "${documents}/copyright" "${licence}")
  string(TIMESTAMP day "%a, %d %b %Y %H:%M:%S +0000" UTC) # of SOURCE_DATE_EPOCH
  file(WRITE "${documents}/changelog.Debian" "widefov (${CPACK_DEBIAN_PACKAGE_VERSION}) unstable; \
urgency=medium\n\n  * What changed stands in changelog.gz.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${day}\n")
  file(COPY_FILE "${CPACK_WIDEFOV_SOURCE}/CHANGELOG.md" "${documents}/changelog")
  execute_process(COMMAND gzip -9 -n "${documents}/changelog.Debian" "${documents}/changelog"
    COMMAND_ERROR_IS_FATAL ANY)

  # system folders need no search path; the plugin finds what lies beside it by one
  set(programs)
  if(NOT component STREQUAL "plugin")
    file(GLOB_RECURSE programs "${folder}/usr/bin/*" "${folder}/usr/lib/*.so*")
  endif()
  foreach(program IN LISTS programs)
    if(NOT IS_SYMLINK "${program}")
      file(RPATH_REMOVE FILE "${program}")
    endif()
  endforeach()
  execute_process(
    COMMAND find "${folder}" -exec touch --no-dereference "--date=@${moment}" {} +
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
