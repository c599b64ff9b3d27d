#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# From a bare Debian machine (12, 13 or testing) to pictures: installs what is missing, builds
# widefov-render in build/ (an existing build is reused) and renders into output/.
#
#   bash Examples/run.sh [FILE]
#
# Always the scene "winds": NOAA relief as a globe seen from its centre, surface winds
# as arrows and stream tubes inside it. With FILE, any data file widefov-render reads,
# the same three pictures of it. Where the data sets of the project lie beside the checkout
# (../shared/data), also an air flow in an office.
set -euo pipefail
exec < /dev/null

step="reading the command line"
trap 'code=$?; [ "$code" -eq 0 ] || echo "Examples/run.sh: FAILED while $step (exit code $code)" >&2' EXIT

file=()
if [ "$#" -gt 1 ] || { [ "$#" -eq 1 ] && ! { [ -f "$1" ] && [ -r "$1" ]; }; }; then
  echo "Examples/run.sh: one readable data file (such as a .vtk or .vtp) or nothing, not: $*" >&2
  exit 2
fi
[ "$#" -eq 0 ] || file=("$(realpath "$1")")

cd "$(dirname "${BASH_SOURCE[0]}")/.."

step="installing packages"
bash Utilities/install-packages.sh build examples

# An existing build keeps its options, so that nothing is compiled twice; only the
# programs are switched on where they are off.
step=configuring
if [ ! -f build/build.ninja ]; then
  cmake --preset default -DWIDEFOV_BUILD_TESTING=OFF -DCMAKE_UNITY_BUILD=ON
elif grep -q '^WIDEFOV_BUILD_\(PROGRAMS\|EXAMPLES\):BOOL=OFF$' build/CMakeCache.txt; then
  cmake -DWIDEFOV_BUILD_PROGRAMS=ON build
fi

step=building
cmake --build build --target widefov-render

step=rendering
bash Utilities/with-display.sh --for build bash Examples/render-pictures.sh ${file[@]+"${file[@]}"}
