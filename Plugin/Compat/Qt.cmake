# SPDX-License-Identifier: BSD-3-Clause
# Which Qt this ParaView was built with. It says so since 5.13 (that of Debian 13 has Qt 6); before
# there was Qt 5 alone.
if(PARAVIEW_QT_MAJOR_VERSION)
  set(WIDEFOV_QT "${PARAVIEW_QT_MAJOR_VERSION}")
else()
  set(WIDEFOV_QT 5)
endif()
