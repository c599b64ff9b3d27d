#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Photographs widefov-viewer's window after some keys, for the documentation.

    photograph.py VIEWER OUTPUT.png KEYS [VIEWER OPTION...]

KEYS are names of keys with commas between them, such as F1 or p,p,t; "-" is none.
"""

import os
import sys
import tempfile

from matplotlib import image

from desktop import Desktop, Viewer


def main():
    if len(sys.argv) < 4:
        sys.exit("photograph.py: name the viewer, the picture, the keys, the viewer's options")
    program, output, keys = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3]
    desktop = Desktop()
    try:
        with tempfile.TemporaryDirectory(prefix="viewer-") as folder:
            viewer = Viewer(desktop, program, sys.argv[4:], folder)
            viewer.point(5, 5)
            for key in [] if keys == "-" else keys.split(","):
                viewer.key(key)
            image.imsave(output, viewer.photograph())
            viewer.kill()
    finally:
        desktop.close()


if __name__ == "__main__":
    main()
