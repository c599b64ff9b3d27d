#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Where the time of a scene of the benchmark goes, by perf's samples: shares of all that is drawing.
#
#   bash Testing/Tools/Benchmark/profile.sh [--standing] SCENE METHOD [FRAMES [OPTION OF WIDEFOV-BENCH...]]
#   for example: profile.sh office auto 300
#
# --standing  milliseconds of processor time in a frame instead, of a view that stands: what FRAMES
#             frames take more than the first fifteen
#
# Needs perf (Debian: linux-perf), software rendering by llvmpipe, and a build in build/. What the
# benchmark does for itself (scenes, rays that are cast) is left out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

fail() {
  echo "profile.sh: $2" >&2
  exit "$1"
}

standing=
if [ "${1:-}" = --standing ]; then
  standing=yes
  shift
fi
[ "$#" -ge 2 ] || fail 2 "name a scene and a method"
scene="$1" method="$2" frames="${3:-300}"
[[ "$frames" =~ ^[1-9][0-9]*$ ]] || fail 2 "a number of frames, not: $frames"
settled=15 # more than it takes until nothing is made or classified anew
[ -z "$standing" ] || [ "$frames" -gt "$settled" ] || fail 2 "--standing needs more than $settled frames"
command -v perf > /dev/null || fail 2 "there is no perf; install linux-perf"
[ -x build/bin/widefov-bench ] || fail 1 "there is no build/bin/widefov-bench; build the project first"

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
rate=500 # samples a second

# samples FRAMES [OPTION...]: SAMPLES|PART for each part of the work
samples() {
  bash Utilities/with-display.sh perf record --quiet --freq "$rate" --output "$folder/perf.data" \
    build/bin/widefov-bench --quick --scenes "$scene" --methods "$method" --frames "$1" \
    "${@:2}" --output "$folder/bench.json" > "$folder/log" 2>&1 ||
    fail 1 "the benchmark failed: $(tail -n 1 "$folder/log")"
  perf report --input "$folder/perf.data" --sort comm,dso --fields sample,comm,dso \
    --field-separator '|' 2> /dev/null |
    awk -F '|' '
      /^ *#/ || NF < 3 { next }
      $2 ~ /llvmpipe/ { part = $3 ~ /JIT/ ? "fragment programs" : "rasterization" }
      $2 !~ /llvmpipe/ && ($3 ~ /widefov-bench/ || $2 !~ /widefov-bench/) { next }
      $2 !~ /llvmpipe/ {
        part = $3 ~ /JIT/ ? "vertex and geometry programs" : $3 ~ /dri/ ? "vertices and set-up" \
          : $3 ~ /WideFoV/ ? "the module" : "everything else"
      }
      { sum[part] += $1 }
      END { for (part in sum) print sum[part] "|" part }'
}

all="$(samples "$frames" "${@:4}")"
[ -z "$standing" ] || first="$(samples "$settled" "${@:4}")"
echo "$scene, $method"
if [ -n "$standing" ]; then
  printf '%s\n--\n%s\n' "$first" "$all" | awk -F '|' -v n="$((frames - settled))" -v rate="$rate" '
    /^--$/ { later = 1; next }
    !later { before[$2] = $1; next }
    { ms = 1000 * ($1 - before[$2]) / rate / n; sum += ms; printf "%7.1f ms  %s\n", ms, $2 }
    END { printf "%7.1f ms  all\n", sum }' | sort -k 1,1 -rn
else
  printf '%s\n' "$all" | awk -F '|' '
    { part[$2] = $1; sum += $1 }
    END { for (name in part) printf "%5.1f %%  %s\n", 100 * part[name] / sum, name }' |
    sort -k 1,1 -rn
fi
