# SPDX-License-Identifier: BSD-3-Clause
"""Selecting a pixel gives the cell that is drawn there, in this process or on a server's ranks."""

import os
import random

import composited
import pixels
import scene
import server

# In all, of which each is a selection of its own.
PIXELS = 1000

# Further ones, of data whose ranks are put over each other in order.
IN_ORDER = 40

PROJECTIONS = ["equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap"]


def select(options, **properties):
    view, _, source, display = composited.show_parts(options, Technique="Automatic", **properties)
    dice = random.Random(1)
    for projection in PROJECTIONS:
        view.Projection = projection
        picture = scene.save(view, os.path.join(options.output, projection + ".png"))
        pixels.check_selection(view, source, picture, PIXELS // len(PROJECTIONS), dice)
    # ParaView 5.11 shares out such data anew, and gives a cell the rank of one of its points, in its
    # own Render View as well
    composited.show_in_order(display)
    pixels.check_selection(view, source, picture, IN_ORDER, dice, ranks=False)


def main(options):
    if not options.server_ranks:
        scene.load_plugin(options)
        select(options)
        return
    with server.connected(os.path.join(options.output, "server.log"), options.server_ranks):
        scene.load_plugin(options, remote=True)
        select(options, RemoteRenderThreshold=0)


scene.run(main)
