# SPDX-License-Identifier: BSD-3-Clause
"""How long a frame takes on this many ranks of pvbatch: all data shared out, and none.

Prints a line of JSON: ranks, triangles, and medians in milliseconds of a frame of the data, and of a
frame without, which is what the view and IceT's compositing take alone.
"""

import json
import os
import statistics
import time

from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import scene

SIZE = [1024, 512]
FRAMES = 11  # after three that compile and upload


def time_frames(view):
    times = []
    for frame in range(FRAMES + 3):
        # a new frame needs something new
        view.CameraPosition = [0.5 + 1e-4 * frame, 0.3, 1]
        begin = time.perf_counter()
        simple.Render(view)
        view.GetRenderWindow().WaitForCompletion()
        if frame > 2:
            times.append(1000 * (time.perf_counter() - begin))
    return statistics.median(times)


def main(options):
    scene.load_plugin(options)
    wavelet = simple.Wavelet(WholeExtent=[-40, 40, -40, 40, -40, 40])
    surface = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"],
                             Isosurfaces=[120, 140, 160, 180])
    view = scene.make_view(SIZE)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    empty = time_frames(view)
    simple.Show(simple.RedistributeDataSet(Input=surface), view)
    triangles = surface.GetDataInformation().GetNumberOfCells()
    ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
    record = {"ranks": ranks, "triangles": triangles, "data": time_frames(view), "empty": empty}
    print(json.dumps(record), flush=True)
    with open(os.path.join(options.output, "ranks%d.json" % ranks), "w") as out:
        json.dump(record, out)


scene.run(main)
