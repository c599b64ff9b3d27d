#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs a command on the display there is, else on a virtual one of its own.
#
#   bash with-display.sh COMMAND [ARGUMENT...]
#   bash with-display.sh --for BUILD COMMAND [ARGUMENT...]   as it is where the VTK of that
#                                                        build folder needs none: 9.4 and later
set -euo pipefail
if [ "$1" = --for ]; then
  if grep -qs '^WIDEFOV_NEEDS_DISPLAY:INTERNAL=OFF$' "$2/CMakeCache.txt"; then
    exec "${@:3}"
  fi
  shift 2
fi
if [ -n "${DISPLAY:-}" ]; then
  exec "$@"
fi
exec xvfb-run --auto-servernum --server-args="-screen 0 1280x1024x24 -noreset" "$@"
