# SPDX-License-Identifier: BSD-3-Clause
"""Where the tops of labels point: on a dome all round the audience, and as LabelUp says.

    test_label_up.py FOLDER [PICTURES]

FOLDER has the package widefov. A label that is a quarter of a turn farther round the dome is the same in a
picture that is turned by as much. PICTURES: a folder for what is drawn.
"""

import math
import os
import sys

SIZE = 400  # pixels
ELEVATION = 30  # degrees
APART = 2  # pixels: letters are put on whole ones, and stand at any angle
SHARE = 0.05  # of what is covered, that may be farther from the turned picture


def place(azimuth, elevation=ELEVATION, distance=5):
    a, e = math.radians(azimuth), math.radians(elevation)
    flat = distance * math.cos(e)
    return (flat * math.sin(a), distance * math.sin(e), -flat * math.cos(a))


def points(azimuth):
    """One, with its label."""
    import vtk

    data = vtk.vtkPolyData()
    data.SetPoints(vtk.vtkPoints())
    data.GetPoints().InsertNextPoint(place(azimuth))
    names = vtk.vtkStringArray()
    names.SetName("names")
    names.InsertNextValue("T.")
    data.GetPointData().AddArray(names)
    return data


def style(text):
    text.SetFontSize(40)
    text.SetJustificationToCentered()
    text.SetVerticalJustificationToCentered()
    text.SetColor(1, 1, 1)
    text.BoldOff()
    text.ItalicOff()
    text.ShadowOff()


def overlay(mapper, renderer):
    import vtk

    actor = vtk.vtkActor2D()
    actor.SetMapper(mapper)
    renderer.AddViewProp(actor)


def placed(azimuth, renderer, shape=False):
    import vtk

    hierarchy = vtk.vtkPointSetToLabelHierarchy()
    hierarchy.SetInputData(points(azimuth))
    hierarchy.SetLabelArrayName("names")
    style(hierarchy.GetTextProperty())
    if shape:  # that of centred letters is beside them in stock VTK
        hierarchy.GetTextProperty().SetJustificationToLeft()
        hierarchy.GetTextProperty().SetVerticalJustificationToBottom()
    mapper = vtk.vtkLabelPlacementMapper()
    mapper.SetInputConnection(hierarchy.GetOutputPort())
    if shape:
        mapper.SetShapeToRect()
        mapper.SetStyleToFilled()
        mapper.SetMargin(4)
        mapper.SetBackgroundColor(0.6, 0, 0)
    overlay(mapper, renderer)


def boxed(azimuth, renderer):
    placed(azimuth, renderer, True)


def labeled(azimuth, renderer, kind="vtkLabeledDataMapper"):
    import vtk

    mapper = getattr(vtk, kind)()
    mapper.SetInputData(points(azimuth))
    mapper.SetLabelModeToLabelFieldData()
    mapper.SetFieldDataName("names")
    style(mapper.GetLabelTextProperty())
    overlay(mapper, renderer)


def dynamic(azimuth, renderer):
    labeled(azimuth, renderer, "vtkDynamic2DLabelMapper")


def billboard(azimuth, renderer):
    import vtk

    text = vtk.vtkBillboardTextActor3D()
    text.SetInput("T.")
    text.SetPosition(place(azimuth))
    style(text.GetTextProperty())
    renderer.AddViewProp(text)


def flag(azimuth, renderer):
    import vtk

    made = vtk.vtkFlagpoleLabel()
    made.SetInput("T.")
    made.SetBasePosition(*place(azimuth, 10))
    made.SetTopPosition(*place(azimuth))
    style(made.GetTextProperty())
    renderer.AddViewProp(made)


def measure(kind, azimuth, renderer):
    """What keeps its text, a follower, to itself."""
    import vtk

    made = getattr(vtk, kind)()
    made.SetRenderer(renderer)
    made.SetHandleRepresentation(vtk.vtkPointHandleRepresentation3D())
    made.InstantiateHandleRepresentation()
    made.SetPoint1WorldPosition(place(azimuth - 25))
    made.SetPoint2WorldPosition(place(azimuth + 25))
    for scale in ("SetLabelScale", "SetTextActorScale"):
        if hasattr(made, scale):
            getattr(made, scale)((0.7, 0.7, 0.7))
    if hasattr(made, "SetCenterWorldPosition"):
        made.SetCenterWorldPosition(place(azimuth, 10))
    made.SetVisibility(True)
    made.BuildRepresentation()
    renderer.AddViewProp(made)


def distance(azimuth, renderer):
    measure("vtkDistanceRepresentation3D", azimuth, renderer)


def angle(azimuth, renderer):
    measure("vtkAngleRepresentation3D", azimuth, renderer)


# First place of each label, degrees round the dome, and quarters of a turn to its other places. VTK puts
# labels of vtkDynamic2DLabelMapper into the plane z = 0.
ALL_ROUND = (0, (1, 2, 3))
PLANE = (90, (2,))
FUNCTIONS = (placed, boxed, labeled, dynamic, billboard, flag, distance, angle)
KINDS = {f.__name__: f for f in FUNCTIONS}
LETTERS = ("placed", "labeled", "dynamic", "billboard")


def show(asked):
    """The covered pixels of a dome's picture, rows from above, and what was said."""
    import draw
    import vtk
    import widefov

    kind, azimuth, up = asked
    heard = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(heard)
    stage = draw.Stage(widefov.vtkWideFoVRenderer(), (SIZE, SIZE))
    stage.renderer.SetEnvironmentUp(0, 0, -1)
    camera = stage.renderer.GetActiveCamera()
    camera.SetProjection("azimuthal-equidistant")
    camera.SetFieldOfView(180)
    camera.SetTilt(90)
    camera.SetPosition(0, 0, 0)
    camera.SetFocalPoint(0, 0, -1)
    if up:
        getattr(stage.renderer.GetPass(), "SetLabelUpTo" + up)()
    stage.draw()  # labels ask where the picture is
    KINDS[kind](azimuth, stage.renderer)
    stage.draw()
    return {"seen": draw.covered(stage.draw()[::-1]).tolist(), "said": heard.GetOutput()}


def apart(one, other):
    """The share of what either covers that is farther from the other than it may be."""
    import draw

    either = max(1, int((one | other).sum()))
    alone = (one & ~draw.grown(other, APART)).sum() + (other & ~draw.grown(one, APART)).sum()
    return float(alone) / either


def top_heavy(seen):
    """A letter T has more above the middle of its height than below."""
    rows = seen.any(1).nonzero()[0]
    middle = (rows[0] + rows[-1] + 1) // 2
    return int(seen[rows[0] : middle].sum()) > 1.1 * int(seen[middle : rows[-1] + 1].sum())


class Gallery:
    """Draws, and keeps what is wrong."""

    def __init__(self, folder):
        self.folder = folder
        self.faults = []

    def show(self, kind, azimuth, up=None):
        import forked
        import numpy

        result = forked.run(show, (kind, azimuth, up), 300)
        name = "%s at %d, up %s" % (kind, azimuth, up or "by default")
        self.check(name + " is drawn", "crash" not in result, result.get("crash", ""))
        self.check(name + " says nothing", not result.get("said"), result.get("said", ""))
        seen = numpy.array(result.get("seen", numpy.zeros((SIZE, SIZE))), bool)
        self.check(name + " is seen", seen.sum() > 50, int(seen.sum()))
        if self.folder:
            from PIL import Image

            path = os.path.join(self.folder, "%s-%d-%s.png" % (kind, azimuth, up))
            Image.fromarray((255 * seen).astype("uint8")).save(path)
        return seen

    def check(self, what, right, figure):
        if not right:
            self.faults.append("%s: %s" % (what, figure))


def check_round(gallery, kind):
    import numpy

    azimuth, quarters = PLANE if kind == "dynamic" else ALL_ROUND
    first = gallery.show(kind, azimuth)
    if kind in LETTERS:
        upright = numpy.rot90(first, -azimuth // 90)
        gallery.check("%s points to the centre" % kind, top_heavy(upright), "it does not")
    for quarter in quarters:
        share = apart(gallery.show(kind, azimuth + 90 * quarter), numpy.rot90(first, quarter))
        print("%-10s %3d degrees round: %.3f apart" % (kind, 90 * quarter, share), flush=True)
        gallery.check("%s, %d degrees round" % (kind, 90 * quarter), share <= SHARE, share)


def check_property(gallery, kind):
    for azimuth in (0, 90, 180):
        seen = gallery.show(kind, azimuth, "Picture")
        gallery.check("%s at %d stands upright in the picture" % (kind, azimuth), top_heavy(seen), "not")
    zenith = gallery.show(kind, 180, "Zenith")
    gallery.check("%s, zenith" % kind, top_heavy(zenith[::-1]), "it stands otherwise")
    world = gallery.show(kind, 0, "World")  # up is ahead
    gallery.check("%s, world" % kind, top_heavy(world[::-1]), "it stands otherwise")


def main(folder, pictures=None):
    sys.path.insert(0, folder)
    gallery = Gallery(pictures)
    for kind in KINDS:
        check_round(gallery, kind)
    for kind in ("placed", "labeled", "billboard"):
        check_property(gallery, kind)
    print("wrong: %s" % ("; ".join(gallery.faults) or "none"))
    return 1 if gallery.faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
