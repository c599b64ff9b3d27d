#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Starts the program of a bundle (bundle.sh) under whose name it is called, wherever the bundle
# lies. What the OpenGL driver uses as well comes from the machine where it has it, for its
# driver may ask for a newer one than the bundle's; what it has not, from lib/machine.
here="$(dirname "$(readlink -f "$0")")"
program="$here/bin/$(basename "$0")"
if [ ! -x "$program" ]; then
  echo "launch.sh: call it by the name of a program: $(cd "$here/bin" && echo *)" >&2
  exit 2
fi
export WIDEFOV_DATA_DIR="${WIDEFOV_DATA_DIR:-$here/data}"
# With films in it the bundle has an ffmpeg of its own, which knows its libraries.
[ ! -d "$here/ffmpeg" ] || export PATH="$here/ffmpeg:$PATH"
# One that is added may itself need others.
while :; do
  missing="$(LD_TRACE_LOADED_OBJECTS=1 "$program" | sed -n 's/^[[:space:]]*\(.*\) => not found.*/\1/p' | sort -u)"
  [ -n "$missing" ] || break
  for library in $missing; do
    if [ ! -d "$here/lib/machine/$library" ]; then
      echo "$(basename "$0"): $library is neither on this machine nor in the bundle" >&2
      exit 1
    fi
    LD_LIBRARY_PATH="${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}$here/lib/machine/$library"
  done
  export LD_LIBRARY_PATH
done
exec "$program" "$@"
