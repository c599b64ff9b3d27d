# SPDX-License-Identifier: BSD-3-Clause
# What a program says of its options, as a page of man and as a completion of bash. Both are written
# by the program that was built; without help2man there is no page.
find_program(WIDEFOV_HELP2MAN help2man)
mark_as_advanced(WIDEFOV_HELP2MAN)
if(NOT WIDEFOV_HELP2MAN)
  message(STATUS "help2man is not installed: there are no pages of man")
endif()

# widefov_describe_program(TARGET TEXT): the text goes behind its name at the top of the page.
function(widefov_describe_program target text)
  set(completion "${CMAKE_CURRENT_BINARY_DIR}/${target}.bash")
  add_custom_command(OUTPUT "${completion}"
    COMMAND ${target} --completion bash > "${completion}"
    DEPENDS ${target} VERBATIM)
  install(FILES "${completion}" RENAME "${target}"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
  set(written "${completion}")
  if(WIDEFOV_HELP2MAN)
    set(page "${CMAKE_CURRENT_BINARY_DIR}/${target}.1")
    add_custom_command(OUTPUT "${page}"
      COMMAND "${WIDEFOV_HELP2MAN}" --no-info "--name=${text}" "--output=${page}"
        "$<TARGET_FILE:${target}>"
      DEPENDS ${target} VERBATIM)
    install(FILES "${page}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
    list(APPEND written "${page}")
  endif()
  add_custom_target(${target}-described ALL DEPENDS ${written})
endfunction()
