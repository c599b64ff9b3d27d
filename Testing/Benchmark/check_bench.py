#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One small run of widefov-bench: its file is what the contract says, its errors tell right
from wrong, and the scripts read it.

    check_bench.py WIDEFOV-BENCH
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
TOOLS = os.path.join(HERE, "..", "Tools", "Benchmark")
PAGE = os.path.join(HERE, "..", "..", "Documentation", "benchmarks", "README.md")

RECORD = {"scene", "triangles", "projection", "hfov", "size", "method", "parameter", "ms"}
RECORD |= {"processor_ms", "frames", "first_ms", "mode", "samples", "error"}
ERROR = {"unexplained", "missing", "spurious", "max_px", "p99_px", "max_depth_rel"}
METHODS = {"auto", "exact", "preclip", "vertex", "cubemap", "perspective", "floor"}

TURNING = {"auto", "exact", "preclip", "vertex", "cubemap", "perspective"}
TURN = 12.5

PIXELS = 256 * 128

# What the page says of these runs.
NEEDED = ("| room | 12 | exact |", "| cornell | hammer | 360 | 4 |", "A trial.")
NEEDED += ("256x128, turned by 12.5° before each frame", "`exact` / cubemap 82 |\n")
NEEDED += ("256x128 an eye", "| room | stereo-offaxis |")


def run(program, folder, name, arguments):
    path = os.path.join(folder, name)
    subprocess.run([program, "--output", path] + arguments, check=True)
    with open(path, encoding="utf-8") as stream:
        return json.load(stream)


def schema_complaints(bench):
    for name in ("environment", "records", "summary"):
        if name not in bench:
            yield "no '%s'" % name
    methods = {r["method"] for r in bench["records"]}
    if methods != METHODS:
        yield "methods %s" % sorted(methods)
    for r in bench["records"]:
        if not RECORD <= set(r):
            yield "a record lacks %s" % sorted(RECORD - set(r))
        if r["error"] is not None and not ERROR <= set(r["error"]):
            yield "an error lacks %s" % sorted(ERROR - set(r["error"]))
    if not any(name.startswith("time auto_0.25 / floor") for name in bench["summary"]):
        yield "no ratio of auto and floor"


def sense_complaints(bench):
    """What is known of the room from anywhere."""
    wrong = {}
    for r in bench["records"]:
        if r["triangles"] != 12 or r["size"] != [256, 128]:
            yield "%s has %d triangles, size %s" % (r["method"], r["triangles"], r["size"])
        if r["error"]:
            wrong[r["method"]] = r["error"]["mismatched_pixels"]
        if r["method"] == "floor" and abs(r["covered"] - PIXELS) > 0.01 * PIXELS:
            yield "the floor covers %d pixels" % r["covered"]
    if wrong["exact"] > 4:
        yield "exact has %d wrong pixels" % wrong["exact"]
    if not 20 < wrong["cubemap"] < 0.05 * PIXELS:
        yield "the cubemap, turned the right way, has %d wrong pixels" % wrong["cubemap"]
    if wrong["vertex"] < 0.5 * PIXELS:
        yield "the vertices alone have only %d wrong pixels" % wrong["vertex"]


def turning_complaints(still, turning):
    """Cameras that turn: what is measured of them, and what is not."""
    for r in still["records"]:
        if "turn" in r or r["mode"] != "still" or r["first_ms"] is not None:
            yield "a record of a camera that stands: %s" % r
    if {r["method"] for r in turning["records"]} != TURNING:
        yield "methods while turning: %s" % [r["method"] for r in turning["records"]]
    for r in turning["records"]:
        if r.get("turn") != TURN or r["mode"] != "turn" or r["first_ms"] or r["error"] is not None or r["covered"] is not None:
            yield "a record of a camera that turns: %s" % r
        if r["frames"] != 2 or not min(r[k]["median"] for k in ("ms", "processor_ms")) > 0:
            yield "%s while turning: no times" % r["method"]
    names = ["time %s / cubemap_82 while turning, room" % m for m in ("auto_0.25", "exact")]
    for name in names:
        if not turning["summary"].get(name, 0) > 0:
            yield "no '%s'" % name
    if any(" while turning, " not in name for name in turning["summary"]):
        yield "ratios that do not say that the camera turns: %s" % list(turning["summary"])


def script_complaints(folder):
    bench = os.path.join(folder, "bench.json")
    table1 = os.path.join(folder, "table1.json")
    turning = os.path.join(folder, "turning.json")
    stereo = os.path.join(folder, "stereo.json")
    page = os.path.join(folder, "page.md")
    shutil.copy(PAGE, page)
    for command in (
        [os.path.join(TOOLS, "tables.py"), page, bench, table1, turning, bench, stereo, "--trial"],
        [os.path.join(TOOLS, "plot.py"), bench, folder],
    ):
        subprocess.run([sys.executable, "-B"] + command, check=True)
    if os.path.getsize(os.path.join(folder, "room.svg")) < 10000:
        yield "the plot is empty"
    with open(page, encoding="utf-8") as stream:
        text = stream.read()
    for needed in NEEDED:
        if needed not in text:
            yield "the page does not have '%s'" % needed


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        small = ["--size", "256x128", "--frames", "2"]
        bench = run(program, folder, "bench.json", ["--quick", "--scenes", "room"] + small)
        run(program, folder, "table1.json", ["--table1", "--scenes", "cornell"] + small)
        turn = ["--turn", str(TURN), "--quick", "--scenes", "room"]
        turning = run(program, folder, "turning.json", turn + small)
        eyes = "auto,exact,perspective,stereo-omnidirectional,stereo-offaxis"
        run(program, folder, "stereo.json", ["--quick", "--scenes", "room", "--methods", eyes] + small)
        found = list(turning_complaints(bench, turning))
        found += list(schema_complaints(bench)) + list(sense_complaints(bench))
        found += list(script_complaints(folder))
    print("\n".join(found) if found else "bench: nothing to complain about")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
