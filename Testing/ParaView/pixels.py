# SPDX-License-Identifier: BSD-3-Clause
"""Which cell a pixel shows, and which a selection of it holds."""

from paraview import simple
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkCollection
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

import scene


def _read(path):
    """Width, height, numbers a pixel, and all of them, from the lower left on."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    scalars = image.GetPointData().GetScalars()
    width, height, _ = image.GetDimensions()
    return width, height, scalars.GetNumberOfComponents(), memoryview(scalars).tobytes()


def read_numbers(path):
    """A function from a pixel, counted from the lower left, to its colour as a number."""
    rows = read_rows(path)
    return lambda x, y: rows[y][x]


def read_levels(path):
    """Rows of the red of each pixel, 0 to 255."""
    width, height, step, levels = _read(path)
    line = width * step
    return [list(levels[y * line:(y + 1) * line:step]) for y in range(height)]


def read_rows(path):
    """Rows of the colours of the pixels, as numbers."""
    width, height, step, levels = _read(path)
    numbers = [65536 * red + 256 * green + blue
               for red, green, blue in zip(levels[::step], levels[1::step], levels[2::step])]
    return [numbers[y * width:(y + 1) * width] for y in range(height)]


def write_rows(rows, path):
    """A picture of such rows."""
    image = vtkImageData()
    image.SetDimensions(len(rows[0]), len(rows), 1)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 3)
    for y, row in enumerate(rows):
        for x, number in enumerate(row):
            for i, level in enumerate((number >> 16, number >> 8 & 255, number & 255)):
                image.SetScalarComponentFromDouble(x, y, 0, i, level)
    write(image, path)


def write(image, path):
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()


def _take(rows, columns, lines):
    return [[rows[y][x] for x in columns] for y in lines]


def _stretch(few, many):
    """The pixel that each of many shows, where ParaView magnifies a few: its texture goes from the
    centre of the first to that of the last."""
    return [((2 * i + 1) * (few - 1) + many) // (2 * many) for i in range(many)]


def magnify(rows, width, height):
    """A reduced picture as ParaView shows it."""
    return _take(rows, _stretch(len(rows[0]), width), _stretch(len(rows), height))


def reduce(rows, width, height):
    """The reduced picture that is shown as this one."""
    columns, lines = _stretch(width, len(rows[0])), _stretch(height, len(rows))
    return _take(rows, [columns.index(x) for x in range(width)],
                 [lines.index(y) for y in range(height)])


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


def largest_difference(rows, others):
    """Levels of 255 by which a channel of any pixel differs."""
    pairs = {(a, b) for x, y in zip(rows, others) for a, b in zip(x, y)}
    return max(abs((a >> i & 255) - (b >> i & 255)) for a, b in pairs for i in (0, 8, 16))


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


def _is_misnamed(expected, found):
    """Whether the cell's id is right and its rank is not."""
    return bool(expected and found and expected[0] != found[0] and expected[1] == found[1])


def check_selection(view, source, picture, count, dice, ranks=True):
    """Fails where one of so many random pixels selects another cell than the picture shows, by its
    rank and its id there, or by the id alone."""
    drawn = read_numbers(picture)
    places = find_cells(source)
    wrong = []
    hits = misnamed = 0
    for _ in range(count):
        x, y = dice.randrange(scene.SIZE[0]), dice.randrange(scene.SIZE[1])
        expected, found = places.get(drawn(x, y)), select(view, x, y)
        hits += found is not None
        misnamed += _is_misnamed(expected, found)
        if expected != found and (ranks or not _is_misnamed(expected, found)):
            wrong.append((x, y, expected, found))
    print("selected", hits, "cells, of another rank:", misnamed, "wrong:", wrong, flush=True)
    scene.require(not wrong and hits > count // 4, "selection")
