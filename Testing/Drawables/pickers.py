# SPDX-License-Identifier: BSD-3-Clause
"""What every picker of VTK finds in a wide view: ahead of the eye, beside, behind, above and below."""

import vtk

import draw
import materials

PLACES = ((0.4, 0.3, -1), (4, 0.5, 3), (-4, -1, 3.5), (0.3, 1, 7), (0.5, 4, 3.2), (-0.4, -4, 2.8))
SMALL = 4  # pixels to each side
LARGE = 60


def add_balls(stage):
    balls = []
    for place in PLACES:
        balls.append(materials.actor_of(materials.ball(0.6, place)))
        stage.add(balls[-1])
    return balls


def seen_at(renderer, place):
    renderer.SetWorldPoint(*place, 1)
    renderer.WorldToDisplay()
    return renderer.GetDisplayPoint()[:2]


def in_area(picker, at, renderer, size):
    """What is found in a square round a place of the picture."""
    x, y = at
    picker.AreaPick(x - size, y - size, x + size, y + size, renderer)
    props = picker.GetProp3Ds()
    return [props.GetItemAsObject(i) for i in range(props.GetNumberOfItems())]


def find(picker, at, renderer):
    """Props that are picked; of what picks places alone, the place."""
    if isinstance(picker, vtk.vtkAreaPicker):
        return in_area(picker, at, renderer, SMALL)
    picker.Pick(at[0], at[1], 0, renderer)
    if isinstance(picker, vtk.vtkAbstractPropPicker):
        return [picker.GetViewProp()]
    return None


def measure(name):
    heard = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(heard)
    stage = draw.wide_stage()
    balls = add_balls(stage)
    stage.draw()
    picker = getattr(vtk, name)()
    wrong = []
    for ball, place in zip(balls, PLACES):
        found = find(picker, seen_at(stage.renderer, place), stage.renderer)
        if found is None:
            found = [ball] if is_on(picker.GetPickPosition(), place) else []
        if found != [ball]:
            wrong.append(place)
    small = heard.GetOutput()
    large = 0
    if isinstance(picker, vtk.vtkAreaPicker):
        large = wrong_in_large(picker, balls, stage.renderer)
        stage.draw()  # by when it is said
    return {"wrong": wrong, "large": large, "small": small, "said": heard.GetOutput(),
            "gl": draw.gl_errors()}


def show_stock(name):
    """What it finds of what is ahead of stock VTK's eye."""
    stage = draw.stock_stage()
    add_balls(stage)
    stage.draw()
    find(getattr(vtk, name)(), seen_at(stage.renderer, PLACES[0]), stage.renderer)
    return True


def is_on(found, place):
    return sum((a - b) ** 2 for a, b in zip(found, place)) ** 0.5 < 0.65


def wrong_in_large(picker, balls, renderer):
    """How often a large rectangle has another prop than those that are seen in it."""
    wrong = 0
    for at in ((300, 150), (450, 150), (150, 150), (300, 220), (90, 90)):
        seen = in_area(vtk.vtkRenderedAreaPicker(), at, renderer, LARGE)
        found = in_area(picker, at, renderer, LARGE)
        wrong += set(map(id, seen)) != set(map(id, found))
    return wrong


def verdict(found):
    if found["gl"]:
        return "OpenGL notes errors %s" % found["gl"], True
    if found["wrong"]:
        return "does not find what is at %s" % found["wrong"], True
    if found["small"]:
        return "says %r" % found["small"], True
    warned = found["said"].count("Warning:")
    if found["large"]:
        return "right in small rectangles; of large ones a warning", warned != 1
    return "right", warned > 0
