#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Checks pictures and measures times on the OpenGL driver of this machine, with nothing but an
# unpacked bundle (Utilities/bundle.sh, which holds this script as well) and a display:
#
#   xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" env __GLX_VENDOR_LIBRARY_NAME=nvidia \
#     bash check.sh BUNDLE RESULTS
#
#   bash check.sh --small BUNDLE RESULTS     small sizes and few tests, for software rendering
#
# BUNDLE may also be the bin/ of a build. Writes into the folder RESULTS as each step ends:
#   gl.json            the driver's names, beside what a first picture took
#   tests/*.json       comparison with the ray caster
#   stress.json        50,000 random primitives
#   pictures/*.png     each scene of widefov-render, with its times in *.json
#   bench-*.json       every scene while the camera turns, at each size and number of samples
#   summary.txt        a line a step: its exit code and its seconds
# and what each step said in *.log.
#
# Ends within six minutes: a step has a limit of its own and gets no more than is left of all.
# One that is cut has the exit code 124, and one for which nothing was left has 125.
# WIDEFOV_GPU_SECONDS=N sets another time for all of it.
# Exit code: 0 when every step passed, 1 when one did not, 2 for a wrong command line.
set -euo pipefail

small=no
if [ "${WIDEFOV_GPU_SMALL:-0}" != 0 ]; then
  echo "check.sh: WIDEFOV_GPU_SMALL is an old name; give --small" >&2
  small=yes
fi
if [ "${1:-}" = --small ]; then
  small=yes
  shift
fi
if [ "$#" -ne 2 ] || [ ! -x "$1/widefov-bench" ]; then
  echo "check.sh: name the folder of an unpacked bundle and one for the results, not: $*" >&2
  exit 2
fi
bundle="$(realpath "$1")"
mkdir -p "$2/tests" "$2/pictures"
out="$(realpath "$2")"
: > "$out/summary.txt"

# All times in seconds. With --small the limit of all is the only one: a busy machine takes long.
all=345
test_limit=100 stress_limit=90 picture_limit=60 bench_limit=45
primitives=50000
stress_projections=equirectangular,hammer,azimuthal-equidistant
picture_size=2048x1024
scenes=(cornell room atrium globe winds flow flow-large vector-cloud balls sphere office)
bench_scenes=cornell,room,atrium,office,flow-large,globe,vector-cloud,winds,balls
bench_sizes=(2048x1024 4096x2048)
bench_samples=(0 4 8) # 0 is one sample
bench_frames=11
if [ "$small" = yes ]; then
  all=840 test_limit=840 stress_limit=840 picture_limit=840 bench_limit=840
  primitives=100
  stress_projections=equirectangular
  picture_size=256x128
  scenes=(cornell room atrium globe balls sphere)
  bench_scenes=cornell,room
  bench_sizes=(256x128 512x256)
  bench_samples=(0 4)
  bench_frames=3
fi
all="${WIDEFOV_GPU_SECONDS:-$all}"
until="$all" # steps end by then
if [ "$small" = no ] && [ ! -f "$bundle/data/office.binary.vtk" ]; then
  echo "check.sh: without the scene office, whose data this bundle has not" >&2
  scenes=("${scenes[@]/office/}")
  bench_scenes="${bench_scenes/office,/}"
fi

# note NAME CODE SECONDS
note() {
  local what=""
  [ "$2" -ne 124 ] || what=" (cut)"
  [ "$2" -ne 125 ] || what=" (left out: no time is left)"
  echo "$1: exit code $2$what, $3 s" | tee -a "$out/summary.txt"
}

# step LIMIT NAME COMMAND...: runs it, notes what became of it.
step() {
  local limit="$1" name="$2" begin="$SECONDS" code=0
  shift 2
  [ "$limit" -le "$((until - SECONDS))" ] || limit="$((until - SECONDS))"
  if [ "$limit" -lt 1 ]; then
    note "$name" 125 0
    return
  fi
  timeout --kill-after=5 "$limit" "$@" > "$out/$name.log" 2>&1 || code=$?
  [ "$code" -ne 137 ] || code=124
  # (a filter that fits no test is no success)
  ! grep -q '^\[==========\] Running 0 tests' "$out/$name.log" || code=1
  note "$name" "$code" "$((SECONDS - begin))"
}

# beside STEP...: a step beside others, as many as there are processors.
beside() {
  while [ "$(jobs -rp | wc -l)" -ge "$processors" ]; do
    sleep 0.2
  done
  step "$@" &
}

# compare SUITE TESTS MAP...: of a suite of the comparison tests those, in each of the maps.
compare() {
  local suite="$1" tests="$2" map
  for map in "${@:3}"; do
    beside "$test_limit" "tests/$suite-$map" "$bundle/widefov-compare-tests" \
      "--gtest_filter=All/$suite.$tests/$map" "--gtest_output=json:$out/tests/$suite-$map.json"
  done
}

# The longest first, so that none is waited for at the end.
compare_all() {
  local maps=(equirectangular hammer azimuthal_equidistant) suite
  beside "$test_limit" gpu-math "$bundle/widefov-gpu-tests" "--gtest_output=json:$out/tests/gpu-math.json"
  for suite in CompareExact Mixed Watertight CompareStereoLines CompareLines; do
    compare "$suite" '*' "${maps[@]}"
  done
  # one map of what says less of a driver; what looks at the processor's work is left out
  for suite in Attributes CompareEdges CompareSampledLines CompareSampled; do
    compare "$suite" '*' equirectangular
  done
  for suite in CompareQuadrics CompareStereo CompareStereoQuadrics ComparePoints; do
    compare "$suite" '*' "${maps[@]}"
  done
}

# One short test a kind.
compare_few() {
  compare CompareExact RoomOfTwelve equirectangular
  compare Watertight TwelveTriangles equirectangular
  compare CompareLines Nasty equirectangular
  compare ComparePoints '*' equirectangular
  compare CompareQuadrics Sticks equirectangular
  compare CompareStereo Omnidirectional equirectangular
}

draw() {
  local scene input
  for scene in "${scenes[@]}"; do
    [ -n "$scene" ] || continue # taken out
    input=(--scene "$scene")
    # as the project's own picture of it
    [ "$scene" != office ] || input=("$bundle/data/office.binary.vtk" --streamlines vectors
      --vectors vectors --no-surface --no-scalar-bar --eye 2,2.2,1.4 --direction 1,0,0 --up 0,0,1
      --range 0,0.25 --colormap rainbow)
    beside "$picture_limit" "pictures/$scene" "$bundle/widefov-render" "${input[@]}" \
      --size "$picture_size" --frames 3 --stats "$out/pictures/$scene.json" \
      --output "$out/pictures/$scene.png"
  done
}

# bench NAME SIZE SAMPLES METHODS SCENES
bench() {
  local data=()
  [ ! -d "$bundle/data" ] || data=(--data "$bundle/data")
  step "$bench_limit" "bench-$1" "$bundle/widefov-bench" --quick --turn 1 --tolerance 0.25 \
    --frames "$bench_frames" --size "$2" --samples "$3" --methods "$4" --scenes "$5" \
    "${data[@]}" --output "$out/bench-$1.json"
}

trap 'kill $(jobs -p) 2> /dev/null; exit 1' INT TERM
step 30 gl "$bundle/widefov-render" --scene room --size 64x32 --frames 1 --stats "$out/gl.json" \
  --output "$out/pictures/gl.png"
# Pictures, side by side, in half of the time at most; nothing is timed meanwhile but the pictures themselves, roughly.
until="$((all / 2))"
processors="$(nproc)"
beside "$stress_limit" stress "$bundle/widefov-stress" --technique exact,auto --seed 1 \
  --primitives "$primitives" --projections "$stress_projections" --output "$out/stress.json"
if [ "$small" = yes ]; then
  compare_few
else
  compare_all
fi
draw
wait
until="$all"
# (exact and preclip take four fifths of the time of all, so they are timed once and at the end)
for size in "${bench_sizes[@]}"; do
  for samples in "${bench_samples[@]}"; do
    bench "$size-$samples" "$size" "$samples" auto,vertex,perspective,cubemap "$bench_scenes"
  done
done
bench stereo "${bench_sizes[0]}" 0 auto,stereo-omnidirectional,stereo-offaxis cornell,room
[ "$small" = yes ] ||
  bench exact "${bench_sizes[0]}" 0 exact,preclip cornell,room,atrium,globe,vector-cloud
! grep -qv 'exit code 0,' "$out/summary.txt"
