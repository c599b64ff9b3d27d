#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# From a bare Debian 12 machine to the test results: installs what is missing, builds
# in build/ (an existing build is reused), runs every test.
#
#   bash Testing/run.sh [CTEST OPTION...]      for example -R Style, or -LE slow
#
# Exit code: 0 when everything was built and every test passed.
set -euo pipefail
exec < /dev/null
cd "$(dirname "${BASH_SOURCE[0]}")/.."

step="installing packages"
trap 'code=$?; [ "$code" -eq 0 ] || echo "Testing/run.sh: FAILED while $step (exit code $code)"' EXIT

bash Utilities/install-packages.sh build examples test

step=configuring
cmake --preset test -DWIDEFOV_BUILD_TESTING=ON -DWIDEFOV_BUILD_EXAMPLES=ON -DWIDEFOV_WRAP_PYTHON=ON

step=building
cmake --build build

step=testing
bash Utilities/with-display.sh ctest --test-dir build --output-on-failure --no-tests=error --timeout 900 \
  --parallel "$(nproc)" "$@"

echo "Testing/run.sh: built, and every test passed"
