# SPDX-License-Identifier: BSD-3-Clause
"""Letters that are to be so many pixels large: those of cube axes, ahead and behind, on the screen and in
a screenshot, which VTK draws by a copy of the camera.

    test_letters.py FOLDER

FOLDER has the package widefov. As many pixels are to be covered as by stock VTK, but for how labels lie
on each other: it is a sixth of the height, and so a thirtieth, where they go by a camera of 30 degrees.
"""

import math
import sys

NEAR = 2.0  # times as many pixels, or as few


def axes(stage, bounds):
    import vtk

    made = vtk.vtkCubeAxesActor()
    made.SetBounds(bounds)
    made.SetCamera(stage.renderer.GetActiveCamera())
    made.SetFlyModeToStaticEdges()
    made.SetScreenSize(20)
    for axis in "XYZ":
        getattr(made, "%sAxisTickVisibilityOff" % axis)()
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


def count(_):
    """Covered pixels: of stock VTK, and of each wide picture by its name."""
    import vtk

    import draw

    stock = draw.Stage(vtk.vtkRenderer(), draw.SIZE)
    # pixels of the same angle in the middle
    stock.renderer.GetActiveCamera().SetViewAngle(2 * math.degrees(math.atan(math.pi / 2)))
    axes(stock, (-1, 1, -1, 1, -1, 0))
    stock.renderer.ResetCameraClippingRange()
    stock.draw()
    found = {"stock": int(draw.covered(stock.draw()).sum())}
    for name, gaze in (("ahead", (0, 0.1, -1)), ("behind", (0.5, 0.1, 1))):
        wide = draw.wide_stage()
        axes(wide, (-1, 1, -1, 1, -1, 0))
        wide.look(gaze, (0, 1, 0))
        wide.draw()
        found[name] = int(draw.covered(wide.draw()).sum())
        found[name + ", screenshot"] = int(draw.covered(screenshot(wide)).sum())
    return found


def main(folder):
    sys.path.insert(0, folder)
    import forked

    found = forked.run(count, "")
    print(found)
    if "crash" in found:
        return 1
    stock = found.pop("stock")
    wrong = [name for name, n in found.items() if not stock / NEAR < n < stock * NEAR]
    print("wrong: %s" % (", ".join(wrong) or "none"))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
