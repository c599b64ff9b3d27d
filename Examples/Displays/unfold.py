#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lays the walls of a CAVE out beside each other, to look at.

    unfold.py PICTURE.png LEFT.png FRONT.png RIGHT.png [FLOOR.png]
"""

import sys

import numpy
from matplotlib.image import imread, imsave


def main():
    if len(sys.argv) not in (5, 6):
        sys.exit("unfold.py: name the picture to write, and those of the walls")
    walls = [imread(path)[..., :3] for path in sys.argv[2:]]
    height, width = walls[1].shape[:2]
    picture = numpy.ones((height * (len(walls) - 2), sum(w.shape[1] for w in walls[:3]), 3))
    x = 0
    for wall in walls[:3]:
        picture[: wall.shape[0], x : x + wall.shape[1]] = wall
        x += wall.shape[1]
    for floor in walls[3:]:
        left = walls[0].shape[1]
        picture[height : height + floor.shape[0], left : left + width] = floor
    imsave(sys.argv[1], picture)


if __name__ == "__main__":
    main()
