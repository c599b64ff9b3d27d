# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of several ranks, each of which draws a part of the cells.

The script runs on rank 0, which has the pictures and compares them with the ray caster's:
so every number of ranks draws the same.
"""

import os

from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import scene

PROJECTIONS = ["equirectangular", "azimuthal-equidistant", "panini"]


def main(options):
    ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
    scene.load_plugin(options)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    view = scene.make_view()
    scene.show_cells(scene.spread(simple.XMLPolyDataReader(FileName=[mesh])), view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    for projection in PROJECTIONS:
        view.Projection = projection
        picture = scene.save(view, os.path.join(options.output, projection + ".png"))
        answer = scene.check_cells(options, view, mesh, picture, 0.25)
        print(ranks, "ranks,", projection, answer, flush=True)
        scene.require(answer["unexplained"] == 0 and answer["hits"] > 3000, projection)


scene.run(main)
