# SPDX-License-Identifier: BSD-3-Clause
"""Selecting a pixel gives the cell that is drawn there."""

import os
import random

from paraview import simple

import pixels
import scene

# In all, of which each is a selection of its own. (1000 were right as well.)
PIXELS = 160


def main(options):
    scene.load_plugin(options)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    view = scene.make_view()
    source = simple.XMLPolyDataReader(FileName=[mesh])
    scene.show_cells(source, view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    dice = random.Random(1)
    projections = ["equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap"]
    for projection in projections:
        view.Projection = projection
        picture = scene.save(view, os.path.join(options.output, projection + ".png"))
        pixels.check_selection(view, source, picture, PIXELS // len(projections), dice)


scene.run(main)
