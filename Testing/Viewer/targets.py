# SPDX-License-Identifier: BSD-3-Clause
"""A scene of coloured marks round the eye, and where a photograph shows them."""

import math

import numpy

# Name: colour (red, green, blue), longitude and latitude in degrees as the eye at the origin
# sees it that looks along -z.
TARGETS = {
    "red": ((255, 0, 0), 0, 0),
    "green": ((0, 255, 0), 20, 0),
    "blue": ((0, 0, 255), -20, 0),
    "yellow": ((255, 255, 0), 30, 25),
    "magenta": ((255, 0, 255), -40, -20),
    "cyan": ((0, 255, 255), 150, -10),
}
DISTANCE = 10.0
# Degrees; a few pixels.
WIDTH = 1.5


def direction(longitude, latitude):
    """Unit vector: x right, y up, z behind."""
    a, b = math.radians(longitude), math.radians(latitude)
    return numpy.array([math.sin(a) * math.cos(b), math.sin(b), -math.cos(a) * math.cos(b)])


def square(longitude, latitude):
    """Corners of a square that faces the eye."""
    ahead = direction(longitude, latitude)
    right = direction(longitude + 90, 0)
    up = numpy.cross(right, ahead)
    half = DISTANCE * math.tan(math.radians(WIDTH / 2))
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    return [DISTANCE * ahead + half * (x * right + y * up) for x, y in corners]


def write(path):
    """The scene as a legacy .vtk file."""
    points, cells, colors = [], [], []
    for color, longitude, latitude in TARGETS.values():
        cells.append("4 %d %d %d %d" % tuple(range(len(points), len(points) + 4)))
        points += ["%.9g %.9g %.9g" % tuple(corner) for corner in square(longitude, latitude)]
        colors.append("%d %d %d" % tuple(c // 255 for c in color))
    lines = ["# vtk DataFile Version 3.0", "marks", "ASCII", "DATASET POLYDATA"]
    lines += ["POINTS %d double" % len(points)] + points
    lines += ["POLYGONS %d %d" % (len(cells), 5 * len(cells))] + cells
    lines += ["CELL_DATA %d" % len(cells), "COLOR_SCALARS colour 3"] + colors
    with open(path, "w", encoding="utf-8") as stream:
        stream.write("\n".join(lines) + "\n")


def find(picture, name):
    """Column and row (pixels, centres at halves) of the middle of a target, or None."""
    color = numpy.array(TARGETS[name][0]) > 0
    values = picture.astype(float)
    # the smallest of its channels less the largest of the others: zero for other colours
    weight = values[:, :, color].min(2)
    if not color.all():
        weight = weight - values[:, :, ~color].max(2)
    weight = numpy.clip(weight, 0, None)
    if weight.max() < 40:
        return None
    rows, columns = numpy.mgrid[0 : picture.shape[0], 0 : picture.shape[1]] + 0.5
    total = weight.sum()
    return numpy.array([(columns * weight).sum() / total, (rows * weight).sum() / total])
