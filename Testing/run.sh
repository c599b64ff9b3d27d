#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# From a bare Debian machine (12, 13 or testing) to the test results: installs what is missing, builds
# in build/ and build-paraview/ (existing builds are reused), runs every test.
#
#   bash Testing/run.sh [CTEST OPTION...]      for example -R Style, or -LE slow
#
# Both flavours: the module against the system's VTK, and in build-paraview/ the ParaView
# plugin against Debian's ParaView. WIDEFOV_FLAVOURS="vtk" or "paraview" builds one.
#
# Exit code: 0 when everything was built and every test passed.
set -euo pipefail
exec < /dev/null
cd "$(dirname "${BASH_SOURCE[0]}")/.."

step="installing packages"
trap 'code=$?; [ "$code" -eq 0 ] || echo "Testing/run.sh: FAILED while $step (exit code $code)"' EXIT

flavours=" ${WIDEFOV_FLAVOURS:-vtk paraview} "

ran=no

# run_tests FOLDER [CTEST OPTION...]: tests that were asked for may be in one flavour only.
run_tests() {
  if ctest --test-dir "$1" --show-only "${@:2}" | grep -q '^Total Tests: 0$'; then
    return
  fi
  ran=yes
  bash Utilities/with-display.sh --for "$1" ctest --test-dir "$1" --output-on-failure --no-tests=error \
    --timeout 900 --parallel "$(($(nproc) + 1))" "${@:2}" # some wait for windows and servers
}

if [[ "$flavours" == *" vtk "* ]]; then
  step="installing packages"
  bash Utilities/install-packages.sh build examples test
  step=configuring
  cmake --preset test -DWIDEFOV_BUILD_TESTING=ON -DWIDEFOV_BUILD_PROGRAMS=ON -DWIDEFOV_WRAP_PYTHON=ON
  step=building
  cmake --build build
fi
if [[ "$flavours" == *" paraview "* ]]; then
  step="installing packages for ParaView"
  bash Utilities/install-packages.sh build examples test paraview
  step="fetching ParaView"
  bash Utilities/fetch-paraview.sh build-paraview/paraview
  step="configuring the plugin"
  cmake --preset paraview -DWIDEFOV_BUILD_TESTING=ON
  step="building the plugin"
  cmake --build build-paraview
fi

if [[ "$flavours" == *" vtk "* ]]; then
  step=testing
  run_tests build "$@"
fi
if [[ "$flavours" == *" paraview "* ]]; then
  step="testing the plugin"
  run_tests build-paraview "$@"
fi
step="looking for tests"
[ "$ran" = yes ]

echo "Testing/run.sh: built, and every test passed"
