#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs programs of others by widefov-run, as they are and from where their packages put them, and makes
a sheet of what they show.

    others.py BIN FOLDER [WORD...]

BIN: the folder of widefov-run. Into FOLDER go a picture a program, and sheet-1.png, .. of twenty each.
Runs those of others.txt that have one of the words in their name, or all. Prints a line each, and how
many are wrong: crash, show nothing, or speak of an error of OpenGL. The exit code is 1 where any is.
"""

import os
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import image, pyplot  # noqa: E402

import look  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
EXAMPLES = "/usr/share/doc/python3-vedo-examples/examples"
SECONDS = 60  # to draw; most rest after five
PER_SHEET = 20


def listed(words):
    """Of each program: its name, and the options of widefov-run."""
    with open(os.path.join(HERE, "others.txt"), encoding="utf-8") as file:
        lines = [line.split() for line in file if line.strip() and not line.startswith("#")]
    for eye, name in lines:
        if not words or any(word in name for word in words):
            yield name, ["--inside"] if eye == "inside" else []


def sheet(path, pictures):
    figure, axes = pyplot.subplots(5, 4, figsize=(16, 16.5), layout="constrained")
    for axis in axes.flat:
        axis.axis("off")
    for axis, (name, picture) in zip(axes.flat, pictures):
        axis.imshow(picture[::2, ::2])
        axis.set_title(name, fontsize=9)
    figure.savefig(path, dpi=80)
    pyplot.close(figure)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    run = os.path.join(os.path.abspath(sys.argv[1]), "widefov-run")
    folder = os.path.abspath(sys.argv[2])
    os.makedirs(folder, exist_ok=True)
    pictures = []
    wrong = 0
    for name, options in listed(sys.argv[3:]):
        command = [run, *options, "/usr/bin/python3", "-B", os.path.join(EXAMPLES, name)]
        picture, faults, said = look.look(command, SECONDS, folder)
        image.imsave(os.path.join(folder, name.replace("/", "-") + ".png"), picture)
        pictures.append((name, picture))
        wrong += bool(faults)
        print("%-32s %s; said %s" % (name, "; ".join(faults) or "right", said[-2:]), flush=True)
    for first in range(0, len(pictures), PER_SHEET):
        path = os.path.join(folder, "sheet-%d.png" % (first // PER_SHEET + 1))
        sheet(path, pictures[first : first + PER_SHEET])
    print("%d of %d are wrong" % (wrong, len(pictures)))
    sys.exit(1 if wrong or not pictures else 0)


if __name__ == "__main__":
    main()
