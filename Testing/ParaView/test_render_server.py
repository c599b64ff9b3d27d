# SPDX-License-Identifier: BSD-3-Clause
"""A client, a server that has the data and another that draws them."""

import composited
import scene
import server


def main(options):
    with server.connected_apart(options.output, options.server_ranks):
        scene.load_plugin(options, remote=True)
        view, mesh, _, display = composited.show_parts(options, RemoteRenderThreshold=0)
        composited.check_opaque(options, view, mesh)
        composited.check_in_order(options, view, mesh, display)
        composited.check_translucent(options, view, display)


scene.run(main)
