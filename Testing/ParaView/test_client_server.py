# SPDX-License-Identifier: BSD-3-Clause
"""A client and a server that draws, of as many ranks as are asked for: pictures as those of
pvbatch, also where the client draws itself, and extracts."""

import os
import shutil

from paraview import simple

import composited
import scene
import server


def check_eye(options, view, mesh):
    """The right eye of a panorama; both at once are two frames of the server."""
    view.Projection = "equirectangular"
    view.InterpupillaryDistance = 0.5
    scene.save(view, os.path.join(options.output, "eyes.png"), StereoMode="Both Eyes")
    picture = os.path.join(options.output, "eyes_right.png")
    composited.check_file(options, view, mesh, picture, 1)


def check_extracts(options, view, mesh):
    """Numbered pictures, drawn by the server's ranks and written by one of them."""
    folder = os.path.join(options.output, "extracts")
    shutil.rmtree(folder, ignore_errors=True)
    extractor = simple.CreateExtractor("WideFoVPicture", view)
    extractor.Writer.Size = scene.SIZE
    # of a single frame ParaView 5.11 divides by zero, and triggers no extractor at all
    simple.GetAnimationScene().NumberOfFrames = 2
    scene.save_extracts(folder, 2)
    found = sorted(os.listdir(folder))
    scene.require(found == ["WideFoVView1_%06d.png" % i for i in range(2)], str(found))
    composited.check_file(options, view, mesh, os.path.join(folder, found[1]))


def check_opaque(options, view, mesh, remote):
    """Drawn by the server, or by the client, which gets the data."""
    view.RemoteRenderThreshold = 0 if remote else 1000  # megabytes
    composited.check_opaque(options, view, mesh)
    drawn = view.GetClientSideObject().GetUseDistributedRenderingForRender()
    scene.require(drawn == remote, "who draws")


def draw(options):
    scene.load_plugin(options, remote=True)
    view, mesh, _, display = composited.show_parts(options)
    check_opaque(options, view, mesh, False)
    check_opaque(options, view, mesh, True)
    check_eye(options, view, mesh)
    check_extracts(options, view, mesh)
    composited.check_in_order(options, view, mesh, display)
    composited.check_translucent(options, view, display)


def main(options):
    with server.connected(os.path.join(options.output, "server.log"), options.server_ranks):
        draw(options)


scene.run(main)
