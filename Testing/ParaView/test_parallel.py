# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of several ranks, each of which draws a part of the cells.

The script runs on rank 0, which has the pictures and compares them with the ray caster's:
so every number of ranks draws the same.
"""

import os

from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import composited
import scene
from messages import Log


def check_eyes(options, view, mesh):
    """One eye after the other, of a dome."""
    view.Projection = "azimuthal-equidistant"
    view.InterpupillaryDistance = 0.5
    for side, mode in ((-1, "Left Eye Only"), (1, "Right Eye Only")):
        path = os.path.join(options.output, "eye%d.png" % side)
        picture = scene.save(view, path, StereoMode=mode)
        composited.check_file(options, view, mesh, picture, side)


def check_auto(options, view, mesh):
    """What is classified by each rank for itself, and put together by depth."""
    view.Technique = "Automatic"
    for projection in composited.PROJECTIONS:
        view.Projection = projection
        picture = scene.save(view, os.path.join(options.output, "auto " + projection + ".png"))
        composited.check_file(options, view, mesh, picture)
    view.Technique = "Exact"


def check_idle_ranks(options):
    """The same where all data are on rank 0, in a view of its own."""
    view, mesh, _, _ = composited.show_parts(options, lambda whole: whole)
    path = os.path.join(options.output, "idle.png")
    composited.check_file(options, view, mesh, scene.save(view, path))


def check_reduced(options, view, mesh):
    """With fewer pixels, which ParaView itself draws with several ranks alone."""
    view.Projection = "equirectangular"
    view.StillRenderImageReductionFactor = 4
    picture = scene.save(view, os.path.join(options.output, "few.png"))
    view.StillRenderImageReductionFactor = 1
    composited.check_reduced(options, view, mesh, picture, 4)


def check_volume(options):
    """An image of which each rank has a part, and a ball in it: one rank's picture."""
    view = scene.make_view()
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    image = simple.Wavelet()
    display = simple.Show(image, view)
    display.SetRepresentationType("Volume")
    simple.ColorBy(display, ("POINTS", "RTData"))
    simple.GetOpacityTransferFunction("RTData").Points = [37, 0, 0.5, 0, 277, 0.2, 0.5, 0]
    ball = simple.Sphere(Center=[3, 1, -4], Radius=1.5, ThetaResolution=32, PhiResolution=32)
    simple.Show(ball, view)
    with Log(options, "volume") as log:
        composited.check_volume(options, view)
        warnings = log.count("WARN") + log.count("Warning")
    scene.require(warnings == 0, "%d warnings of a volume" % warnings)


def main(options):
    ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
    scene.load_plugin(options)
    view, mesh, _, display = composited.show_parts(options)
    composited.check_opaque(options, view, mesh)
    check_auto(options, view, mesh)
    check_eyes(options, view, mesh)
    if ranks > 1:
        check_reduced(options, view, mesh)
    composited.check_in_order(options, view, mesh, display)
    composited.check_translucent(options, view, display)
    check_idle_ranks(options)
    check_volume(options)


scene.run(main)
