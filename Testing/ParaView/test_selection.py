# SPDX-License-Identifier: BSD-3-Clause
"""Selecting a pixel gives the cell that is drawn there."""

import os
import random

from paraview import simple
from vtkmodules.vtkCommonCore import vtkCollection
from vtkmodules.vtkIOImage import vtkPNGReader

import scene

# In all, of which each is a selection of its own. (1000 were right as well.)
PIXELS = 160


def read_cells(path):
    """A function from a pixel, counted from the lower left, to the cell that it shows."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()

    def cell(x, y):
        red, green, blue = (int(image.GetScalarComponentAsDouble(x, y, 0, i)) for i in range(3))
        return 65536 * red + 256 * green + blue - 1

    return cell


def select(view, x, y):
    """The id of the cell that a selection of one pixel holds, or -1."""
    representations = vtkCollection()
    sources = vtkCollection()
    view.SelectSurfaceCells([x, y, x, y], representations, sources, 0)
    if sources.GetNumberOfItems() == 0:
        return -1
    ids = sources.GetItemAsObject(0).GetProperty("IDs")
    # pairs of a rank and an id
    return ids.GetElement(1)


def main(options):
    scene.load_plugin(options)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    view = scene.make_view()
    scene.show_cells(simple.XMLPolyDataReader(FileName=[mesh]), view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    dice = random.Random(1)
    projections = ["equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap"]
    for projection in projections:
        view.Projection = projection
        drawn = read_cells(scene.save(view, os.path.join(options.output, projection + ".png")))
        wrong = []
        hits = 0
        for _ in range(PIXELS // len(projections)):
            x, y = dice.randrange(scene.SIZE[0]), dice.randrange(scene.SIZE[1])
            expected, found = drawn(x, y), select(view, x, y)
            hits += found >= 0
            if expected != found:
                wrong.append((x, y, expected, found))
        print(projection, "selected", hits, "cells, wrong:", wrong)
        scene.require(not wrong and hits > 10, projection)


scene.run(main)
