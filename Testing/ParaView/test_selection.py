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

PROJECTIONS = ["equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap"]


def select(options, **properties):
    view, _, source, _ = composited.show_parts(options, **properties)
    dice = random.Random(1)
    for projection in PROJECTIONS:
        view.Projection = projection
        picture = scene.save(view, os.path.join(options.output, projection + ".png"))
        pixels.check_selection(view, source, picture, PIXELS // len(PROJECTIONS), dice)


def main(options):
    if not options.server_ranks:
        scene.load_plugin(options)
        select(options)
        return
    with server.connected(os.path.join(options.output, "server.log"), options.server_ranks):
        scene.load_plugin(options, remote=True)
        select(options, RemoteRenderThreshold=0)


scene.run(main)
