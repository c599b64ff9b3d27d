#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Every figure of Documentation/benchmarks/README.md: builds, measures, draws the plots and writes
# the tables.
#
#   bash Testing/Tools/Benchmark/run.sh --moving [--size WxH] [--frames N] [OPTION...]
#   bash Testing/Tools/Benchmark/run.sh [--quick] [OPTION...]
#
# OPTION: [--trial] [--data FOLDER] [--scenes A,B,..] [--page FOLDER]
#
# --moving  what the page leads with, first pictures, turning and films, and nothing else: with one
#           and with four samples at 2048x1024, nine frames a run, about an hour on two cores; and
#           dragging in the viewer, at 1024x512. Without it the views that stand, and what goes with
#           them
# --size    of moving views, pixels
# --frames  of moving views, a run
# --quick   every scene at 1024x512 with few parameters, more than a quarter of an hour on two cores
# --trial   says on the page that the machine was not quiet
# --data    where office.binary.vtk is (../shared/data beside the checkout)
# --scenes  these alone
# --page    writes a copy of the page there instead
set -euo pipefail
exec < /dev/null

step="reading the command line"
trap 'code=$?; [ "$code" -eq 0 ] || echo "Testing/Tools/Benchmark/run.sh: FAILED while $step (exit code $code)" >&2' EXIT

quick=()
few=()
moving=
size=
frames=
trial=()
data=()
scenes=()
page=Documentation/benchmarks
while [ "$#" -gt 0 ]; do
  case "$1" in
    --quick)
      quick=(--quick)
      few=(--frames 5) # of table 1, whose 22 runs a scene would take three minutes
      ;;
    --moving) moving=yes ;;
    --size)
      [ "$#" -gt 1 ] || { echo "Testing/Tools/Benchmark/run.sh: --size needs WxH" >&2; exit 2; }
      size="$2"
      shift
      ;;
    --frames)
      [ "$#" -gt 1 ] || { echo "Testing/Tools/Benchmark/run.sh: --frames needs a number" >&2; exit 2; }
      frames="$2"
      shift
      ;;
    --trial) trial=(--trial) ;;
    --data)
      [ "$#" -gt 1 ] || { echo "Testing/Tools/Benchmark/run.sh: --data needs a folder" >&2; exit 2; }
      data=(--data "$(realpath "$2")")
      shift
      ;;
    --scenes)
      [ "$#" -gt 1 ] || { echo "Testing/Tools/Benchmark/run.sh: --scenes needs names" >&2; exit 2; }
      scenes=(--scenes "$2")
      shift
      ;;
    --page)
      [ "$#" -gt 1 ] || { echo "Testing/Tools/Benchmark/run.sh: --page needs a folder" >&2; exit 2; }
      page=$(realpath "$2")
      shift
      ;;
    *)
      echo "Testing/Tools/Benchmark/run.sh: --moving, --size WxH, --frames N, --quick, --trial, --data FOLDER, --scenes A,B,.. or --page FOLDER, not: $1" >&2
      exit 2
      ;;
  esac
  shift
done

if [ -n "$moving" ] && [ -n "${quick[*]-}" ]; then
  echo "Testing/Tools/Benchmark/run.sh: --quick is of views that stand; leave it out, or --moving" >&2
  exit 2
fi
if [ -z "$moving" ] && [ -n "$size$frames" ]; then
  echo "Testing/Tools/Benchmark/run.sh: --size and --frames are of views that move; give --moving, or leave them out" >&2
  exit 2
fi

cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

step="installing packages"
bash Utilities/install-packages.sh build examples test

step=building
[ -f build/build.ninja ] || cmake --preset default
cmake -DWIDEFOV_BUILD_TESTING=ON -DWIDEFOV_BUILD_PROGRAMS=ON build > /dev/null
targets=(widefov-bench)
[ -z "$moving" ] || targets+=(widefov-viewer)
cmake --build build --target "${targets[@]}"

step=measuring
mkdir -p output "$page"
measure() { # FILE.json OPTION...: the scenes that were asked for
  bash Utilities/with-display.sh build/bin/widefov-bench --output "output/$1" "${@:2}" \
    ${scenes[@]+"${scenes[@]}"} ${data[@]+"${data[@]}"}
}
publish() { # FILE.json...: on the page, without the places of pixels that differ
  /usr/bin/python3 -B Testing/Tools/Benchmark/publish.py "$page" "${@/#/output/}"
}
have_page() { # a copy of it, where another folder was asked for
  [ -f "$page/README.md" ] || cp Documentation/benchmarks/README.md "$page/"
}
measure_moving() { # one run for each mode and number of samples
  local mode n methods files=()
  for n in 1 4; do
    methods=auto,vertex,perspective,stereo-omnidirectional,cubemap
    [ "$n" -eq 1 ] || methods+=,cubemap-ss
    for mode in first turn film; do
      measure "moving-$mode-$n.json" --quick --mode "$mode" --samples "$((n > 1 ? n : 0))" --tolerance 0.25 \
        --methods "$methods" --size "${size:-2048x1024}" --frames "${frames:-9}"
      files+=("moving-$mode-$n.json")
    done
  done
  step=dragging
  local drags=(--frames "${frames:-15}") # of scenes of its own: the viewer has not all
  [ -z "$size" ] || drags+=(--size "$size")
  /usr/bin/python3 -B Testing/Tools/Benchmark/dragging.py build/bin/widefov-viewer \
    --output output/dragging.json "${drags[@]}"
  files+=(dragging.json)
  step=writing
  publish "${files[@]}"
  have_page
  /usr/bin/python3 -B Testing/Tools/Benchmark/moving.py "$page/README.md" "${files[@]/#/$page/}" \
    ${trial[@]+"${trial[@]}"}
}
if [ -n "$moving" ]; then
  measure_moving
  echo "Written: $page"
  exit 0
fi
measure benchmark.json ${quick[@]+"${quick[@]}"}
measure table1.json --table1 ${few[@]+"${few[@]}"}
measure turning.json --quick --turn 1 --methods auto,exact,cubemap
bash Utilities/with-display.sh build/bin/widefov-bench --output output/small.json --frames 9 \
  --scenes balls,balls-apart --size 2048x1024 --methods auto,vertex,floor
eyes=(--scenes atrium,flow-large)
[ "${#scenes[@]}" -eq 0 ] || eyes=("${scenes[@]}")
bash Utilities/with-display.sh build/bin/widefov-bench --output output/stereo.json --quick --frames 15 \
  "${eyes[@]}" ${data[@]+"${data[@]}"} --methods auto,exact,perspective,stereo-omnidirectional,stereo-offaxis

step=writing
publish benchmark.json table1.json turning.json small.json stereo.json
have_page
/usr/bin/python3 -B Testing/Tools/Benchmark/plot.py "$page/benchmark.json" "$page"
/usr/bin/python3 -B Testing/Tools/Benchmark/tables.py "$page/README.md" "$page/benchmark.json" \
  "$page/table1.json" "$page/turning.json" "$page/small.json" \
  "$page/stereo.json" ${trial[@]+"${trial[@]}"}
echo "Written: $page"
