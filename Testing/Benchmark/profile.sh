#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Where the time of a scene of the benchmark goes, by perf's samples: shares of all that is drawing.
#
#   bash Testing/Benchmark/profile.sh SCENE METHOD [FRAMES [OPTION OF WIDEFOV-BENCH...]]
#   for example: profile.sh office auto 300
#
# Needs perf (Debian: linux-perf), software rendering by llvmpipe, and a build in build/. What the
# benchmark does for itself (scenes, rays that are cast) is left out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

[ "$#" -ge 2 ] || { echo "profile.sh: name a scene and a method" >&2; exit 2; }
command -v perf > /dev/null || { echo "profile.sh: there is no perf; install linux-perf" >&2; exit 2; }

[ -x build/bin/widefov-bench ] ||
  { echo "profile.sh: there is no build/bin/widefov-bench; build the project first" >&2; exit 1; }

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

bash Utilities/with-display.sh perf record --quiet --freq 500 --output "$folder/perf.data" \
  build/bin/widefov-bench --quick --scenes "$1" --methods "$2" --frames "${3:-300}" \
  "${@:4}" --output "$folder/bench.json" > "$folder/log" 2>&1 ||
  { echo "profile.sh: the benchmark failed: $(tail -n 1 "$folder/log")" >&2; exit 1; }

echo "$1, $2"
perf report --input "$folder/perf.data" --sort comm,dso --field-separator '|' 2> /dev/null |
  awk -F '|' '
    /^ *#/ || NF < 3 { next }
    { share = $1 + 0 }
    $2 ~ /llvmpipe/ { part = $3 ~ /JIT/ ? "fragment programs" : "rasterization" }
    $2 !~ /llvmpipe/ && $3 ~ /widefov-bench/ { next }
    $2 !~ /llvmpipe/ {
      part = $3 ~ /JIT/ ? "vertex and geometry programs" : $3 ~ /dri/ ? "vertices and set-up" \
        : $3 ~ /WideFoV/ ? "the module" : "everything else"
    }
    { sum[part] += share; all += share }
    END {
      for (part in sum) printf "%5.1f %%  %s\n", 100 * sum[part] / all, part
    }' | sort -k 1,1 -rn
