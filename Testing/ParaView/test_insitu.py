# SPDX-License-Identifier: BSD-3-Clause
"""Inside Catalyst: a simulation of this process, on one rank or several, hands over its mesh step
by step; the extractor's pictures show each step as the ray caster sees it."""

import json
import os
import shutil
import sys

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

import scene

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(HERE, "..", "..", "Examples", "ParaView"))

STEPS = 5  # of which the script extracts every other one


def make_mesh(step):
    """All of the simulation's mesh at a step, which moves and turns."""
    move = vtkTransform()
    move.Translate(0.2 * step, -0.1 * step, 0.15 * step)
    move.RotateY(10 * step)
    moved = vtkTransformPolyDataFilter()
    moved.SetTransform(move)
    moved.SetInputData(scene.triangles_of(scene.make_sphere(), scene.make_contours()))
    moved.Update()
    mesh = vtkPolyData()
    mesh.CopyStructure(moved.GetOutput())
    scene.number_cells(mesh)
    return mesh


def take_part(mesh, rank, ranks):
    """The rank's run of cells, with their numbers."""
    first, last = (mesh.GetNumberOfCells() * r // ranks for r in (rank, rank + 1))
    part = vtkPolyData()
    part.ShallowCopy(mesh)
    part.SetPolys(type(mesh.GetPolys())())
    part.GetCellData().Initialize()
    numbers = mesh.GetCellData().GetArray("number")
    mine = numbers.NewInstance()
    mine.SetName("number")
    mine.SetNumberOfComponents(3)
    for cell in range(first, last):
        part.GetPolys().InsertNextCell(mesh.GetCell(cell).GetPointIds())
        mine.InsertNextTuple(numbers.GetTuple(cell))
    part.GetCellData().AddArray(mine)
    return part


def check(options):
    with open(os.path.join(options.output, "view.json")) as file:
        request = json.load(file)
    found = sorted(n for n in os.listdir(options.output) if n.endswith(".png"))
    tolerances = {"Automatic": scene.TOLERANCE, "Exact": scene.EXACT}
    pictures = ["%s-%02d.png" % (t, s) for t in tolerances for s in range(0, STEPS, 2)]
    scene.require(found == pictures, str(found))
    for picture in pictures:
        technique, step = picture[:-len(".png")].split("-")
        mesh, path = (os.path.join(options.output, n) for n in (step + ".vtp", picture))
        answer = scene.check(options, request, mesh, path, tolerances[technique])
        print(picture, answer, flush=True)
        good = scene.is_promised(answer, technique == "Exact") and answer["hits"] > 10000
        scene.require(good, picture)


def main(options):
    os.environ["WIDEFOV_PLUGIN"] = options.plugin
    os.environ["WIDEFOV_PICTURES"] = options.output
    import simulation  # begins nothing

    rank, _ = simulation.get_rank()
    if rank == 0:
        shutil.rmtree(options.output)
        os.makedirs(options.output)

    def produce(step, rank, ranks):
        mesh = make_mesh(step)
        if rank == 0:
            scene.write_polydata(mesh, os.path.join(options.output, "%02d.vtp" % step))
        return take_part(mesh, rank, ranks)

    simulation.simulate(os.path.join(HERE, "insitu_cells.py"), STEPS, produce, None)
    if rank == 0:
        check(options)


scene.run(main)
