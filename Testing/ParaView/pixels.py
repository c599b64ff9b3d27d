# SPDX-License-Identifier: BSD-3-Clause
"""Which cell a pixel shows, and which a selection of it holds."""

from paraview import simple
from vtkmodules.vtkCommonCore import vtkCollection
from vtkmodules.vtkIOImage import vtkPNGReader

import scene


def _read(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def read_numbers(path):
    """A function from a pixel, counted from the lower left, to its colour as a number."""
    image = _read(path)

    def read(x, y):
        red, green, blue = (int(image.GetScalarComponentAsDouble(x, y, 0, i)) for i in range(3))
        return 65536 * red + 256 * green + blue

    return read


def read_levels(path):
    """Rows of the red of each pixel, 0 to 255."""
    image = _read(path)
    width, height, _ = image.GetDimensions()
    return [
        [int(image.GetScalarComponentAsDouble(x, y, 0, 0)) for x in range(width)]
        for y in range(height)
    ]


def read_rows(path):
    """Rows of the colours of the pixels, as numbers."""
    image = _read(path)
    width, height, _ = image.GetDimensions()
    parts = image.GetNumberOfScalarComponents()
    data = bytes(memoryview(image.GetPointData().GetScalars()))
    reds, greens, blues = (data[i::parts] for i in range(3))
    numbers = [65536 * r + 256 * g + b for r, g, b in zip(reds, greens, blues)]
    return [numbers[y * width:(y + 1) * width] for y in range(height)]


def count_lit(path):
    """Pixels that are not black."""
    return sum(number > 0 for row in read_rows(path) for number in row)


def lit_pixels(path, red_only=False):
    """The pixels that are not black, or those that are red, as places from the lower left."""

    def counts(number):
        red, green = number >> 16, number >> 8 & 255
        return red > 2 * green if red_only else number > 0

    return {(i, j) for j, row in enumerate(read_rows(path)) for i, n in enumerate(row) if counts(n)}


def count_different(rows, others):
    """Pixels that are not the same in both."""
    return sum(a != b for x, y in zip(rows, others) for a, b in zip(x, y))


def count_other(first, second, rounding):
    """Pixels of two pictures whose red differs by more levels than these."""
    rows = zip(read_levels(first), read_levels(second))
    return sum(abs(a - b) > rounding for x, y in rows for a, b in zip(x, y))


def select(view, x, y):
    """The rank and the id of the cell that a selection of one pixel holds, or None."""
    representations = vtkCollection()
    sources = vtkCollection()
    view.SelectSurfaceCells([x, y, x, y], representations, sources, 0)
    if sources.GetNumberOfItems() == 0:
        return None
    ids = sources.GetItemAsObject(0).GetProperty("IDs")
    scene.require(ids.GetNumberOfElements() == 2, "more than one cell in a pixel")
    return max(0, ids.GetElement(0)), ids.GetElement(1)


def find_cells(source):
    """The rank and the id of each numbered cell."""
    places = {}
    for rank, part in simple.FetchData(source).items():
        colours = part.GetCellData().GetArray("number")
        for cell in range(part.GetNumberOfCells()):
            red, green, blue = (int(c) for c in colours.GetTuple3(cell))
            places[65536 * red + 256 * green + blue] = (rank, cell)
    return places


def agree(expected, found, ranks):
    """ParaView 5.11 itself names another rank in a few pixels of a composited picture, in its
    Render View as well: with several ranks the id of the cell alone is compared."""
    if ranks > 1 and expected and found:
        return expected[1] == found[1]
    return expected == found


def check_selection(view, source, picture, count, dice):
    """Fails where one of so many random pixels selects another cell than the picture shows."""
    drawn = read_numbers(picture)
    places = find_cells(source)
    ranks = 1 + max(rank for rank, _ in places.values())
    wrong = []
    hits = 0
    for _ in range(count):
        x, y = dice.randrange(scene.SIZE[0]), dice.randrange(scene.SIZE[1])
        expected, found = places.get(drawn(x, y)), select(view, x, y)
        hits += found is not None
        if not agree(expected, found, ranks):
            wrong.append((x, y, expected, found))
    print("selected", hits, "cells, wrong:", wrong)
    scene.require(not wrong and hits > count // 4, "selection")
