# SPDX-License-Identifier: BSD-3-Clause
"""A pvserver of its own for a test, and the connection to it."""

import contextlib
import os
import socket
import subprocess
import time

from paraview import simple

import scene


def _free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


def _environment(changes):
    """Without what makes mpirun take the server for its child; None removes a variable."""
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    clean.update({k: v for k, v in changes.items() if v is not None})
    return {k: v for k, v in clean.items() if changes.get(k, v) is not None}


def _start(ranks, log, environment):
    """The server's process and its port."""
    port = _free_port()
    here = os.path.dirname(os.path.abspath(__file__))
    run = os.path.join(here, "..", "..", "Utilities", "run-paraview.sh")
    prefix = os.environ["WIDEFOV_PARAVIEW_PREFIX"]
    command = ["bash", run, prefix] + ([str(ranks)] if ranks > 1 else [])
    command += ["pvserver", "--server-port=%d" % port]
    # the client is a process of MPI as well
    return subprocess.Popen(command, stdout=log, stderr=log, env=_environment(environment)), port


@contextlib.contextmanager
def connected(log_path, ranks=1, **environment):
    """The session is this server's inside; the path is where it writes what it has to say."""
    with open(log_path, "w") as log:
        server, port = _start(ranks, log, environment)
        try:
            # ParaView tries for 60 seconds by itself, and says so each second
            time.sleep(5)
            simple.Connect("localhost", port)
            scene.require(server.poll() is None, "the server has gone")
            yield server
        finally:
            server.terminate()  # of several ranks it is mpirun, which ends them
            server.wait()


def check_refused(process):
    """A wide view is refused, and other views go on working."""
    try:
        scene.make_view()
    except RuntimeError as error:
        print("refused:", error)
        scene.require("WideFoVView" in str(error), str(error))
    else:
        scene.require(False, "a view where there can be none")
    view = simple.CreateView("RenderView")
    simple.Show(simple.Sphere(), view)
    simple.Render(view)
    scene.require(process.poll() is None, "the server has gone")
