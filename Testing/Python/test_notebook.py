#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the cells of the notebook one after the other, and looks at what they show.

    PYTHONPATH=FOLDER test_notebook.py NOTEBOOK [PICTURES]

PICTURES: a folder that the pictures are written into.
"""

import json
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402

# Of the pixels, what is drawn is not all one colour; and how many pictures there are.
LEAST_COLORS = 100
PICTURES = 4


def code_cells(path):
    with open(path, encoding="utf-8") as stream:
        notebook = json.load(stream)
    cells = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
    if any(cell.get("outputs") for cell in notebook["cells"]):
        sys.exit("the notebook is kept without outputs")
    return cells


def shown():
    """The pictures of the figures that were made since the last call."""
    pictures = [numpy.asarray(plt.figure(n).axes[0].images[0].get_array()) for n in plt.get_fignums()]
    plt.close("all")
    return pictures


def main():
    names = {}
    pictures = []
    for cell in code_cells(sys.argv[1]):
        exec(compile(cell, "cell", "exec"), names)  # pylint: disable=exec-used
        pictures += shown()
    colors = [len(numpy.unique(picture.reshape(-1, 3), axis=0)) for picture in pictures]
    print("colours of each picture: %s (%d at least)" % (colors, LEAST_COLORS))
    for i, picture in enumerate(pictures if len(sys.argv) > 2 else []):
        plt.imsave(os.path.join(sys.argv[2], "cell-%d.png" % i), picture)
    sys.exit(0 if len(colors) == PICTURES and min(colors) >= LEAST_COLORS else 1)


if __name__ == "__main__":
    main()
