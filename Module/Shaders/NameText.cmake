# SPDX-License-Identifier: BSD-3-Clause
# cmake -Dinput=FILE -Doutput=FILE -Dname=TEXT -P NameText.cmake
#
# Copies a shader fragment, with its name in the place of its licence: so each part of a program's
# text says which file it is from, and no line has moved.
file(READ "${input}" text)
set(licence "// SPDX-License-Identifier: BSD-3-Clause\n")
string(FIND "${text}" "${licence}" found)
if(found EQUAL -1)
  message(FATAL_ERROR "${input} has no line ${licence}")
endif()
string(REPLACE "${licence}" "// WideFoV: ${name}\n" text "${text}")
file(WRITE "${output}" "${text}")
