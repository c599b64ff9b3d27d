# SPDX-License-Identifier: BSD-3-Clause
"""A client and a server of two ranks that draws: pictures against the ray caster, and
selections that give the cells drawn."""

import os
import random
import shutil

from paraview import simple

import pixels
import scene
import server

SERVER_RANKS = 2
SELECTIONS = 40


def check(options, view, source, mesh, projection, dice):
    view.Projection = projection
    path = os.path.join(options.output, projection + ".png")
    answer = scene.check_cells(options, view, mesh, scene.save(view, path), 0.25)
    print(projection, answer)
    scene.require(answer["unexplained"] == 0 and answer["hits"] > 3000, projection)
    pixels.check_selection(view, source, path, SELECTIONS, dice)


def check_eye(options, view, mesh):
    """The right eye of a panorama; both at once are two frames of the server."""
    view.Projection = "equirectangular"
    view.InterpupillaryDistance = 0.5
    scene.save(view, os.path.join(options.output, "eyes.png"), StereoMode="Both Eyes")
    picture = os.path.join(options.output, "eyes_right.png")
    answer = scene.check_cells(options, view, mesh, picture, 0.25, 1)
    print("right eye", answer)
    scene.require(answer["unexplained"] == 0 and answer["hits"] > 3000, "the right eye")


def check_extracts(options, view, mesh):
    """Numbered pictures, drawn by the server's ranks and written by one of them."""
    view.Projection = "equirectangular"
    folder = os.path.join(options.output, "extracts")
    shutil.rmtree(folder, ignore_errors=True)
    extractor = simple.CreateExtractor("WideFoVPicture", view)
    extractor.Writer.Size = scene.SIZE
    # of a single frame ParaView 5.11 divides by zero, and triggers no extractor at all
    simple.GetAnimationScene().NumberOfFrames = 2
    simple.SaveExtracts(ExtractsOutputDirectory=folder)
    found = sorted(os.listdir(folder))
    scene.require(found == ["WideFoVView1_%06d.png" % i for i in range(2)], str(found))
    answer = scene.check_cells(options, view, mesh, os.path.join(folder, found[1]), 0.25)
    print("extract", answer)
    scene.require(answer["unexplained"] == 0 and answer["hits"] > 3000, "an extract")


def draw_and_select(options):
    scene.load_plugin(options, remote=True)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    view = scene.make_view(RemoteRenderThreshold=0)
    source = scene.spread(simple.XMLPolyDataReader(FileName=[mesh]))
    scene.show_cells(source, view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    dice = random.Random(2)
    for projection in ("equirectangular", "azimuthal-equidistant"):
        check(options, view, source, mesh, projection, dice)
    check_eye(options, view, mesh)
    check_extracts(options, view, mesh)


def main(options):
    with server.connected(os.path.join(options.output, "server.log"), SERVER_RANKS):
        draw_and_select(options)


scene.run(main)
