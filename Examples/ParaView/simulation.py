# SPDX-License-Identifier: BSD-3-Clause
"""A simulation that hands each of its steps to Catalyst: a wave that spreads in a box, a slab of
the box on each rank.

    pvbatch --symmetric simulation.py PIPELINE.py [STEPS]

The pipeline is a Catalyst script, for example insitu.py beside this file.
"""

import math
import sys

from paraview.catalyst import bridge
from paraview.modules.vtkRemotingCore import vtkProcessModule
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData

HALF = 16  # the box has so many cells on either side of the origin


def get_rank():
    """This process and how many there are."""
    processes = vtkProcessModule.GetProcessModule()
    return processes.GetPartitionId(), processes.GetNumberOfLocalPartitions()


def compute(step, rank, ranks):
    """The rank's slab of the box at this step."""
    low, high = (-HALF + 2 * HALF * r // ranks for r in (rank, rank + 1))
    slab = vtkImageData()
    slab.SetExtent(-HALF, HALF, -HALF, HALF, low, high)
    wave = vtkFloatArray()
    wave.SetName("wave")
    for i in range(slab.GetNumberOfPoints()):
        wave.InsertNextValue(math.cos(0.6 * math.dist(slab.GetPoint(i), (5, 3, -6)) - 0.7 * step))
    slab.GetPointData().AddArray(wave)
    return slab


def simulate(pipeline, steps, produce=compute, extent=(-HALF, HALF) * 3):
    """So many steps, each of which Catalyst may look at before the next is made."""
    bridge.initialize()
    bridge.add_pipeline(pipeline)
    rank, ranks = get_rank()
    for step in range(steps):
        bridge.coprocess(0.1 * (step + 1), step, produce(step, rank, ranks), wholeExtent=extent)
    bridge.finalize()


if __name__ == "__main__":
    simulate(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3)
