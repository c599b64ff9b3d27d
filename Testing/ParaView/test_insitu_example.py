# SPDX-License-Identifier: BSD-3-Clause
"""The example of a simulation with Catalyst, as the documentation runs it: on two ranks the
pictures of one rank, another one each step."""

import os
import shutil
import subprocess

import pixels
import scene
import server

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
EXAMPLES = os.path.join(ROOT, "Examples", "ParaView")
STEPS = 3
SIZE = 512

# Of 255: two ranks add up the slopes of their slabs' border in another order.
ROUNDING = 2

# Pixels at the edges of what two ranks have composited.
EDGES = 0.0001 * SIZE * SIZE


def simulate(options, ranks):
    """Runs it; returns the pictures."""
    folder = os.path.join(options.output, "ranks%d" % ranks)
    shutil.rmtree(folder, ignore_errors=True)
    environment = server.make_environment(
        {"WIDEFOV_PLUGIN": options.plugin, "WIDEFOV_PICTURES": folder})
    answer = subprocess.run(
        ["bash", os.path.join(ROOT, "Utilities", "run-paraview.sh"),
         os.environ["WIDEFOV_PARAVIEW_PREFIX"], str(ranks), "pvbatch", "--symmetric",
         os.path.join(EXAMPLES, "simulation.py"), os.path.join(EXAMPLES, "insitu.py"), str(STEPS)],
        env=environment, capture_output=True, text=True, check=False)
    print(answer.stdout, answer.stderr)
    # Catalyst goes on after a script that fails: what counts is what it says, and the pictures
    scene.require(answer.returncode == 0 and "Traceback" not in answer.stderr, "the run")
    found = sorted(os.listdir(folder))
    scene.require(found == ["dome_%06d.png" % i for i in range(STEPS)], str(found))
    return [os.path.join(folder, name) for name in found]


def main(options):
    alone, both = (simulate(options, ranks) for ranks in (1, 2))
    for step, (first, second) in enumerate(zip(alone, both)):
        other = pixels.count_other(first, second, ROUNDING)
        print("step", step, "pixels that differ between one rank and two:", other)
        scene.require(other <= EDGES, "two ranks show something else")
    moved = [pixels.count_other(a, b, ROUNDING) for a, b in zip(alone, alone[1:])]
    print("pixels that differ from step to step:", moved)
    scene.require(min(moved) > 0.1 * SIZE * SIZE, "the pictures stand still")


scene.run(main)
