#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of the benchmark page from what was measured.

    tables.py PAGE.md BENCH.json TABLE1.json TURNING.json SMALL.json STEREO.json [--trial]

Replaces what stands between <!-- begin NAME --> and <!-- end NAME --> in the page: NAME is
environment, ratios, turning, small, stereo, runs and table1. --trial says on the page that the
machine was not quiet.
"""

import json
import re
import sys

TRIAL = (
    "> **A trial.** These figures were taken on a machine that others used at the same time, to show\n"
    "> that the machinery works. They are not results.\n\n"
)

# What the paper's table 1 says, frames a second: (projection, degrees, antialiased) to
# simple and complex scene.
PAPER = {
    ("perspective", 120, False): (948, 58),
    ("equirectangular", 120, False): (488, 42),
    ("equirectangular", 180, False): (449, 40),
    ("equirectangular", 270, False): (446, 40),
    ("equirectangular", 360, False): (459, 42),
    ("equirectangular", 360, True): (396, 36),
    ("hammer", 360, False): (476, 38),
    ("hammer", 360, True): (470, 39),
}


def number(value, digits=3):
    """As people read it; an en dash for what is not known."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    if abs(value) >= 1000:
        return format(round(value), ",")
    return "%.*g" % (digits, value)


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "| " + " | ".join("---" for _ in header) + " |"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def method_of(record):
    parameter = record["parameter"]
    return record["method"] + (" %g" % parameter if parameter is not None else "")


def environment_table(bench):
    e = bench["environment"]
    rows = [
        ["program", "VTKWideFoV " + e["version"]],
        ["VTK", e["vtk"]],
        ["OpenGL", "%s, %s" % (e["gl"]["renderer"], e["gl"]["version"])],
        ["rendering", "software" if e["software_rendering"] else "hardware"],
        ["processor", "%s, %d cores" % (e["processor"], e["cores"])],
        ["load of the machine before", number(e["load_before"])],
    ]
    return table(["", ""], rows)


def runs_table(bench):
    rows = []
    for r in bench["records"]:
        error = r["error"] or {}
        rows.append(
            [
                r["scene"],
                format(r["triangles"], ","),
                method_of(r),
                number(r["ms"]["median"]),
                "%s – %s" % (number(r["ms"]["min"]), number(r["ms"]["max"])),
                number(error.get("mismatched_pixels"), 6),
                number(error.get("unexplained")),
                number(error.get("b")),
                number(error.get("max_px")),
                number(error.get("p99_px")),
                number(error.get("max_depth_rel")),
                number(error.get("depth_px")),
                r.get("note", ""),
            ]
        )
    header = ["scene", "triangles", "method", "ms", "least – most", "wrong pixels", "unexplained"]
    return table(header + ["b, px", "max, px", "p99, px", "depth, relative", "depth, px", ""], rows)


def ratios_table(bench):
    rows = []
    for name, value in bench["summary"].items():
        text, scene = name.rsplit(", ", 1)
        reached = "not reached" if value is None else number(value)
        rows.append([scene, text, reached])
    return table(["scene", "ratio", "value"], rows)


def turning_text(turning):
    """What cameras that turn cost, by the cubemap of equal density."""
    first = turning["records"][0]
    ratio = re.compile(r"time (.*) / cubemap_(\d+) while turning, (.*)")
    found = [(ratio.fullmatch(name), value) for name, value in turning["summary"].items()]
    values = {m.group(3, 1): number(value) for m, value in found if m}
    faces = " or ".join(sorted({m.group(2) for m, _ in found if m}, key=int))
    scenes = dict.fromkeys(scene for scene, _ in values)
    rows = [[s] + [values.get((s, name), "–") for name in ("auto_0.25", "exact")] for s in scenes]
    size = "%dx%d" % tuple(first["size"])
    text = "%s, turned by %g° before each frame ([turning.json](turning.json)):\n\n"
    header = ["scene", "`auto` 0.25 / cubemap " + faces, "`exact` / cubemap " + faces]
    return text % (size, first["turn"]) + table(header, rows)


def small_text(small):
    """A million small triangles: methods by the floor."""
    records = small["records"]
    floor = {r["scene"]: r["ms"]["median"] for r in records if r["method"] == "floor"}
    rows = []
    for r in records:
        error = r["error"] or {}
        row = [r["scene"], format(r["triangles"], ","), method_of(r), number(r["ms"]["median"])]
        row += [number(r["ms"]["median"] / floor[r["scene"]]), number(error.get("max_px"))]
        rows.append(row)
    text = "%dx%d ([small.json](small.json)):\n\n" % tuple(records[0]["size"])
    return text + table(["scene", "triangles", "method", "ms", "method / floor", "max, px"], rows)


def stereo_text(stereo):
    """Both eyes by one picture without stereo: until drawn, and of all processors together."""
    records = stereo["records"]
    of = {(r["scene"], method_of(r)): r for r in records}
    pairs = [("stereo-omnidirectional", "auto 0.25"), ("stereo-omnidirectional", "exact")]
    pairs.append(("stereo-offaxis", "perspective"))
    rows = []
    for scene in dict.fromkeys(r["scene"] for r in records):
        for both, one in pairs:
            row = [scene, both, one]
            for key in ("ms", "processor_ms"):
                times = [of[scene, method][key]["median"] for method in (both, one)]
                row += [number(t) for t in (*times, times[0] / times[1])]
            rows.append(row)
    text = "%dx%d an eye ([stereo.json](stereo.json)):\n\n" % tuple(records[0]["size"])
    header = ["scene", "both eyes", "one picture", "both, ms", "one, ms", "both / one"]
    return text + table(header + ["both, processor ms", "one, processor ms", "both / one"], rows)


def paper_cells(record, frames):
    """What the paper has in this place, and what it is of its own perspective."""
    column = 0 if record["scene"] == "cornell" else 1
    key = (record["projection"], record["hfov"], record["samples"] > 1)
    theirs = PAPER.get(key)
    if theirs is None:
        return ["–", "–"]
    base = PAPER[("perspective", 120, False)][column]
    return [str(theirs[column]), number(theirs[column] / base)]


def table1_table(table1):
    base = {}
    for r in table1["records"]:
        if r["method"] == "perspective" and r["ms"]["median"] and r["samples"] <= 1:
            base[r["scene"]] = r["ms"]["median"]
    rows = []
    for r in table1["records"]:
        median = r["ms"]["median"]
        frames = 1000 / median if median else None
        share = base[r["scene"]] / median if median and r["scene"] in base else None
        row = [r["scene"], r["projection"], "%g" % r["hfov"], str(max(1, r["samples"]))]
        row += [method_of(r), number(frames), number(share)] + paper_cells(r, frames)
        rows.append(row)
    header = ["scene", "projection", "degrees", "samples", "method", "frames/s", "of perspective"]
    return table(header + ["the paper's frames/s", "of its perspective"], rows)


def replaced(page, name, text):
    marks = re.compile(r"(<!-- begin %s -->\n).*?(<!-- end %s -->)" % (name, name), re.S)
    if not marks.search(page):
        sys.exit("tables.py: the page has no place for " + name)
    return marks.sub(lambda match: match.group(1) + text + match.group(2), page)


def main():
    arguments = [a for a in sys.argv[1:] if a != "--trial"]
    if len(arguments) != 6:
        sys.exit(__doc__.strip().split("\n\n")[1].strip())
    with open(arguments[0], encoding="utf-8") as stream:
        page = stream.read()
    measured = [json.load(open(path, encoding="utf-8")) for path in arguments[1:]]
    bench, table1, turning, small, stereo = measured
    trial = TRIAL if "--trial" in sys.argv else ""
    page = replaced(page, "environment", trial + environment_table(bench))
    page = replaced(page, "ratios", ratios_table(bench))
    page = replaced(page, "turning", turning_text(turning))
    page = replaced(page, "small", small_text(small))
    page = replaced(page, "stereo", stereo_text(stereo))
    page = replaced(page, "runs", runs_table(bench))
    page = replaced(page, "table1", table1_table(table1))
    with open(arguments[0], "w", encoding="utf-8") as stream:
        stream.write(page)


if __name__ == "__main__":
    main()
