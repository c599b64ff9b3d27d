#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A program that knows nothing of wide views: draws a scene and writes the picture.

    program.py SCENE FILE.png
"""

import sys

import vtk

SIZE = (400, 200)
BACKGROUND = (51, 102, 153)
CENTER = (0.3, -0.2, 0.5)  # what its camera looks at
# All round it.
BOXES = (
    ((-0.6, 0.9, -0.5, 0.4, -3.0, -2.0), (255, 0, 0)),
    ((-1.0, 1.5, -0.8, 1.1, 3.0, 4.0), (0, 255, 0)),
    ((-0.7, 0.8, 2.0, 2.5, -0.5, 1.2), (0, 0, 255)),
    ((2.0, 3.0, -2.0, -0.5, -1.0, 0.3), (255, 255, 0)),
)


def actor_of(source):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def add_boxes(renderer):
    for bounds, color in BOXES:
        source = vtk.vtkCubeSource()
        source.SetBounds(bounds)
        actor = actor_of(source)
        actor.GetProperty().SetColor([part / 255 for part in color])
        actor.GetProperty().LightingOff()
        renderer.AddActor(actor)
    camera = vtk.vtkCamera()  # its own
    camera.SetFocalPoint(CENTER)
    camera.SetPosition(CENTER[0], CENTER[1], CENTER[2] + 7)
    renderer.SetActiveCamera(camera)
    renderer.ResetCameraClippingRange()


def add_glass(renderer):
    """Shines through, is ordered by depth peeling, and has a text before it."""
    for x in range(3):
        sphere = vtk.vtkSphereSource()
        sphere.SetCenter(0.4 * x, 0.1 * x, -0.6 * x)
        sphere.SetThetaResolution(24)
        actor = actor_of(sphere)
        actor.GetProperty().SetColor(x == 0, x == 1, x == 2)
        actor.GetProperty().SetOpacity(0.5)
        renderer.AddActor(actor)
    renderer.SetUseDepthPeeling(1)
    text = vtk.vtkTextActor()
    text.SetInput("glass")
    renderer.AddViewProp(text)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(30)
    renderer.GetActiveCamera().SetViewAngle(40)


class OwnRenderer(vtk.vtkOpenGLRenderer):
    """Derived in Python, as PyVista's."""


def add_subclass(renderer):
    add_boxes(renderer)
    print("python", type(renderer).__name__)


def add_axes(renderer, interactor):
    marker = vtk.vtkOrientationMarkerWidget()
    marker.SetOrientationMarker(vtk.vtkAxesActor())
    marker.SetInteractor(interactor)
    marker.SetViewport(0, 0, 0.4, 0.4)
    marker.EnabledOn()
    marker.InteractiveOff()
    cone = actor_of(vtk.vtkConeSource())
    cone.SetPosition(0, 3, 0)
    renderer.AddActor(cone)
    return marker


def write(window, file):
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(file)
    writer.Write()


def main():
    scene, file = sys.argv[1:]
    renderer = OwnRenderer() if scene == "subclass" else vtk.vtkRenderer()
    renderer.SetBackground([part / 255 for part in BACKGROUND])
    window = vtk.vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(SIZE)
    window.AddRenderer(renderer)
    interactor = vtk.vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    adders = {"boxes": add_boxes, "glass": add_glass, "subclass": add_subclass}
    kept = adders[scene](renderer) if scene in adders else add_axes(renderer, interactor)
    window.Render()
    write(window, file)
    camera = renderer.GetActiveCamera()
    mapper = renderer.GetActors().GetLastActor().GetMapper()
    print("classes", *(each.GetClassName() for each in (renderer, camera, mapper)))
    del kept


if __name__ == "__main__":
    main()
