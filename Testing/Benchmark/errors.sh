#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The errors of every scene in every wide projection, at its widest: writes the table of
# Documentation/benchmarks/errors.md, from JSON files in output/errors.
#
#   bash Testing/Benchmark/errors.sh [--data FOLDER] [OPTION OF WIDEFOV-BENCH...]
#   for example: errors.sh --scenes cornell,room
#
# Two projections at a time, some ten minutes on two cores: times are not looked at. Needs a
# build in build/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

[ -x build/bin/widefov-bench ] ||
  { echo "errors.sh: there is no build/bin/widefov-bench; build the project first" >&2; exit 1; }

mkdir -p output/errors
bash Utilities/with-display.sh build/bin/widefov-render --list-projections |
  grep -v -e perspective -e direction-map |
  xargs -P 2 -I NAME bash Utilities/with-display.sh build/bin/widefov-bench --quick --frames 1 \
    --methods exact,auto --projection NAME "$@" --output output/errors/NAME.json
/usr/bin/python3 -B Testing/Benchmark/errors.py Documentation/benchmarks/errors.md output/errors/*.json
