#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a direction map: two flat screens that meet at an angle, with a gap between them.

    wall-direction-map.py FILE.exr

Every display that has a direction for each of its pixels can be described so: x to the
right, y up, z behind the eye; unit vectors, and 0, 0, 0 where there is no display.
"""

import os
import sys

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Utilities"))
from exr import write_directions  # pylint: disable=wrong-import-position

WIDTH, HEIGHT = 580, 500  # pixels of one screen
GAP = 40  # pixels between them
HALF_SIZE = 1.1, 0.9  # of a screen, in units of its distance
YAW = 50  # degrees, of each screen's middle to the left and to the right


def screen(yaw):
    """The directions of one screen, the top row first."""
    x = HALF_SIZE[0] * (2 * (numpy.arange(WIDTH) + 0.5) / WIDTH - 1)
    y = HALF_SIZE[1] * (1 - 2 * (numpy.arange(HEIGHT) + 0.5) / HEIGHT)
    x, y = numpy.meshgrid(x, y)
    directions = numpy.stack([x, y, -numpy.ones_like(x)], axis=-1)
    directions /= numpy.linalg.norm(directions, axis=-1, keepdims=True)
    c, s = numpy.cos(numpy.radians(yaw)), numpy.sin(numpy.radians(yaw))
    turn = numpy.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])
    return directions @ turn.T


def main():
    if len(sys.argv) != 2:
        sys.exit("wall-direction-map.py: name the file to write")
    gap = numpy.zeros((HEIGHT, GAP, 3))
    write_directions(sys.argv[1], numpy.concatenate([screen(-YAW), gap, screen(YAW)], axis=1))


if __name__ == "__main__":
    main()
