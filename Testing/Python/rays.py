# SPDX-License-Identifier: BSD-3-Clause
"""A ray caster for boxes, in double precision: the directions of a picture's pixels by the formulas of
Documentation/projections, and what they meet."""

import numpy


def grid(size):
    """x and y of the centres of all pixels, the first row on top: NDC."""
    width, height = size
    x = 2 * (numpy.arange(width) + 0.5) / width - 1
    y = 1 - 2 * (numpy.arange(height) + 0.5) / height
    return numpy.meshgrid(x, y)


def of_angles(longitude, latitude, inside):
    """Directions, x right, y up, looking down -z; NaN where the map shows nothing."""
    c = numpy.cos(latitude)
    d = [c * numpy.sin(longitude), numpy.sin(latitude), -c * numpy.cos(longitude)]
    return numpy.where(inside[..., None], numpy.stack(d, axis=-1), numpy.nan)


def equirectangular(size):
    x, y = grid(size)
    return of_angles(numpy.pi * x, 0.5 * numpy.pi * y, numpy.full(x.shape, True))


def hammer(size):
    x, y = grid(size)
    inside = x * x + y * y < 1
    a, b = numpy.sqrt(8) * x, numpy.sqrt(2) * y
    z = numpy.sqrt(numpy.clip(1 - (a / 4) ** 2 - (b / 2) ** 2, 0.5, 1))
    longitude = 2 * numpy.arctan2(z * a, 2 * (2 * z * z - 1))
    return of_angles(longitude, numpy.arcsin(numpy.clip(z * b, -1, 1)), inside)


def dome(size):
    """azimuthal-equidistant, 180 degrees across."""
    x, y = grid(size)
    width, height = size
    short = min(size)
    x, y = x * width / short, y * height / short
    r = numpy.hypot(x, y)
    theta = 0.5 * numpy.pi * r
    s = numpy.sin(theta) / numpy.where(r > 0, r, 1)
    d = numpy.stack([s * x, s * y, -numpy.cos(theta)], axis=-1)
    return numpy.where((r < 1)[..., None], d, numpy.nan)


def distance_to_box(origin, directions, bounds):
    """Along each ray; inf where it misses."""
    low, high = numpy.array(bounds[::2]), numpy.array(bounds[1::2])
    with numpy.errstate(divide="ignore", invalid="ignore"):
        a, b = (low - origin) / directions, (high - origin) / directions
        near, far = numpy.minimum(a, b).max(axis=-1), numpy.maximum(a, b).min(axis=-1)
        return numpy.where((near <= far) & (near > 0), near, numpy.inf)


def cast(origin, directions, boxes, background):
    """boxes: (bounds, colour); the colour of each pixel, 0 to 255."""
    picture = numpy.empty(directions.shape, numpy.uint8)
    picture[:] = background
    nearest = numpy.full(directions.shape[:2], numpy.inf)
    for bounds, color in boxes:
        distance = distance_to_box(numpy.array(origin, float), directions, bounds)
        picture[distance < nearest] = color
        nearest = numpy.minimum(nearest, distance)
    return picture


def inner(picture):
    """Where all eight neighbours are alike (a pixel of the border has fewer)."""
    same = numpy.full(picture.shape[:2], True)
    padded = numpy.pad(picture, ((1, 1), (1, 1), (0, 0)), mode="edge")
    height, width = same.shape
    for dy in range(3):
        for dx in range(3):
            same &= (padded[dy : dy + height, dx : dx + width] == picture).all(axis=-1)
    return same
