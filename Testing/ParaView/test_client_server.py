# SPDX-License-Identifier: BSD-3-Clause
"""A client and a server of two ranks that draws: pictures against the ray caster, and
selections that give the cells drawn."""

import os
import random
import socket
import subprocess
import time

from paraview import simple

import pixels
import scene

SERVER_RANKS = "2"
SELECTIONS = 40


def start_server(log):
    """The server's process and its port."""
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        port = probe.getsockname()[1]
    here = os.path.dirname(os.path.abspath(__file__))
    run = os.path.join(here, "..", "..", "Utilities", "run-paraview.sh")
    prefix = os.environ["WIDEFOV_PARAVIEW_PREFIX"]
    command = ["bash", run, prefix, SERVER_RANKS, "pvserver", "--server-port=%d" % port]
    # the client is a process of MPI as well, and mpirun must not take the server for its child
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    return subprocess.Popen(command, stdout=log, stderr=log, env=clean), port


def connect(port, server):
    # ParaView tries for 60 seconds by itself, and says so each second
    time.sleep(5)
    simple.Connect("localhost", port)
    scene.require(server.poll() is None, "the server has gone")


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


def draw_and_select(options, server, port):
    connect(port, server)
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


def main(options):
    with open(os.path.join(options.output, "server.log"), "w") as log:
        server, port = start_server(log)
        try:
            draw_and_select(options, server, port)
        finally:
            server.terminate()  # mpirun, which ends its ranks
            server.wait()


scene.run(main)
