#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs a command on the display there is, else on a virtual one of its own.
#
#   bash with-display.sh COMMAND [ARGUMENT...]
set -euo pipefail
if [ -n "${DISPLAY:-}" ]; then
  exec "$@"
fi
exec xvfb-run --auto-servernum --server-args="-screen 0 1280x1024x24 -noreset" "$@"
