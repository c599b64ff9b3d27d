#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Times what a user sees who drags the picture of widefov-viewer, beside the same in perspective.

    dragging.py WIDEFOV-VIEWER --output FILE.json [--scenes A,B,..] [--size WxH] [--frames N]

Starts a display of its own, and the viewer with its default options. The pointer is moved on as soon
as a frame is drawn, so every frame has another view; times are those of --log. The first frames of a
drag, which compile and find out how small a frame has to be, do not count. Both are dragged in turns,
so that whatever else the machine does befalls them alike.
"""

import argparse
import json
import os
import statistics
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir, "Viewer"))
import desktop  # noqa: E402

SCENES = "winds,atrium,flow"  # what the limit is asked of
VIEWS = {"wide": [], "perspective": ["--projection", "perspective"]}
ROUNDS = 2
SETTLING = 6  # frames of a drag that do not count
STEP = 3  # pixels a frame


def drag(viewer, size, frames):
    """The states of so many frames while the left button is held."""
    begun = len(viewer.states())

    def drawn():
        return [state for state in viewer.states()[begun:] if state["event"] == "frame"]

    y = size[1] // 2
    viewer.point(size[0] // 3, y)
    viewer.desktop.press("left")
    for i in range(1, frames + 1):
        # back and forth, within the window
        before = len(drawn())
        viewer.point(size[0] // 3 + STEP * (i if i <= frames // 2 else frames - i + 1), y + i % 2)
        desktop.wait_for("a frame", lambda before=before: len(drawn()) > before)
    states = drawn()
    viewer.desktop.release("left")
    return states


def time_view(screen, program, arguments, size, frames, folder):
    """Milliseconds of the frames of a drag, and by how much the last was relaxed."""
    given = arguments + ["--size", "%dx%d" % size]
    viewer = desktop.Viewer(screen, program, given, folder)
    try:
        states = drag(viewer, size, frames + SETTLING)[SETTLING:]
    finally:
        viewer.kill()
    if len(states) < frames:
        raise desktop.Gone("%d frames of a drag, not %d" % (len(states), frames))
    return [state["ms"] for state in states], states[-1]["relaxation"]


def time_scene(screen, options, scene, folder):
    """The record of one scene."""
    times = {name: [] for name in VIEWS}
    relaxation = {}
    for _ in range(ROUNDS):
        for name, arguments in VIEWS.items():
            ms, relaxation[name] = time_view(
                screen, options.viewer, ["--scene", scene] + arguments, options.size, options.frames,
                folder)
            times[name] += ms
    median = {name: statistics.median(ms) for name, ms in times.items()}
    return {
        "scene": scene, "ms": median, "ratio": median["wide"] / median["perspective"],
        "relaxation": relaxation["wide"],
    }


def size_of(text):
    width, height = text.split("x")
    return int(width), int(height)


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("viewer")
    parser.add_argument("--output", required=True)
    parser.add_argument("--scenes", default=SCENES)
    parser.add_argument("--size", type=size_of, default=(1024, 512))
    parser.add_argument("--frames", type=int, default=15)
    return parser.parse_args()


def main():
    options = parse()
    options.viewer = os.path.abspath(options.viewer)
    screen = desktop.Desktop("%dx%d" % options.size)
    records = []
    try:
        with tempfile.TemporaryDirectory() as folder:
            for scene in options.scenes.split(","):
                record = time_scene(screen, options, scene, folder)
                print("%s: %.1f ms, in perspective %.1f: %.2f times" % (
                    scene, record["ms"]["wide"], record["ms"]["perspective"], record["ratio"]))
                records.append(record)
    finally:
        screen.close()
    document = {"size": options.size, "frames": ROUNDS * options.frames, "records": records}
    with open(options.output, "w", encoding="utf-8") as stream:
        json.dump(document, stream, indent=2)
        stream.write("\n")


if __name__ == "__main__":
    main()
