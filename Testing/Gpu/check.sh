#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Checks pictures and measures times on the OpenGL driver of this machine, with nothing but an
# unpacked bundle (Utilities/bundle.sh) and a display, for example
#
#   xvfb-run -a env __GLX_VENDOR_LIBRARY_NAME=nvidia \
#     bash Testing/Gpu/check.sh widefov-0.1.0-x86_64 output/gpu
#
# Writes into the second folder: gl.txt (the driver's names), tests/*.json and .log (comparison
# with the ray caster), stress.json, bench-*.json, and summary.txt, a line a step with its exit
# code and its seconds. WIDEFOV_GPU_SMALL=1 takes smaller sizes, for software rendering.
#
# Exit code: 0 when every step passed, 1 when one did not, 2 for a wrong command line.
set -euo pipefail

if [ "$#" -ne 2 ] || [ ! -x "$1/bin/widefov-bench" ]; then
  echo "check.sh: name the folder of an unpacked bundle and one for the results, not: $*" >&2
  exit 2
fi
bundle="$(realpath "$1")"
mkdir -p "$2/tests"
out="$(realpath "$2")"
: > "$out/summary.txt"
failed=0
export WIDEFOV_DATA_DIR="$bundle/data"

# step SECONDS NAME COMMAND...: runs it, notes what became of it.
step() {
  local limit="$1" name="$2" begin code=0
  shift 2
  begin="$(date +%s)"
  timeout "$limit" "$@" > "$out/$name.log" 2>&1 || code=$?
  echo "$name: exit code $code, $(($(date +%s) - begin)) s" | tee -a "$out/summary.txt"
  [ "$code" -eq 0 ] || failed=1
}

# compare FILTER NAME: some of the comparison tests.
compare() {
  step 150 "tests/$2" "$bundle/bin/widefov-compare-tests" "--gtest_filter=$1" \
    "--gtest_output=json:$out/tests/$2.json"
  # (a filter that fits no test is no success)
  ! grep -q 'Running 0 tests' "$out/tests/$2.log" ||
    echo "tests/$2: exit code 1, no such test" | tee -a "$out/summary.txt"
}

# Pictures first, side by side as many as there are processors; nothing is timed meanwhile.
suites=(CompareExact Watertight CompareLines CompareStereoLines CompareSampledLines ComparePoints
  CompareSampledPoints CompareQuadrics CompareStereoQuadrics CompareStereo CompareSampled
  CompareEdges Tessellate Attributes Mixed)
maps=(equirectangular hammer azimuthal_equidistant)
[ "${WIDEFOV_GPU_SMALL:-0}" = 0 ] || maps=(equirectangular)
jobs_at_once="$(nproc)"
for suite in "${suites[@]}"; do
  for map in "${maps[@]}"; do
    while [ "$(jobs -rp | wc -l)" -ge "$jobs_at_once" ]; do
      sleep 0.2
    done
    compare "All/$suite.*/$map" "$suite-$map" &
  done
done
compare "Disparity.*:CompareScreens.*:All/Order.*:Plain.*:Fold.*" others &
step 60 gpu-math "$bundle/bin/widefov-gpu-tests" &
step 150 stress "$bundle/bin/widefov-stress" --technique exact,auto --primitives 50000 --seed 1 \
  --projections equirectangular,hammer,azimuthal-equidistant --output "$out/stress.json" &
wait
# (what ran in the background could not set the variable)
! grep -qv 'exit code 0,' "$out/summary.txt" || failed=1

scenes=cornell,room,atrium,office,flow-large,globe,vector-cloud,winds,balls
sizes=(2048x1024 4096x2048)
samples=(0 4 8)
if [ "${WIDEFOV_GPU_SMALL:-0}" != 0 ]; then
  scenes=cornell,atrium
  sizes=(512x256)
  samples=(0 4)
fi
for size in "${sizes[@]}"; do
  for n in "${samples[@]}"; do
    step 100 "bench-$size-$n" "$bundle/bin/widefov-bench" --quick --size "$size" --samples "$n" \
      --turn 1 --tolerance 0.25 --frames 11 --scenes "$scenes" \
      --methods auto,exact,preclip,vertex,perspective,cubemap --data "$bundle/data" \
      --output "$out/bench-$size-$n.json"
  done
done
# Both eyes, of two models.
step 60 bench-stereo "$bundle/bin/widefov-bench" --quick --size "${sizes[0]}" --turn 1 \
  --frames 11 --scenes cornell,atrium --methods auto,stereo-omnidirectional,stereo-offaxis \
  --tolerance 0.25 --output "$out/bench-stereo.json"
for file in "$out"/bench-*.json; do
  sed -n '/"gl": {/,/}/p' "$file"
done > "$out/gl.txt"
exit "$failed"
