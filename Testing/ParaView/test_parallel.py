# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of several ranks, each of which draws a part of the cells.

The script runs on rank 0, which has the pictures and compares them with the ray caster's:
so every number of ranks draws the same.
"""

import os

from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import pixels
import scene

PROJECTIONS = ["equirectangular", "azimuthal-equidistant"]


# Fraction of the pixels of a translucent picture that other ranks may draw otherwise.
OTHERWISE = 1e-4

# Levels of 255: blending in another order rounds otherwise.
ROUNDING = 3


def check(options, view, mesh, name):
    picture = scene.save(view, os.path.join(options.output, name + ".png"))
    answer = scene.check_cells(options, view, mesh, picture, 0.25)
    print(name, answer, flush=True)
    scene.require(answer["unexplained"] == 0 and answer["hits"] > 3000, name)


def check_opaque(options, view, mesh):
    for projection in PROJECTIONS:
        view.Projection = projection
        check(options, view, mesh, projection)


def check_eyes(options, view, mesh):
    """One eye after the other, of a dome."""
    view.Projection = "azimuthal-equidistant"
    view.InterpupillaryDistance = 0.5
    for side, mode in ((-1, "Left Eye Only"), (1, "Right Eye Only")):
        path = os.path.join(options.output, "eye%d.png" % side)
        picture = scene.save(view, path, StereoMode=mode)
        answer = scene.check_cells(options, view, mesh, picture, 0.25, side)
        print(mode, answer, flush=True)
        scene.require(answer["unexplained"] == 0 and answer["hits"] > 3000, mode)


def check_idle_ranks(options, source, mesh):
    """The same where all data are on rank 0, in a view of its own."""
    view = scene.make_view()
    scene.show_cells(source, view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    check(options, view, mesh, "idle")


def check_translucent(options, view, display, ranks):
    """Several layers of one surface, beside the picture of one rank, a test of its own."""
    view.Projection = "equirectangular"
    view.MaximumNumberOfPeels = 30
    display.Opacity = 0.5
    simple.ColorBy(display, None)
    picture = scene.save(view, os.path.join(options.output, "translucent.png"))
    alone = os.path.join(os.path.dirname(options.output), "Ranks1", "translucent.png")
    levels = {level for row in pixels.read_levels(alone) for level in row}
    scene.require({128, 192} <= levels, "one layer alone is drawn: %s" % sorted(levels))
    other = pixels.count_other(picture, alone, ROUNDING)
    print(ranks, "ranks,", other, "translucent pixels differ from one rank's", flush=True)
    scene.require(other <= OTHERWISE * scene.SIZE[0] * scene.SIZE[1], "translucency")


def main(options):
    ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
    scene.load_plugin(options)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    view = scene.make_view()
    whole = simple.XMLPolyDataReader(FileName=[mesh])
    display = scene.show_cells(scene.spread(whole), view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    check_opaque(options, view, mesh)
    check_eyes(options, view, mesh)
    check_translucent(options, view, display, ranks)
    check_idle_ranks(options, whole, mesh)


scene.run(main)
