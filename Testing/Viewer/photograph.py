#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Photographs widefov-viewer's windows after some keys, for the documentation.

    photograph.py VIEWER OUTPUT.png KEYS [VIEWER OPTION...]

KEYS are names of keys with commas between them, such as F1 or p,p,t; "-" is none. Two numbers,
such as 300x120, are where the pointer goes, in pixels of the window. Several windows are side by
side in the picture.
"""

import os
import re
import sys
import tempfile

import numpy
from matplotlib import image

from desktop import Desktop, Viewer, pixels_of


def photograph(viewer):
    """All windows that are as high as the first, from the left."""
    row = []
    for window in viewer.windows().values():
        size = window.get_geometry()
        row.append((size.x, pixels_of(window, size.width, size.height)))
    return numpy.hstack([picture for _, picture in sorted(row, key=lambda pair: pair[0])])


def main():
    if len(sys.argv) < 4:
        sys.exit("photograph.py: name the viewer, the picture, the keys, the viewer's options")
    program, output, keys = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3]
    # the viewer runs in a folder of its own
    options = [os.path.abspath(word) if os.path.exists(word) else word for word in sys.argv[4:]]
    desktop = Desktop()
    try:
        with tempfile.TemporaryDirectory(prefix="viewer-") as folder:
            viewer = Viewer(desktop, program, options, folder)
            viewer.point(5, 5)
            for key in [] if keys == "-" else keys.split(","):
                place = re.fullmatch(r"(\d+)x(\d+)", key)
                if place:
                    viewer.point(int(place[1]), int(place[2]))
                else:
                    viewer.key(key)
            image.imsave(output, photograph(viewer))
            viewer.kill()
    finally:
        desktop.close()


if __name__ == "__main__":
    main()
