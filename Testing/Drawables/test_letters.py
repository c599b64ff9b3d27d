# SPDX-License-Identifier: BSD-3-Clause
"""Letters that are to be so many pixels large: those of cube axes, grids and flags, ahead and behind, on the
screen and in a screenshot, which VTK draws by a copy of the camera.

    test_letters.py FOLDER

FOLDER has the package widefov. As many pixels are to be covered as by stock VTK, but for how labels lie
on each other: it is a sixth of the height, and so a thirtieth, where they go by a camera of 30 degrees.
"""

import math
import sys

NEAR = 2.0  # times as many pixels, or as few


def axes(stage):
    import vtk

    made = vtk.vtkCubeAxesActor()
    made.SetBounds(-1, 1, -1, 1, -1, 0)
    made.SetCamera(stage.renderer.GetActiveCamera())
    made.SetFlyModeToStaticEdges()
    made.SetScreenSize(20)
    for axis in "XYZ":
        getattr(made, "%sAxisTickVisibilityOff" % axis)()
    stage.renderer.AddViewProp(made)


def grid(stage):
    """Its numbers alone."""
    import vtk

    made = vtk.vtkGridAxesActor3D()
    for axis in range(3):
        made.SetUseCustomLabels(axis, True)
        made.SetNumberOfLabels(axis, 2)
        for i in range(2):
            made.SetLabel(axis, i, i - 0.5)
    made.GenerateGridOff()
    made.GenerateEdgesOff()
    made.GenerateTicksOff()
    stage.renderer.AddViewProp(made)


def flag(stage):
    import vtk

    made = vtk.vtkFlagpoleLabel()
    made.SetInput("MMM")
    made.SetBasePosition(0, -0.1, 0)
    made.SetTopPosition(0, 0, 0)
    stage.renderer.AddViewProp(made)


def screenshot(stage):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(stage.window)
    grab.ReadFrontBufferOff()
    grab.Update()
    picture = grab.GetOutput()
    width, height, _ = picture.GetDimensions()
    return vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(height, width, 3).astype(int)


def count(kind):
    """Covered pixels: of stock VTK, and of each wide picture by its name."""
    import vtk

    import draw

    stock = draw.Stage(vtk.vtkRenderer(), draw.SIZE)
    # pixels of the same angle in the middle
    stock.renderer.GetActiveCamera().SetViewAngle(2 * math.degrees(math.atan(math.pi / 2)))
    put = {"axes": axes, "grid": grid, "flag": flag}[kind]
    put(stock)
    stock.renderer.ResetCameraClippingRange()
    stock.draw()
    found = {"stock": int(draw.covered(stock.draw()).sum())}
    for name, gaze in (("ahead", (0, 0.1, -1)), ("behind", (0.5, 0.1, 1))):
        wide = draw.wide_stage()
        put(wide)
        wide.look(gaze, (0, 1, 0))
        for _ in range(3):  # a view that stands
            wide.draw()
        found[name] = int(draw.covered(wide.draw()).sum())
        found[name + ", screenshot"] = int(draw.covered(screenshot(wide)).sum())
    return found


def has_grids(_):
    import vtk

    return hasattr(vtk, "vtkGridAxesActor3D")  # since 9.5


def main(folder):
    sys.path.insert(0, folder)
    import forked

    faults = []
    for kind in ("axes", "grid", "flag") if forked.run(has_grids, None) else ("axes", "flag"):
        found = forked.run(count, kind)
        print(kind, found)
        stock = found.pop("stock", 0)
        faults += [
            "%s, %s" % (kind, name)
            for name, n in found.items()
            if "crash" in found or not stock / NEAR < n < stock * NEAR
        ]
    print("wrong: %s" % ("; ".join(faults) or "none"))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
