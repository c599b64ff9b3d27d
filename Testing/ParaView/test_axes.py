# SPDX-License-Identifier: BSD-3-Clause
"""Axes grids, of the view and of data: lines where a formula of the map says, the faces behind the
data from outside, all of them from inside, and labels beside their places; polar axes; on several
ranks as well."""

import math
import os

from paraview import simple
from paraview.modules.vtkRemotingCore import vtkProcessModule

import pixels
import places
import scene
from messages import Log

SIZE = [360, 180]
LARGE = [540, 270]

BOUNDS = (-5, 5), (-4, 4), (-6, 6)
TICKS = (-2.5, 3), (1.5,), (-4, 2.5)  # which are asked for: the choice is ParaView's
INSIDE = [0.53, 0.31, 1.07]
OUTSIDE = [3.1, 9.7, 12.3]
NEAR = [0.53, -3.89, 1.07]  # whose floor's corners are seen at a low angle

# Pixels of the window: a number's nearest corner is 10 from its place; the number is some 25 by 10
# large.
LABEL_GAP = (7, 15)
LABEL_REACH = 40


def faces_of(eye):
    """The sides of the box that the eye sees from inside, each an axis and an end of it."""
    return [(axis, end) for axis in range(3) for end in range(2)
            if (eye[axis] - BOUNDS[axis][end]) * (1 - 2 * end) >= 0]


def lines_of(face):
    """The borders of a face and the lines of its grid."""
    axis, end = face
    for along, across in (((axis + 1) % 3, (axis + 2) % 3), ((axis + 2) % 3, (axis + 1) % 3)):
        for place in BOUNDS[across] + TICKS[across]:
            ends = []
            for extreme in BOUNDS[along]:
                point = [0, 0, 0]
                point[axis], point[along], point[across] = BOUNDS[axis][end], extreme, place
                ends.append(point)
            yield ends


def set_up(grid):
    """Ticks that are known, and nothing but lines."""
    for axis, ticks in zip("XYZ", TICKS):
        setattr(grid, axis + "AxisUseCustomLabels", 1)
        setattr(grid, axis + "AxisLabels", list(ticks))
        setattr(grid, axis + "Title", "")
    grid.ShowGrid = 1
    grid.AxesToLabel = 0


def look_from(view, eye):
    scene.place_eye(view, eye, [eye[0], eye[1], eye[2] - 1])


def picture(options, view, name, size=None):
    return scene.save(view, os.path.join(options.output, name + ".png"), size)


def check_lines(options, view, name):
    """Of the grid that is shown now."""
    for where, eye in (("inside", INSIDE), ("outside", OUTSIDE), ("near", NEAR)):
        look_from(view, eye)
        found = pixels.lit_pixels(picture(options, view, "%s-%s" % (name, where)))
        expected = [p for face in faces_of(eye) for ends in lines_of(face)
                    for p in places.places_of_line(*ends, eye, SIZE)]
        places.check_places("%s, %s:" % (name, where), found, expected, 1, SIZE)


def anchors_of(eye):
    """Where the box has labels of the x axis: on each of its four edges from inside."""
    return [(tick, y, z) for tick in TICKS[0] for y in BOUNDS[1] for z in BOUNDS[2]]


def check_texts(found, anchors, size, factor, count=None):
    """One text beside each place, and nothing else, of so many, for the last may be too close
    together to be told apart."""
    near = {a: [] for a in anchors}
    for pixel in found:
        distances = {a: math.dist(pixel, places.place_of(a, INSIDE, size)) for a in near}
        first = min(distances, key=distances.get)
        near[first].append(distances[first] / factor)
    for anchor, distances in list(near.items())[:count]:
        scene.require(distances, "no label at %s" % (anchor,))
        gap, reach = min(distances), max(distances)
        print("label", size, anchor, len(distances), "pixels", gap, reach, flush=True)
        scene.require(LABEL_GAP[0] < gap < LABEL_GAP[1] and reach < LABEL_REACH, "labels")


def check_labels(options, view):
    """Numbers of one axis alone, in a picture as large as the window and in one of four tiles."""
    grid = view.AxesGrid
    grid.ShowGrid = grid.ShowEdges = grid.ShowTicks = 0
    grid.AxesToLabel = 2 + 4 + 16 + 32  # at the ends of y and z: edges along x, among others
    for axis in "YZ":
        setattr(grid, axis + "AxisLabels", [])
    look_from(view, INSIDE)
    view.ViewSize = LARGE
    for size in (LARGE, [2 * n for n in LARGE]):
        factor = size[0] / LARGE[0]
        found = pixels.lit_pixels(picture(options, view, "labels%d" % factor, size))
        check_texts(found, anchors_of(INSIDE), size, factor)


def check_hidden(options, view):
    """Behind a black wall there are no labels; nor where the grid is switched off."""
    wall = simple.Sphere(Center=INSIDE, Radius=1)
    display = simple.Show(wall, view)
    display.Ambient, display.Diffuse = 1, 0
    display.AmbientColor = display.DiffuseColor = [0, 0, 0]
    lit = pixels.count_lit(picture(options, view, "hidden"))
    simple.Delete(wall)
    scene.require(lit == 0, "labels show through a wall")
    scene.require(pixels.count_lit(picture(options, view, "shown")) > 100, "no labels")
    view.AxesGrid.Visibility = 0
    scene.require(pixels.count_lit(picture(options, view, "off")) == 0, "a grid that is off")


def check_selection(view):
    """A grid is nothing to select, and hides nothing from a selection."""
    ball = simple.Sphere(Center=[-3, 1, -3])
    simple.Show(ball, view)
    simple.Render(view)
    size = list(view.ViewSize)
    found = pixels.select(view, *(round(c) for c in places.place_of(ball.Center, INSIDE, size)))
    line = places.places_of_line((-5, -4, -6), (5, -4, -6), INSIDE, size)[40]
    none = pixels.select(view, *(math.floor(c) for c in line))
    simple.Delete(ball)
    print("selected", found, "on a line of the grid", none)
    scene.require(found and not none, "selection beside a grid")


def show_box(view):
    """Data in the box, which is not drawn but for the grid round it."""
    lengths = [high - low for low, high in BOUNDS]
    box = simple.Box(XLength=lengths[0], YLength=lengths[1], ZLength=lengths[2])
    display = simple.Show(box, view)
    display.Opacity = 0
    return display


def check_flat_camera(options, view):
    """A perspective has ParaView's own grid."""
    view.Projection = "perspective"
    view.HorizontalFieldOfView, view.VerticalFieldOfView = 90, 53
    look_from(view, OUTSIDE)
    view.CameraFocalPoint = [0, 0, 0]
    scene.require(pixels.count_lit(picture(options, view, "perspective")) > 300, "perspective")


def polar_points(radius, angles):
    """Of an arc round the middle of the box."""
    return [(radius * math.cos(a), radius * math.sin(a), 0) for a in angles]


def check_polar(options, view, display):
    """A quarter of polar axes: arcs, axes at 0, 45 and 90 degrees, and the numbers of the first."""
    axes = display.PolarAxes
    # one apart, and the last to the corner of the box; ParaView 5.11 leaves out the last but one,
    # and newer ones are told
    radii = [1, 2, 3, 4, 5]
    for number, step in (("NumberOfPolarAxes", "DeltaRangePolarAxes"), ("NumberOfArcs", "DeltaRangeArcs")):
        if step in axes.ListProperties():
            setattr(axes, number, 0)
            setattr(axes, step, 1)
            radii.append(6)
    radii.append(math.hypot(BOUNDS[0][1], BOUNDS[1][1]))
    # the radial ones are titles in ParaView 5.12 and 5.13, and since 6.0 the ticks are all ticks
    for names in (("PolarLabel",), ("PolarAxisTitle",), ("RadialLabel", "RadialTitle"),
                  ("PolarTicks", "AllTicks"), ("AxisTick",), ("ArcTick",)):
        name = next(n for n in names if n + "Visibility" in axes.ListProperties())
        setattr(axes, name + "Visibility", 0)
    axes.Visibility = 1
    look_from(view, INSIDE)
    quarter = [math.pi / 2 * i / 90 for i in range(91)]
    lines = [polar_points(radius, quarter) for radius in radii]
    lines += [[(0, 0, 0)] + polar_points(radii[-1], [angle]) for angle in quarter[::45]]
    expected = [p for line in lines for ends in zip(line, line[1:])
                for p in places.places_of_line(*ends, INSIDE, SIZE)]
    found = pixels.lit_pixels(picture(options, view, "polar"))
    places.check_places("polar axes", found, expected, 1, SIZE)
    view.ViewSize = LARGE
    without = pixels.lit_pixels(picture(options, view, "polar-lines"))
    axes.PolarLabelVisibility = 1
    found = pixels.lit_pixels(picture(options, view, "polar-numbers")) - without
    check_texts(found, [(radius, 0, 0) for radius in [0] + radii], LARGE, 1, 3)
    axes.Visibility = 0
    view.ViewSize = SIZE


def check_standing(options, view):
    """Texts that stand in the scene are drawn on several ranks as well; where, test_view.py checks."""
    text = simple.Text(Text="MM")
    display = simple.Show(text, view)
    display.FlagSize = 8
    look_from(view, INSIDE)
    place = [INSIDE[0] + 1, INSIDE[1], INSIDE[2] - 1]
    display.BillboardPosition = display.TopPosition = place
    display.BasePosition = [place[0], place[1] - 0.5, place[2]]
    for kind in ("Billboard 3D Text", "Flagpole Actor"):
        display.TextPropMode = kind
        found = pixels.lit_pixels(picture(options, view, kind.split()[0]))
        middle = [sum(c) / len(found) for c in zip(*found)] if found else [0, 0]
        print(kind, len(found), "pixels round", middle)
        far = math.dist(middle, places.place_of(place, INSIDE, SIZE))
        scene.require(len(found) > 100 and far < LABEL_REACH, kind)
    simple.Delete(text)


def check_others(options, view, display):
    """What several ranks would only repeat."""
    check_flat_camera(options, view)
    view.Projection = "equirectangular"
    view.HorizontalFieldOfView, view.VerticalFieldOfView = 360, 180
    view.AxesGrid.Visibility = 0
    set_up(display.DataAxesGrid)
    display.DataAxesGrid.GridAxesVisibility = 1
    check_lines(options, view, "data axes grid")
    display.DataAxesGrid.GridAxesVisibility = 0
    view.AxesGrid.Visibility = 1
    look_from(view, INSIDE)
    check_selection(view)


def main(options):
    scene.load_plugin(options)
    view = scene.make_view(SIZE)
    with Log(options, "messages") as log:
        display = show_box(view)
        set_up(view.AxesGrid)
        view.AxesGrid.Visibility = 1
        check_lines(options, view, "axes grid")
        view.AxesGrid.Visibility = 0
        check_polar(options, view, display)
        check_standing(options, view)
        view.AxesGrid.Visibility = 1
        if vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions() == 1:
            check_others(options, view, display)
        check_labels(options, view)
        check_hidden(options, view)
        said = log.count("WARN") + log.count("ERR")
    scene.require(said == 0, "a message of a grid that is drawn right")


scene.run(main)
