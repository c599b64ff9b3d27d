#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs widefov-bench-scale small and checks what it writes; no times.

    check_scale.py WIDEFOV-BENCH-SCALE
"""

import json
import os
import subprocess
import sys
import tempfile

PROPS = 60
TRIANGLES = 4000
FRAMES = 3
# Which runs each group has; the first is what the others are compared with.
GROUPS = {
    ("props_moving",): ("stock", "pass", "own"),
    ("props_still",): ("stock", "pass", "own"),
    ("fields", "mesh"): ("360", "120"),
    ("fields", "props"): ("360", "120"),
    ("arrows",): ("perspective", "dome", "dome-vertex"),
}


def check(right, what):
    if not right:
        sys.exit("check_scale.py: " + what)


def check_group(path, runs, names):
    where = "/".join(path)
    check(set(runs) == set(names), "%s has %s" % (where, sorted(runs)))
    for name in names:
        times = runs[name]["ms"]
        check(0 < times["min"] <= times["median"] <= times["max"], "%s %s" % (where, times))
        ratio = times["median"] / runs[names[0]]["ms"]["median"]
        check(abs(runs[name]["ratio"] / ratio - 1) < 1e-9, "%s: ratio of %s" % (where, name))


def check_file(result):
    check(result["environment"]["gl"]["renderer"], "no renderer is named")
    for path, names in GROUPS.items():
        runs = result
        for key in path:
            runs = runs[key]
        check_group(path, runs, names)
    check(result["props_still"]["pass"]["culled_props"] == 0, "all round, props are left out")
    check(result["fields"]["props"]["120"]["culled_props"] > 0, "no prop is left out")
    memory = result["memory"]
    check(memory["triangles"] == TRIANGLES, "other triangles were weighed")
    for way in ("stock", "wide"):
        weighed = memory[way]
        check(0 < weighed["data_mb"] <= weighed["peak_mb"], "%s: %s" % (way, weighed))
        check(0 < weighed["still_mb"] <= weighed["peak_mb"], "%s: %s" % (way, weighed))
    for key in ("peak", "still"):
        ratio = memory["wide"][key + "_mb"] / memory["stock"][key + "_mb"]
        check(abs(memory[key + "_ratio"] / ratio - 1) < 1e-9, "ratio of " + key)


def main(program):
    with tempfile.TemporaryDirectory(prefix="scale-") as folder:
        name = os.path.join(folder, "scale.json")
        sizes = ["--props", PROPS, "--triangles", TRIANGLES, "--frames", FRAMES]
        command = [program, "--output", name] + [str(word) for word in sizes]
        subprocess.run(command, check=True)
        with open(name, encoding="utf-8") as stream:
            check_file(json.load(stream))
    nothing = subprocess.run([program], stderr=subprocess.PIPE, check=False)
    lines = nothing.stderr.decode().splitlines()
    check(nothing.returncode == 2 and len(lines) == 1, "without --output: %s" % lines)
    check(lines[0].startswith("widefov-bench-scale: "), lines[0])


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]))
