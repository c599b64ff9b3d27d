# SPDX-License-Identifier: BSD-3-Clause
"""Draws one thing in a wide view and as stock VTK's six faces of 90 degrees, and says how they differ."""

import ctypes
import math

import numpy
import vtk
import widefov
from vtk.util.numpy_support import vtk_to_numpy

SIZE = (600, 300)
FACE = 192  # as dense in its middle as the wide picture at its equator
DISTANCE = 3.0
# Pixels that a picture may be apart from a face's: half of one for the face's, half for its own.
APART = 1
DARK = 40  # of 255: what is darker has no hue to speak of
BACKGROUND = (0.2, 0.3, 0.4)

# Directions of view of six faces, and what is up in them.
FACES = (
    ((0, 0, -1), (0, 1, 0)),
    ((1, 0, 0), (0, 1, 0)),
    ((0, 0, 1), (0, 1, 0)),
    ((-1, 0, 0), (0, 1, 0)),
    ((0, 1, 0), (0, 0, 1)),
    ((0, -1, 0), (0, 0, -1)),
)

# Where the eye looks, of a thing that is ahead of an eye that looks down -z: at it, away from it (it is
# on the seam), and past it.
GAZES = {"ahead": (0.1, 0.2, -1), "behind": (0.05, -0.1, 1), "beside": (1, 0.4, -0.1)}


def read(window):
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    picture = grab.GetOutput()
    width, height, _ = picture.GetDimensions()
    return vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(height, width, 3).astype(int)


def gl_errors():
    """Those that OpenGL has noted since it was asked last, in the current context."""
    library = ctypes.CDLL("libGL.so.1")
    errors = []
    while len(errors) < 8:
        error = library.glGetError()
        if not error:
            break
        errors.append(error)
    return errors


class Stage:
    """A renderer with an eye at (0, 0, DISTANCE), lit from the side, and its window."""

    def __init__(self, renderer, size):
        self.renderer = renderer
        renderer.SetBackground(BACKGROUND)
        renderer.AutomaticLightCreationOff()
        light = vtk.vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(1, 2, 3)
        light.SetFocalPoint(0, 0, 0)
        renderer.AddLight(light)
        self.window = vtk.vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(size)
        self.window.AddRenderer(renderer)
        self.interactor = vtk.vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.look((0, 0, -1), (0, 1, 0))

    def add(self, prop):
        """With the camera where it wants to be told of it; what turns to the viewer, with one that looks
        at it whatever face is drawn."""
        self.renderer.AddViewProp(prop)
        camera = self.renderer.GetActiveCamera()
        if isinstance(prop, (vtk.vtkPolarAxesActor, vtk.vtkCubeAxesActor)):
            prop.SetCamera(camera)
        elif isinstance(prop, (vtk.vtkFollower, vtk.vtkProp3DFollower)):
            if not isinstance(camera, widefov.vtkWideFoVCamera):
                camera = vtk.vtkCamera()
                camera.SetPosition(0, 0, DISTANCE)
                camera.SetFocalPoint(0, 0, 0)
            prop.SetCamera(camera)

    def look(self, direction, up):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, 0, DISTANCE)
        camera.SetFocalPoint(direction[0], direction[1], DISTANCE + direction[2])
        camera.SetViewUp(up)

    def draw(self):
        self.window.Render()
        return read(self.window)


def wide_stage():
    return Stage(widefov.vtkWideFoVRenderer(), SIZE)


def stock_stage():
    stage = Stage(vtk.vtkRenderer(), (FACE, FACE))
    stage.renderer.GetActiveCamera().SetViewAngle(90)
    return stage


def unit(v):
    v = numpy.asarray(v, float)
    return v / numpy.linalg.norm(v)


def frame_of(direction, up):
    """Rows: right, up, behind."""
    back = -unit(direction)
    right = unit(numpy.cross(up, back))
    return numpy.array([right, numpy.cross(back, right), back])


def rays_of_face(direction, up):
    """World directions of a face's pixels, in its order."""
    side = (numpy.arange(FACE) + 0.5) / FACE * 2 - 1
    x, y = numpy.meshgrid(side, side)
    rays = numpy.stack([x, y, -numpy.ones_like(x)], -1) @ frame_of(direction, up)
    return rays / numpy.linalg.norm(rays, axis=-1, keepdims=True)


def pixels_of(rays, gaze):
    """Column and row of the wide picture for each ray, from below."""
    x, y, z = numpy.moveaxis(rays @ frame_of(gaze, (0, 1, 0)).T, -1, 0)
    column = (numpy.arctan2(x, -z) / (2 * math.pi) + 0.5) * SIZE[0]
    row = (numpy.arctan2(y, numpy.hypot(x, z)) / math.pi + 0.5) * SIZE[1]
    return column.astype(int) % SIZE[0], numpy.clip(row.astype(int), 0, SIZE[1] - 1)


def rays_of_picture(gaze):
    """World directions of the wide picture's pixels."""
    azimuth = ((numpy.arange(SIZE[0]) + 0.5) / SIZE[0] - 0.5) * 2 * math.pi
    elevation = ((numpy.arange(SIZE[1]) + 0.5) / SIZE[1] - 0.5) * math.pi
    a, e = numpy.meshgrid(azimuth, elevation)
    rays = numpy.stack([numpy.cos(e) * numpy.sin(a), numpy.sin(e), -numpy.cos(e) * numpy.cos(a)], -1)
    return rays @ frame_of(gaze, (0, 1, 0))


def look_up(faces, rays):
    """Whether faces have something in each of these directions, and its colour."""
    seen = numpy.zeros(rays.shape[:-1], bool)
    colours = numpy.zeros(rays.shape, int)
    for (direction, up), picture in zip(FACES, faces):
        x, y, z = numpy.moveaxis(rays @ frame_of(direction, up).T, -1, 0)
        here = (-z >= abs(x)) & (-z >= abs(y))
        column, row = (
            numpy.clip(((v[here] / -z[here] + 1) / 2 * FACE).astype(int), 0, FACE - 1) for v in (x, y)
        )
        seen[here] = covered(picture)[row, column]
        colours[here] = picture[row, column]
    return seen, colours


def grown(mask, pixels):
    """The mask and what is near it; left and right are neighbours."""
    wide = mask.copy()
    for dy in range(-pixels, pixels + 1):
        for dx in range(-pixels, pixels + 1):
            moved = numpy.roll(mask, dx, 1)
            if dy > 0:
                moved = numpy.concatenate([numpy.zeros_like(moved[:dy]), moved[:-dy]])
            elif dy < 0:
                moved = numpy.concatenate([moved[-dy:], numpy.zeros_like(moved[dy:])])
            wide |= moved
    return wide


def covered(picture):
    empty = numpy.round(numpy.array(BACKGROUND) * 255).astype(int)
    return (abs(picture - empty) > 2).any(-1)


def stock_faces(make):
    """What six stock faces show."""
    stage = stock_stage()
    stage.add(make())
    pictures = []
    for direction, up in FACES:
        stage.look(direction, up)
        stage.renderer.ResetCameraClippingRange()
        pictures.append(stage.draw())
    return pictures


def reproject(faces, gaze):
    """What faces show, in the wide picture's pixels: whether it covers them, and its colours. Each pixel
    of a face is put where it is seen, so that no thin line gets lost; where pixels of a face are farther
    apart than those of the picture, as at its poles, these look theirs up."""
    reached = numpy.zeros(SIZE[::-1], bool)
    seen = numpy.zeros(SIZE[::-1], bool)
    shown = numpy.zeros(SIZE[::-1] + (3,), int)
    for (direction, up), face in zip(FACES, faces):
        column, row = pixels_of(rays_of_face(direction, up), gaze)
        reached[row, column] = True
        there = covered(face)
        seen[row[there], column[there]] = True
        shown[row[there], column[there]] = face[there]
    between = ~reached
    seen[between], shown[between] = look_up(faces, rays_of_picture(gaze)[between])
    return seen, shown


def compare(picture, faces, gaze):
    """Of the pixels that either covers: how many; the shares that one alone covers, and that have
    another colour."""
    stock, shown = reproject(faces, gaze)
    wide = covered(picture)
    either = max(1, int((wide | stock).sum()))
    missing = int((stock & ~grown(wide, APART)).sum())
    added = int((wide & ~grown(stock, APART)).sum())
    return {
        "stock": int(stock.sum()),
        "wide": int(wide.sum()),
        "missing": missing / either,
        "added": added / either,
        "colour": other_colours(picture, shown, wide & stock),
    }


def hues(picture):
    """The colours as bright as can be: how lines are lit depends on the direction of view."""
    return picture * 255 / numpy.maximum(1, picture.max(-1, keepdims=True))


def other_colours(picture, shown, both, least=40):
    """The share of the pixels that both cover whose hue is none of those near it in the other."""
    if not both.any():
        return 0.0
    both = both & (picture.max(-1) > DARK) & (shown.max(-1) > DARK)
    if not both.any():
        return 0.0
    picture, shown = hues(picture), hues(shown)
    nearest = numpy.full(both.shape, 1000.0)
    padded = numpy.pad(picture, ((1, 1), (1, 1), (0, 0)), mode="edge")
    for dy in range(3):
        for dx in range(3):
            near = padded[dy : dy + both.shape[0], dx : dx + both.shape[1]]
            nearest = numpy.minimum(nearest, abs(near - shown).max(-1))
    return float((nearest[both] > least).mean())


def measure(make):
    """What the wide views show of a thing, beside the six faces, by the gaze; and what was said and what
    OpenGL noted."""
    faces = stock_faces(make)
    heard = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(heard)
    stage = wide_stage()
    stage.add(make())
    found = {}
    for name, gaze in GAZES.items():
        stage.look(gaze, (0, 1, 0))
        stage.draw()  # some are where the last picture was
        found[name] = compare(stage.draw(), faces, gaze)
    return {"views": found, "gl": gl_errors(), "said": heard.GetOutput()}


def stock_pixels(make):
    """How many pixels six stock faces show of a thing."""
    return sum(int(covered(face).sum()) for face in stock_faces(make))


def show(put):
    """What the wide views show once put(stage) has put something into them, beside the six faces, as
    measure says it, and whether all of them have the same picture: all that was said and noted is of
    the wide ones."""
    faces = shown_faces(put)
    heard = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(heard)
    stage = wide_stage()
    stage.draw()  # widgets ask where the picture is
    kept = put(stage)
    found = {}
    pictures = []
    for name, gaze in GAZES.items():
        stage.look(gaze, (0, 1, 0))
        stage.draw()
        pictures.append(stage.draw())
        found[name] = compare(pictures[-1], faces, gaze)
    del kept
    flat = all((picture == pictures[0]).all() for picture in pictures)
    return {"views": found, "flat": flat, "gl": gl_errors(), "said": heard.GetOutput()}


def shown_faces(put):
    """What six stock faces show of it."""
    stage = stock_stage()
    stage.draw()
    kept = put(stage)
    pictures = []
    for direction, up in FACES:
        stage.look(direction, up)
        stage.renderer.ResetCameraClippingRange()
        stage.draw()  # sizes follow the last picture
        pictures.append(stage.draw())
    del kept
    return pictures


def show_stock(put):
    """How many pixels they cover."""
    return sum(int(covered(face).sum()) for face in shown_faces(put))
