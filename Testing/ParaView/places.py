# SPDX-License-Identifier: BSD-3-Clause
"""Where a picture of everything shows things: the formula of the equirectangular map, independent
of the view's own, for an eye that looks down -z with y up."""

import math

import scene

# Pixels between the places that stand for a line.
STEP = 0.4

# Pixels beyond half of a line's width, or a point's: a pixel's centre is up to half a diagonal
# from the line through it.
LINE_TOLERANCE = 1

# Halvings of a line at most, where the map tears it or it passes a pole.
DEEPEST = 14


def place_of(point, eye, size):
    """Pixels from the lower left."""
    x, y, z = (a - b for a, b in zip(point, eye))
    longitude, latitude = math.atan2(x, -z), math.atan2(y, math.hypot(x, z))
    return (
        (longitude / math.pi + 1) / 2 * size[0],
        (latitude / (math.pi / 2) + 1) / 2 * size[1],
    )


def direction_of(x, y, size):
    """The inverse: the direction that the place in the picture shows."""
    longitude = (2 * x / size[0] - 1) * math.pi
    latitude = (2 * y / size[1] - 1) * math.pi / 2
    level = math.cos(latitude)
    return level * math.sin(longitude), math.sin(latitude), -level * math.cos(longitude)


def places_of_line(first, second, eye, size, depth=0):
    """Places along the straight line between two points, close enough to be the line."""
    a, b = place_of(first, eye, size), place_of(second, eye, size)
    if math.dist(a, b) < STEP or depth == DEEPEST:
        return [a, b]
    middle = [(p + q) / 2 for p, q in zip(first, second)]
    return (places_of_line(first, middle, eye, size, depth + 1)
            + places_of_line(middle, second, eye, size, depth + 1))


def pixels_near(places, reach, size):
    """Pixels whose centres are so many pixels or less from one of the places; the left border and
    the right one meet."""
    found = set()
    steps = range(-math.ceil(reach) - 1, math.ceil(reach) + 2)
    for x, y in set((round(x, 1), round(y, 1)) for x, y in places):
        for i in (math.floor(x) + d for d in steps):
            for j in (math.floor(y) + d for d in steps):
                if 0 <= j < size[1] and math.hypot(i + 0.5 - x, j + 0.5 - y) <= reach:
                    found.add((i % size[0], j))
    return found


def check_places(name, found, expected, width, size):
    """The pixels are those of the places, of lines of this width, no others, and none is missing."""
    reach = width / 2 + LINE_TOLERANCE
    strange = found - pixels_near(expected, reach, size)
    # a place is drawn where one of the pixels round it is
    lonely = [p for p in expected if not pixels_near([p], reach, size) & found]
    print(name, len(found), "pixels, not on a line:", len(strange), sorted(strange)[:3],
          "places not drawn:", len(lonely), lonely[:3], flush=True)
    scene.require(found and not strange and not lonely, name)
