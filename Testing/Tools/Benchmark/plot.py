#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws run time against error.

    plot.py BENCH.json FOLDER

One picture a scene, FOLDER/SCENE.svg: on the left the largest distance from a wrong pixel
to where it would be right, on the right the share of wrong pixels; the cubemap is the
rival. What has no error is drawn at the left edge, at an error that is below all others.
"""

import json
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)

# method: label, colour, marker; the curves in the order of the legend
METHODS = {
    "auto": ("auto, by tolerance", "#1b6ca8", "o"),
    "exact": ("exact", "#0b2e4f", "*"),
    "preclip": ("preclip", "#8e6bbf", "D"),
    "vertex": ("vertex", "#b0853a", "v"),
    "cubemap": ("VTK's cubemap pass, by pixels a face", "#c0392b", "^"),
}
LINES = {"perspective": "perspective 120°", "floor": "one plain pass"}
NO_ERROR = {"max_px": 0.002, "share": 5e-7}  # where an error of zero is drawn
LARGEST = {"max_px": 200, "share": 1.5}  # the right edges
TITLES = {"max_px": "largest distance of a wrong pixel, pixels", "share": "share of wrong pixels"}


def errors_of(record):
    """The two errors that are drawn."""
    error = record["error"]
    width, height = record["size"]
    share = error["mismatched_pixels"] / (width * height)
    return {"max_px": error["max_px"], "share": share}


def points_of(records, method, measure):
    """(error, milliseconds, parameter) of one method, by parameter."""
    points = []
    for record in records:
        known = record["method"] == method and record["error"] and record["ms"]["median"]
        if known:
            error = max(errors_of(record)[measure], NO_ERROR[measure])
            points.append((error, record["ms"]["median"], record["parameter"]))
    return sorted(points, key=lambda p: p[2] or 0)


def draw_curves(axes, records, measure):
    for method, (label, color, marker) in METHODS.items():
        points = points_of(records, method, measure)
        if not points:
            continue
        size = 11 if marker == "*" else 6
        errors, times, parameters = zip(*points)
        axes.plot(errors, times, marker=marker, color=color, label=label, markersize=size)
        for error, time, parameter in points if parameters[0] is not None else []:
            axes.annotate(
                "%g" % parameter, (error, time), (4, 4), textcoords="offset points", fontsize=7
            )


def draw_lines(axes, records):
    for record in records:
        label = LINES.get(record["method"])
        if label and record["ms"]["median"]:
            style = ":" if record["method"] == "floor" else "--"
            axes.axhline(record["ms"]["median"], color="0.5", linestyle=style, label=label)


def draw_scene(records, path, software):
    figure, panels = plt.subplots(1, 2, figsize=(13, 4.6), sharey=True, layout="constrained")
    for axes, measure in zip(panels, TITLES):
        draw_curves(axes, records, measure)
        draw_lines(axes, records)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlim(NO_ERROR[measure] / 1.5, LARGEST[measure])
        axes.set_xlabel(TITLES[measure])
        axes.grid(True, which="major", alpha=0.3)
    first = records[0]
    panels[0].set_ylabel("milliseconds a frame")
    # beside the panels: over them it would hide labels
    panels[1].legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.01, 1.0))
    figure.suptitle(
        "%s: %s triangles, %dx%d%s"
        % (
            first["scene"],
            format(first["triangles"], ","),
            first["size"][0],
            first["size"][1],
            ", software rendering" if software else "",
        )
    )
    # without a date, so that the same numbers make the same file
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def main():
    if len(sys.argv) != 3:
        sys.exit("plot.py: give BENCH.json and a folder")
    with open(sys.argv[1], encoding="utf-8") as stream:
        bench = json.load(stream)
    matplotlib.rcParams["svg.hashsalt"] = "widefov"
    software = bench["environment"]["software_rendering"]
    for scene in dict.fromkeys(record["scene"] for record in bench["records"]):
        records = [r for r in bench["records"] if r["scene"] == scene]
        path = os.path.join(sys.argv[2], scene + ".svg")
        draw_scene(records, path, software)
        print(path)


if __name__ == "__main__":
    main()
