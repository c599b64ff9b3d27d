#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what views that move cost to the benchmark page.

    moving.py PAGE.md BENCH.json... [DRAGGING.json] [--trial]

Every file of widefov-bench is of one mode (first, turn or film) and one number of samples; that of
dragging.py is told by its times of "wide". Replaces what stands
between <!-- begin moving --> and <!-- end moving --> in the page. --trial says on the page that the
machine was not quiet.
"""

import json
import os
import sys

from tables import TRIAL, number, replaced, table

MODES = {"first": "first picture", "turn": "turning", "film": "film"}

# Ratios: the heading, the first, and beside what; several samples have the last of them too.
RATIOS = [
    ("`auto` / `vertex`", "auto", "vertex"),
    ("`auto` / cubemap", "auto", "cubemap"),
    ("`auto` / perspective", "auto", "perspective"),
    ("both eyes / one", "stereo-omnidirectional", "auto"),
    ("`auto` / cubemap-ss", "auto", "cubemap-ss"),
]
TIMED = ["auto", "vertex", "cubemap", "perspective", "stereo-omnidirectional", "cubemap-ss"]


def read(path):
    with open(path, encoding="utf-8") as stream:
        return json.load(stream)


class Timings:
    """One file: what every scene and method took."""

    def __init__(self, path):
        self.bench = read(path)
        self.name = os.path.basename(path)
        records = self.bench["records"]
        self.mode = records[0]["mode"]
        # cubemap-ss has none of its own, whatever it stands beside
        self.samples = max(1, *(r["samples"] for r in records))
        self.of = {(r["scene"], r["method"]): r for r in records}
        self.scenes = list(dict.fromkeys(r["scene"] for r in records))
        self.size = next(r["size"] for r in records if r["method"] != "cubemap-ss")

    def ms(self, scene, method):
        record = self.of.get((scene, method))
        return record["ms"]["median"] if record else None

    def ratio(self, scene, a, b):
        top, bottom = self.ms(scene, a), self.ms(scene, b)
        return top / bottom if top and bottom else None


def columns_of(samples, columns):
    return columns if samples > 1 else columns[:-1]


def samples_text(samples):
    return "%d sample%s" % (samples, "s" if samples > 1 else "")


def spread(timings, a, b):
    """The least and the most of all scenes, and which scene that is."""
    found = [(timings.ratio(s, a, b), s) for s in timings.scenes if timings.ratio(s, a, b)]
    if not found:
        return "–"
    return "%s – %s (%s)" % (number(min(found)[0]), number(max(found)[0]), max(found)[1])


def overview(measured):
    rows = []
    for t in measured:
        row = [MODES[t.mode], str(t.samples)]
        rows.append(row + [spread(t, a, b) for _, a, b in RATIOS])
    return table(["", "samples"] + [heading for heading, _, _ in RATIOS], rows)


def times_table(measured, samples):
    """Ratios and milliseconds of every scene, with so many samples."""
    files = [t for t in measured if t.samples == samples]
    ratios, timed = columns_of(samples, RATIOS), columns_of(samples, TIMED)
    rows = []
    for scene in dict.fromkeys(s for t in files for s in t.scenes):
        for t in files:
            row = [scene, MODES[t.mode]]
            row += [number(t.ratio(scene, a, b)) for _, a, b in ratios]
            rows.append(row + [number(t.ms(scene, method)) for method in timed])
    header = ["scene", ""] + [heading for heading, _, _ in ratios]
    return table(header + [method + ", ms" for method in timed], rows)


def very_first_table(measured):
    """First frames of new windows: milliseconds by samples."""
    rows = []
    for t in measured:
        for scene in t.scenes if t.mode == "first" else []:
            records = [t.of.get((scene, method)) for method in TIMED]
            ms = [number(r["first_ms"] if r else None) for r in records]
            rows.append([scene, str(t.samples)] + ms)
    return table(["scene", "samples"] + [method + ", ms" for method in TIMED], rows)


def machine_text(measured):
    e = measured[0].bench["environment"]
    links = ", ".join("[%s](%s)" % (t.name, t.name) for t in measured)
    frames = next(iter(measured[0].of.values()))["frames"]
    text = "%dx%d" % tuple(measured[0].size) + ", medians of %d frames; %s, %s, %d cores, load %s: %s."
    values = (frames, e["gl"]["renderer"], e["processor"], e["cores"], number(e["load_before"]), links)
    return text % values + "\n\n"


def dragging_text(dragged):
    """What the viewer's user sees, beside the same in perspective."""
    if not dragged:
        return ""
    rows = []
    for r in dragged["records"]:
        ms = r["ms"]
        rows.append([r["scene"], number(ms["wide"]), number(ms["perspective"]), number(r["ratio"])])
    text = "\nDragging in `widefov-viewer`, %dx%d, default options, medians of %d frames ([%s](%s)):\n\n"
    text %= (*dragged["size"], dragged["frames"], dragged["name"], dragged["name"])
    return text + table(["scene", "ms", "perspective, ms", "ratio"], rows)


def is_of_dragging(path):
    return "wide" in read(path)["records"][0]["ms"]


def moving_text(measured):
    text = machine_text(measured) + overview(measured)
    for samples in sorted({t.samples for t in measured}):
        text += "\n%s:\n\n" % samples_text(samples).capitalize() + times_table(measured, samples)
    return text + "\nThe very first frame of a new window:\n\n" + very_first_table(measured)


def main():
    arguments = [a for a in sys.argv[1:] if a != "--trial"]
    if len(arguments) < 2:
        sys.exit(__doc__.strip().split("\n\n")[1].strip())
    with open(arguments[0], encoding="utf-8") as stream:
        page = stream.read()
    drags = [path for path in arguments[1:] if is_of_dragging(path)]
    measured = [Timings(path) for path in arguments[1:] if path not in drags]
    order = list(MODES)
    measured.sort(key=lambda t: (t.samples, order.index(t.mode)))
    trial = TRIAL if "--trial" in sys.argv else ""
    dragged = dict(read(drags[0]), name=os.path.basename(drags[0])) if drags else None
    page = replaced(page, "moving", trial + moving_text(measured) + dragging_text(dragged))
    with open(arguments[0], "w", encoding="utf-8") as stream:
        stream.write(page)


if __name__ == "__main__":
    main()
