# SPDX-License-Identifier: BSD-3-Clause
"""A pvserver of its own for a test, and the connection to it."""

import contextlib
import os
import socket
import subprocess
import time

from paraview import simple

import scene

# A server may take so long to listen, on a busy machine.
SECONDS = 60


def _free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


def make_environment(changes):
    """Without what makes mpirun take the server for its child; None removes a variable."""
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    clean.update({k: v for k, v in changes.items() if v is not None})
    return {k: v for k, v in clean.items() if changes.get(k, v) is not None}


def _wait(process, log_path):
    """Until the server listens, or has gone: ParaView's client would try again each second, and
    say so."""
    end = time.monotonic() + SECONDS
    while process.poll() is None and time.monotonic() < end:
        with open(log_path) as log:
            if "Accepting connection" in log.read():
                return
        time.sleep(0.1)


@contextlib.contextmanager
def _running(program, log_path, ranks, environment):
    """The process of one of ParaView's servers, and its port."""
    port = _free_port()
    here = os.path.dirname(os.path.abspath(__file__))
    run = os.path.join(here, "..", "..", "Utilities", "run-paraview.sh")
    prefix = os.environ["WIDEFOV_PARAVIEW_PREFIX"]
    command = ["bash", run, prefix] + ([str(ranks)] if ranks > 1 else [])
    command += [program, "-p", str(port)]
    with open(log_path, "w") as log:
        # the client is a process of MPI as well
        process = subprocess.Popen(command, stdout=log, stderr=log, env=make_environment(environment))
        try:
            _wait(process, log_path)
            yield process, port
        finally:
            process.terminate()  # of several ranks it is mpirun, which ends them
            process.wait()


@contextlib.contextmanager
def connected(log_path, ranks=1, **environment):
    """The session is this server's inside; the path is where it writes what it has to say."""
    with _running("pvserver", log_path, ranks, environment) as (server, port):
        simple.Connect("localhost", port)
        scene.require(server.poll() is None, "the server has gone")
        yield server


@contextlib.contextmanager
def connected_apart(folder, ranks):
    """The same of two servers, one for the data and one that draws, of so many ranks each."""
    data_log = os.path.join(folder, "data-server.log")
    render_log = os.path.join(folder, "render-server.log")
    with _running("pvdataserver", data_log, ranks, {}) as (data, data_port):
        with _running("pvrenderserver", render_log, ranks, {}) as (render, render_port):
            simple.Connect("localhost", data_port, "localhost", render_port)
            scene.require(data.poll() is None and render.poll() is None, "a server has gone")
            yield


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
