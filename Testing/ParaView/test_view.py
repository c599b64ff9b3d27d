# SPDX-License-Identifier: BSD-3-Clause
"""What people do in a view: hover over a surface, measure, link cameras, put text and legends."""

import math
import os
import random

from paraview import simple
from vtkmodules.vtkCommonCore import vtkSMPTools

import pixels
import places
import scene

CENTRE, RADIUS, SIDES = (4, 1, -3), 2, 96
EYE, FOCAL = (0.5, 0.3, 1), (0.5, 0.3, -1)  # looking down -z

# Units of the scene: sides are flat, and ParaView meets the plane of the side that is drawn at the
# pixel's centre with the ray of its corner.
FLAT = 0.1

# Pixels: a line is one wide, and its pixel's centre is up to half of one beside it.
LINE_TOLERANCE = 1.5

# Of a flagpole label.
FLAG_SIZE = 8

# Pixels: where its letters end, which are drawn from a texture.
FLAG_TOLERANCE = 1.6


def check_hover(view):
    """The point under the mouse is on the surface, and the mouse's ray leads there."""
    dice = random.Random(3)
    found = 0
    middle = place_of(CENTRE)
    for _ in range(60):
        x, y = (round(c) + dice.randrange(-20, 20) for c in middle)  # most of it is the ball's
        point, normal = [0.0] * 3, [0.0] * 3
        if not view.SMProxy.ConvertDisplayToPointOnSurface([x, y], point, normal, False):
            continue
        found += 1
        off = math.dist(point, CENTRE) - RADIUS
        scene.require(abs(off) < FLAT, "a point is %g off the ball" % off)
        seen = place_of(point)
        scene.require(math.dist(seen, (x, y)) < 1, "%s leads to %s" % ((x, y), seen))
    print(found, "points under the mouse")
    scene.require(found >= 20, "no point is found")


def place_of(point):
    """Where the view shows a point; pixels from the lower left."""
    return places.place_of(point, EYE, scene.SIZE)


def check_ruler(options, view):
    """A ruler from the left to the right behind the viewer is an arc across the border."""
    ends = (-3, -1, 3), (3, 2, 4)
    ruler = simple.Ruler(Point1=ends[0], Point2=ends[1])
    simple.Show(ruler, view)
    length = ruler.SMProxy.GetClientSideObject().GetOutputDataObject(0).GetLength()
    scene.require(abs(length - math.dist(*ends)) < 1e-9, "the ruler's length")
    rows = pixels.read_rows(scene.save(view, os.path.join(options.output, "ruler.png")))
    lit = [(i + 0.5, j + 0.5) for j, row in enumerate(rows) for i, n in enumerate(row) if n]
    line = places.places_of_line(*ends, EYE, scene.SIZE)
    lonely = [p for p in line if min(math.dist(p, q) for q in lit) > LINE_TOLERANCE]
    strange = [q for q in lit if min(math.dist(p, q) for p in line) > LINE_TOLERANCE]
    columns = {round(x) for x, _ in lit}
    print("ruler:", len(lit), "pixels, off", len(lonely), len(strange))
    scene.require(not lonely and not strange, "the ruler is elsewhere")
    scene.require(min(columns) < 2 and max(columns) > scene.SIZE[0] - 3, "it is not behind")
    simple.Delete(ruler)


def check_linked(view):
    """A Render View that follows, and leads."""
    other = scene.make_view([100, 100], kind="RenderView")
    simple.AddCameraLink(view, other, "linked")
    for leader, follower, eye in ((view, other, [1, 2, 3]), (other, view, [3, 1, 2])):
        leader.CameraPosition = eye
        simple.Render(leader)
        found = list(follower.CameraPosition)
        scene.require(found == eye, "the other camera is at " + str(found))
    wide = view.SMProxy.GetActiveCamera().GetClassName()
    scene.require(wide == "vtkWideFoVCamera", "the link has put a " + wide + " in")
    simple.RemoveCameraLink("linked")
    simple.Delete(other)


def check_flat(options, view, ball):
    """Text and a legend are drawn over the picture, as in any view."""
    empty = pixels.count_lit(scene.save(view, os.path.join(options.output, "empty.png")))
    text = simple.Text(Text="Text")
    simple.Show(text, view)
    with_text = pixels.count_lit(scene.save(view, os.path.join(options.output, "text.png")))
    display = simple.Show(simple.Elevation(Input=ball), view)
    simple.ColorBy(display, ("POINTS", "Elevation"))
    display.SetScalarBarVisibility(view, True)
    legend = scene.save(view, os.path.join(options.output, "legend.png"))
    print("lit:", empty, with_text, pixels.count_lit(legend))
    scene.require(empty + 10 < with_text < pixels.count_lit(legend) - 300, "annotation")


def box_of(path):
    """The rectangle that the lit pixels are in: its middle and its size."""
    rows = pixels.read_rows(path)
    lit = [(i + 0.5, j + 0.5) for j, row in enumerate(rows) for i, n in enumerate(row) if n]
    scene.require(lit, "nothing is drawn")
    (left, right), (low, high) = ((min(c) - 0.5, max(c) + 0.5) for c in zip(*lit))
    return ((left + right) / 2, (low + high) / 2), (right - left, high - low)


def check_billboard(options, view):
    """Text at a place stands where the picture shows the place, as large as any other text; in a
    picture larger than the window as well; and not where something hides it."""
    text = simple.Text(Text="MM")
    display = simple.Show(text, view)
    display.TextPropMode = "Flagpole Actor"  # the other way round: nothing is taken for granted
    display.TextPropMode = "Billboard 3D Text"
    for size in (scene.SIZE, [2 * n for n in scene.SIZE]):
        for place in ((2.5, 1.5, -1), (-2, -1.5, -1), (9, 0.5, 5)):
            display.BillboardPosition = place
            picture = os.path.join(options.output, "billboard.png")
            middle, (width, height) = box_of(scene.save(view, picture, size))
            factor = size[0] / scene.SIZE[0]
            expected = [factor * c for c in place_of(place)]
            corner = middle[0] - width / 2, middle[1] - height / 2  # the lower left one is its place
            print("billboard", corner, "expected", expected, "size", width, height)
            scene.require(math.dist(corner, expected) < 5, "the text is elsewhere")
            scene.require(10 < height < 40 and 20 < width < 80, "the text has another size")
    wall = simple.Sphere(Center=EYE, Radius=1)
    display.BillboardPosition = [EYE[0] + 3, EYE[1], EYE[2]]
    white = simple.Show(wall, view)
    white.Ambient, white.Diffuse = 1, 0
    white.AmbientColor = white.DiffuseColor = [0, 0, 0]
    hidden = scene.save(view, os.path.join(options.output, "hidden.png"))
    scene.require(pixels.count_lit(hidden) == 0, "text shows through a wall")
    simple.Delete(wall)
    simple.Delete(text)


def show_flagpole(view, text):
    display = simple.Show(text, view)
    display.TextPropMode = "Flagpole Actor"
    display.FlagSize = FLAG_SIZE
    return display


def measure_flag(options, text):
    """How far a flag reaches to both sides of its pole's top, down and up, in the middle of ParaView's
    own view of the same height."""
    view = scene.make_view(kind="RenderView")
    scene.place_eye(view, EYE, FOCAL)
    display = show_flagpole(view, text)
    display.BasePosition, display.TopPosition = [0.5, 0.2999, -1], [0.5, 0.3, -1]
    simple.Render(view)
    simple.ResetCamera(view)
    scene.place_eye(view, EYE, FOCAL)
    middle, size = box_of(scene.save(view, os.path.join(options.output, "flag-flat.png")))
    simple.Delete(view)
    x, y = middle[0] - scene.SIZE[0] / 2, middle[1] - scene.SIZE[1] / 2
    return x - size[0] / 2, x + size[0] / 2, y - size[1] / 2, y + size[1] / 2


def check_flag(options, view, ends, name, expected):
    """A pole between its ends, and its flag on the top of it."""
    lit = pixels.lit_pixels(scene.save(view, os.path.join(options.output, name + ".png")))
    line = places.places_of_line(*ends, EYE, scene.SIZE)
    pole = places.pixels_near(line, LINE_TOLERANCE, scene.SIZE)
    lonely = [p for p in line if not places.pixels_near([p], LINE_TOLERANCE, scene.SIZE) & lit]
    top = place_of(ends[1])
    half = scene.SIZE[0] / 2
    # to the right of the top and above it, the nearer way round the picture
    flag = [((x + 0.5 - top[0] + half) % (2 * half) - half, y + 0.5 - top[1]) for x, y in lit - pole]
    (left, right), (low, high) = ((min(c) - 0.5, max(c) + 0.5) for c in zip(*flag))
    print(name, (left, right, low, high), "expected", expected, "pole missing", len(lonely))
    off = max(abs(a - b) for a, b in zip((left, right, low, high), expected))
    scene.require(not lonely and off < FLAG_TOLERANCE, "a flagpole is elsewhere")


def check_flagpole(options, view):
    """Level with the eye, where the map stretches nothing, and on its border."""
    text = simple.Text(Text="MM")
    expected = measure_flag(options, text)
    display = show_flagpole(view, text)
    for name, ends in (("flag", ((4, -1, -2), (4, 0.3, -2))),
                       ("flag-behind", ((0.5, -2, 6), (0.5, 0.3, 6)))):
        display.BasePosition, display.TopPosition = ends
        check_flag(options, view, ends, name, expected)
    scene.require(display.FlagSize == FLAG_SIZE, "the flag's size is changed")
    simple.Delete(text)


def check_axes(options, view, ball):
    """The axes in the corner are small and in their corner; those at the centre are lines there."""
    view.OrientationAxesVisibility = 1
    middle, size = box_of(scene.save(view, os.path.join(options.output, "orientation.png")))
    print("orientation axes", middle, size)
    scene.require(middle[0] < 60 and middle[1] < 60 and max(size) < 80, "orientation axes")
    view.OrientationAxesVisibility = 0
    simple.Show(ball, view)  # whose size is that of the axes
    view.CenterOfRotation = [-3, 1, -2]
    path = os.path.join(options.output, "centre.png")
    without = pixels.read_rows(scene.save(view, path))
    view.CenterAxesVisibility = 1
    rows = pixels.read_rows(scene.save(view, path))
    lines = [(i, j) for j, row in enumerate(rows) for i, n in enumerate(row) if n != without[j][i]]
    scene.require(lines, "no axes at the centre")
    middle = [sum(c) / len(lines) for c in zip(*lines)]
    print("centre axes", middle, place_of([-3, 1, -2]))
    scene.require(math.dist(middle, place_of([-3, 1, -2])) < 12, "centre axes")
    view.CenterAxesVisibility = 0
    simple.Hide(ball, view)


def check_threads(view):
    """Triangles are classified by threads, also where ParaView's own loops are not, as they are not
    afterwards either. Where they are, by the same."""
    before, inside = vtkSMPTools.GetBackend(), []
    first = 1.0  # before the view's own observer
    renderer = view.GetRenderer()
    tag = renderer.AddObserver("EndEvent", lambda *_: inside.append(vtkSMPTools.GetBackend()), first)
    simple.Render(view)
    renderer.RemoveObserver(tag)
    print("loops by", before, "in a frame", inside, "afterwards", vtkSMPTools.GetBackend())
    scene.require(inside and set(inside) == {"STDThread" if before == "Sequential" else before}, "no threads in a frame")
    scene.require(vtkSMPTools.GetBackend() == before, "another backend afterwards")


def check_first_eye(view, ball):
    """The first reset, which ParaView does by itself, puts the eye into the data where more than half
    of all directions is seen; else, and later, it stands back."""
    narrow = scene.make_view(HorizontalFieldOfView=180)
    simple.Show(ball, narrow)
    for name, shown in (("narrow", narrow), ("first", view), ("second", view)):
        simple.ResetCamera(shown)
        off = math.dist(shown.CameraPosition, CENTRE)
        print("the eye from the middle:", name, off)
        scene.require(off < 0.01 if name == "first" else off > RADIUS, "the first eye is elsewhere")
    simple.Delete(narrow)


def main(options):
    scene.load_plugin(options)
    view = scene.make_view()
    ball = simple.Sphere(Center=CENTRE, Radius=RADIUS, ThetaResolution=SIDES, PhiResolution=SIDES)
    simple.Show(ball, view)
    check_first_eye(view, ball)
    scene.place_eye(view, EYE, FOCAL)
    simple.Render(view)
    check_threads(view)
    check_hover(view)
    simple.Hide(ball, view)
    check_ruler(options, view)
    check_billboard(options, view)
    check_flagpole(options, view)
    check_axes(options, view, ball)
    check_linked(view)
    check_flat(options, view, ball)


scene.run(main)
