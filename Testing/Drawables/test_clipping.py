# SPDX-License-Identifier: BSD-3-Clause
"""Automatic clip spheres hold all that a prop draws, alone in a scene and in its first frame, whatever
its bounds are.

    test_clipping.py FOLDER [NAME...]

FOLDER has the package widefov. Props are moved by a user transform where they have one; props and
representations of widgets are drawn with automatic clip spheres and with ones that clip nothing.
"""

import sys

SHARE = 0.01  # of what is covered without clipping, that may be missing
WIDE = (1e-3, 1e3)  # clip radii that clip nothing of what is drawn
OTHERWISE = {"vtkLegendScaleActor": "its numbers go by the depth of the scene"}


def prop_of(name, stage):
    """The prop in the stage, moved if it can be."""
    import recipes
    import vtk

    prop = recipes.make(name)
    if hasattr(prop, "SetUserTransform"):
        transform = vtk.vtkTransform()
        transform.Translate(6, 1, 0)
        transform.RotateY(40)
        transform.Scale(1.5, 1.5, 1.5)
        prop.SetUserTransform(transform)
    stage.add(prop)
    return prop


def show(asked):
    """The pixels of the first frame covered without clipping, and the share of them that automatic
    clip spheres lose."""
    import draw
    import vtk
    import widgets

    kind, name = asked
    vtk.vtkOutputWindow.SetInstance(vtk.vtkStringOutputWindow())
    covered = []
    for clips in (False, True):
        stage = draw.wide_stage()
        if not clips:
            stage.renderer.GetActiveCamera().SetClipRadii(*WIDE)
        if kind == "props":
            kept = prop_of(name, stage)
        else:
            stage.draw()  # representations ask where the picture is
            kept = widgets.representation(name, stage.renderer)
        covered.append(draw.covered(stage.draw()))
        del kept
    seen, clipped = covered
    return [int(seen.sum()), int((seen & ~clipped).sum())]


def names_of(kind):
    import classes

    return getattr(classes, kind)()


def main(folder, *wanted):
    sys.path.insert(0, folder)
    import forked

    drawn = 0
    faults = []
    for kind in ("props", "representations"):
        names = [n for n in forked.run(names_of, kind) if n in wanted or not wanted]
        for name in [n for n in names if n not in OTHERWISE]:
            found = forked.run(show, (kind, name))
            if "crash" in found:
                continue  # test_drawables.py says which of these end a process of stock VTK, too
            seen, lost = found
            drawn += seen > 0
            if lost > SHARE * seen:
                faults.append("%s: %d of %d pixels are lost" % (name, lost, seen))
    print("%d drawn; wrong: %s" % (drawn, "; ".join(faults) or "none"))
    return 1 if faults or not drawn else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
