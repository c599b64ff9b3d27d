#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The errors of every scene in every projection, at its widest, the perspective at 120 degrees, under
# every tolerance: writes the tables of Documentation/benchmarks/errors.md, from JSON files in output/errors.
#
#   bash Testing/Tools/Benchmark/errors.sh [--data FOLDER]
#
# Two projections at a time, some forty minutes on two cores, as many for the pictures of 8192 x 512, and
# hours for those of 8192 x 4096, which take 12 GB. Times are not looked at. Needs a build in build/.
# PROJECTIONS="hammer aitoff" measures these alone, and leaves the rows of others as they are.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

[ -x build/bin/widefov-bench ] ||
  { echo "errors.sh: there is no build/bin/widefov-bench; build the project first" >&2; exit 1; }

# half of the time of a large picture would go into its pages, one by one
export GLIBC_TUNABLES=glibc.malloc.hugetlb=1
mkdir -p output/errors
projections="${PROJECTIONS:-$(bash Utilities/with-display.sh build/bin/widefov-render --list-projections |
  grep -v -e direction-map)}"
round="azimuthal-equidistant azimuthal-equal-area stereographic orthographic gnomonic"

# measure PROJECTIONS PROCESSES FILE [OPTION...]: NAME stands for a projection
measure() {
  xargs -n 1 <<< "$1" | xargs -P "$2" -I NAME bash Utilities/with-display.sh \
    build/bin/widefov-bench --frames 1 --projection NAME --output "output/errors/$3" "${@:4}"
}
measure "$projections" 2 NAME.json --size 1024x512 --methods exact,auto "$@"
# as direction maps: faces that are torn apart, an oval, a disc
for name in $(xargs -n 1 <<< "$projections" | grep -x -e equi-angular-cubemap -e hammer -e azimuthal-equidistant || true); do
  measure "$name" 1 NAME-directions.json --size 1024x512 --as-direction-map --quick --methods exact "$@"
done
measure "$projections" 1 NAME-8192.json --size 8192x4096 --quick --methods exact,auto --tolerance 0.02 "$@"
# all scenes in four million pixels: as wide, or a circle that touches the nearer borders
for name in $projections; do
  [[ " $round " == *" $name "* ]] && echo "$name 2048x2048" || echo "$name 8192x512"
done | xargs -P 2 -L 1 bash -c 'bash Utilities/with-display.sh build/bin/widefov-bench --frames 1 \
  --projection "$2" --size "$3" --output "output/errors/$2-stretched.json" --quick \
  --methods exact,auto --tolerance 0.02 $1' errors.sh "$*"
/usr/bin/python3 -B Testing/Tools/Benchmark/errors.py Documentation/benchmarks/errors.md output/errors/*.json
