# SPDX-License-Identifier: BSD-3-Clause
"""What asks the camera or the renderer how large something is to be: right where it is seen, or a word.

    test_sizes.py FOLDER

FOLDER has the package widefov.
"""

import math
import sys

PIXELS = 40  # that balls are told to be
APART = 0.04  # of that: a ball's rim is of whole pixels, and maps curve under it
SIZE = (800, 400)

# Projection, fields of view, and directions (azimuth, elevation) in it.
VIEWS = (
    ("equirectangular", 360, 180, ((0, 0), (100, 0), (180, 0), (-75, 50))),
    ("hammer", 360, 180, ((0, 0), (120, -30))),
    ("azimuthal-equidistant", 180, 180, ((0, 0), (60, 20))),
    ("perspective", 90, 53.13, ((0, 0), (20, 5))),
)


def place(azimuth, elevation, distance):
    a, e = math.radians(azimuth), math.radians(elevation)
    flat = distance * math.cos(e)
    return (flat * math.sin(a), distance * math.sin(e), -flat * math.cos(a))


def ball(where, renderer, mapped):
    """A ball at a place that is to be so many pixels large; mapped: by a vtkGlyph3DMapper."""
    import vtk

    points = vtk.vtkPolyData()
    points.SetPoints(vtk.vtkPoints())
    points.GetPoints().InsertNextPoint(where)
    verts = vtk.vtkVertexGlyphFilter()
    verts.SetInputData(points)
    sizes = vtk.vtkDistanceToCamera()
    sizes.SetInputConnection(verts.GetOutputPort())
    sizes.SetRenderer(renderer)
    sizes.SetScreenSize(PIXELS)
    source = vtk.vtkSphereSource()
    source.SetThetaResolution(48)
    source.SetPhiResolution(48)
    if mapped:
        mapper = vtk.vtkGlyph3DMapper()
        mapper.SetInputConnection(sizes.GetOutputPort())
        mapper.SetSourceConnection(source.GetOutputPort())
        mapper.SetScaleArray("DistanceToCamera")
        mapper.SetScaleModeToScaleByMagnitude()
    else:
        copies = vtk.vtkGlyph3D()
        copies.SetInputConnection(sizes.GetOutputPort())
        copies.SetSourceConnection(source.GetOutputPort())
        copies.SetScaleModeToScaleByScalar()
        copies.SetInputArrayToProcess(0, 0, 0, 0, "DistanceToCamera")
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(copies.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    renderer.AddActor(actor)


def stage_of(projection, wide, high):
    import draw
    import widefov

    stage = draw.Stage(widefov.vtkWideFoVRenderer(), SIZE)
    camera = stage.renderer.GetActiveCamera()
    camera.SetProjection(projection)
    camera.SetHorizontalFieldOfView(wide)
    camera.SetVerticalFieldOfView(high)
    camera.SetPosition(0, 0, 0)
    camera.SetFocalPoint(0, 0, -1)
    return stage


def width(stage):
    """Of a disc with as many pixels as are covered."""
    import draw

    return math.sqrt(int(draw.covered(stage.draw()).sum()) * 4 / math.pi)


def measure_balls(_):
    """Widths of the ball in the first frame, in the next, and after the fields of view were halved."""
    found = {}
    for projection, wide, high, directions in VIEWS:
        for azimuth, elevation in directions:
            for distance, mapped in ((3, False), (300, True)):
                stage = stage_of(projection, wide, high)
                ball(place(azimuth, elevation, distance), stage.renderer, mapped)
                widths = [width(stage), width(stage)]
                if azimuth == 0:
                    stage.renderer.GetActiveCamera().SetHorizontalFieldOfView(wide / 2)
                    stage.renderer.GetActiveCamera().SetVerticalFieldOfView(high / 2)
                    widths.append(width(stage))
                name = "%s, %d degrees, %g away" % (projection, azimuth, distance)
                found[name] = [widths, PIXELS]
    return found


def measure_corners(_):
    """The window's diagonal at a place, as vtk3DWidget asks for it to size its handles, in the
    diagonal's pixels there."""
    import vtk

    found = {}
    for azimuth in (0, 90, 179):
        stage = stage_of("equirectangular", 360, 180)
        ball(place(azimuth, 0, 10), stage.renderer, False)
        stage.draw()
        ask = vtk.vtkInteractorObserver
        display = [0.0] * 3
        ask.ComputeWorldToDisplay(stage.renderer, *place(azimuth, 0, 10), display)
        corners = []
        for x, y in ((0, 0), SIZE):
            world = [0.0] * 4
            ask.ComputeDisplayToWorld(stage.renderer, x, y, display[2], world)
            corners.append(world[:3])
        pixel = 10 * 2 * math.pi / SIZE[0]
        name = "diagonal at %d degrees" % azimuth
        found[name] = [[math.dist(*corners) / pixel], math.hypot(*SIZE)]
    return found


def said_of(make):
    """What a wide renderer says of what make(renderer) puts into it, in two frames."""
    import vtk

    heard = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(heard)
    stage = stage_of("equirectangular", 360, 180)
    kept = make(stage.renderer)
    stage.draw()
    stage.draw()
    del kept
    return heard.GetOutput()


def sorted_by_camera(renderer):
    import materials
    import vtk

    order = vtk.vtkDepthSortPolyData()
    order.SetInputConnection(materials.ball(0.5, (0, 0, -3)).GetOutputPort())
    order.SetCamera(renderer.GetActiveCamera())
    order.SetDirectionToBackToFront()
    renderer.AddActor(materials.actor_of(order))


def scale_legend(renderer):
    import vtk

    renderer.AddViewProp(vtk.vtkLegendScaleActor())


# How often each is to be said.
SAID = {
    "vtkDepthSortPolyData sorts along the direction of view": sorted_by_camera,
    "vtkLegendScaleActor says other lengths than are seen": scale_legend,
}


def main(folder):
    sys.path.insert(0, folder)
    import forked

    faults = []
    for measure in (measure_balls, measure_corners):
        for name, (figures, right) in forked.run(measure, None, 600).items():
            print("%-45s %s of %.5g" % (name, ", ".join("%.1f" % f for f in figures), right))
            if any(abs(figure / right - 1) > APART for figure in figures):
                faults.append(name)
    for words, make in SAID.items():
        said = forked.run(lambda make: {"said": said_of(make)}, make)["said"]
        print("%d times: %s" % (said.count(words), words))
        if said.count(words) != 1:
            faults.append(words)
    print("wrong: %s" % ("; ".join(faults) or "none"))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
