#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Small runs of widefov-bench and widefov-viewer of views that move: records, ratios, and what the page says of them.

    check_moving.py WIDEFOV-BENCH WIDEFOV-VIEWER
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile

from check_bench import PAGE, TOOLS, run

sys.path.append(TOOLS)
from tables import number  # noqa: E402

# Of views that move, with one sample and with four; the last has several alone.
MOVING = ["auto", "vertex", "perspective", "stereo-omnidirectional", "cubemap", "cubemap-ss"]
MODES = {"first": " of first frames", "turn": " while turning", "film": " in a film"}

# Modes and numbers of samples: each of them in some run.
RUNS = [("film", 4), ("first", 1), ("turn", 1)]

# What the page says of these runs.
NEEDED = ("| film | 4 |", "| turning | 1 |", "| first picture | 1 |", "| room | first picture |")
NEEDED += ("\n4 samples:\n\n", "A trial.", "256x128, medians of 2 frames")
NEEDED += ("Dragging in `widefov-viewer`, 256x128, default options, medians of 8 frames",)
NEEDED += ("[moving-film-4.json](moving-film-4.json)", "`auto` / cubemap-ss")


def moving_run(program, folder, mode, samples):
    methods = MOVING if samples > 1 else MOVING[:-1]
    several = str(samples if samples > 1 else 0)
    arguments = ["--quick", "--mode", mode, "--samples", several, "--tolerance", "0.25"]
    arguments += ["--scenes", "room", "--methods", ",".join(methods)]
    arguments += ["--size", "256x128", "--frames", "2"]
    return run(program, folder, "moving-%s-%d.json" % (mode, samples), arguments)


def moving_complaints(bench, mode, samples):
    """Every run moves, the very first frame compiles shaders, and ratios say what they are of."""
    for r in bench["records"]:
        name = "%s, %s, %d samples" % (r["method"], mode, samples)
        smooth = r["method"] == "cubemap-ss"
        if r["mode"] != mode or r["frames"] != 2 or not r["ms"]["median"] > 0:
            yield "%s: %s" % (name, r)
        if r["size"] != ([512, 256] if smooth else [256, 128]):
            yield "%s: size %s" % (name, r["size"])
        if r["samples"] != (0 if smooth or samples == 1 else samples):
            yield "%s: %d samples" % (name, r["samples"])
        if mode == "first" and not (r["first_ms"] or 0) > r["ms"]["median"]:
            yield "%s: the first frame took %s ms, a later one more" % (name, r["first_ms"])
        if mode != "first" and r["first_ms"] is not None:
            yield "%s: a first frame" % name
    end = MODES[mode] + (" with 4 samples" if samples > 1 else "") + ", room"
    ratios = ["auto_0.25 / vertex", "auto_0.25 / cubemap_82", "auto_0.25 / perspective"]
    ratios += ["stereo-omnidirectional / auto_0.25"]
    ratios += ["auto_0.25 / cubemap-ss_164"] if samples > 1 else []
    for ratio in ratios:
        if not bench["summary"].get("time " + ratio + end, 0) > 0:
            yield "no 'time %s%s'" % (ratio, end)


def drag_complaints(program, folder):
    """A short drag of the room, 16 frames in all."""
    path = os.path.join(folder, "dragging.json")
    command = [sys.executable, "-B", os.path.join(TOOLS, "dragging.py"), program, "--output", path]
    subprocess.run(command + ["--scenes", "room", "--size", "256x128", "--frames", "4"], check=True)
    with open(path, encoding="utf-8") as stream:
        document = json.load(stream)
    (record,) = document["records"]
    if record["scene"] != "room" or document["size"] != [256, 128] or document["frames"] != 8:
        yield "dragging: %s" % document
    ms = record["ms"]
    if not min(ms.values()) > 0 or record["ratio"] != ms["wide"] / ms["perspective"]:
        yield "dragging: %s" % record


def row_of(bench):
    """The page's ratios of the film with four samples, by those of the program."""
    ratios = ["auto_0.25 / vertex", "auto_0.25 / cubemap_82", "auto_0.25 / perspective"]
    ratios += ["stereo-omnidirectional / auto_0.25", "auto_0.25 / cubemap-ss_164"]
    names = ["time %s in a film with 4 samples, room" % r for r in ratios]
    return "\n| room | film | " + " | ".join(number(bench["summary"][n]) for n in names) + " | "


def page_complaints(folder, film):
    page = os.path.join(folder, "page.md")
    shutil.copy(PAGE, page)
    files = [os.path.join(folder, "moving-%s-%d.json" % row) for row in RUNS]
    files.append(os.path.join(folder, "dragging.json"))
    command = [sys.executable, "-B", os.path.join(TOOLS, "moving.py"), page] + files + ["--trial"]
    subprocess.run(command, check=True)
    with open(page, encoding="utf-8") as stream:
        text = stream.read()
    for needed in NEEDED + (row_of(film),):
        if needed not in text:
            yield "the page does not have '%s'" % needed


def main():
    found, benches = [], {}
    with tempfile.TemporaryDirectory() as folder:
        for mode, samples in RUNS:
            bench = benches[mode] = moving_run(sys.argv[1], folder, mode, samples)
            found += list(moving_complaints(bench, mode, samples))
        found += list(drag_complaints(sys.argv[2], folder))
        found += list(page_complaints(folder, benches["film"]))
    print("\n".join(found) if found else "moving: nothing to complain about")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
