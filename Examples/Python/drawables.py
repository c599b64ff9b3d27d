# SPDX-License-Identifier: BSD-3-Clause
"""Four pictures of what is no surface: volumes, a sky, labels, widgets.

    drawables.py FOLDER

writes volume.png, sky.png, labels.png and widgets.png there, from stock VTK's own classes.
"""

import math
import os
import sys

import vtk
import widefov

SIZE = (800, 400)


def open_window(projection):
    """A window with a wide renderer, the eye at the origin, and an interactor for widgets."""
    renderer = widefov.vtkWideFoVRenderer()
    camera = renderer.GetActiveCamera()
    camera.SetProjection(projection)
    camera.SetPosition(0, 0, 0)
    camera.SetFocalPoint(0, 0, -1)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(SIZE)
    window.AddRenderer(renderer)
    interactor = vtk.vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    return window, renderer, interactor


def around(azimuth, elevation, distance):
    """A place in a direction: degrees to the right and up."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return (
        distance * math.cos(e) * math.sin(a), distance * math.sin(e),
        -distance * math.cos(e) * math.cos(a))


def add(renderer, source, color=(0.8, 0.8, 0.8)):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)
    return actor


def draw_volume(renderer, _):
    """Waves by ray casting, from within, and balls among them."""
    waves = vtk.vtkRTAnalyticSource()
    waves.SetWholeExtent(-30, 30, -30, 30, -30, 30)
    colors = vtk.vtkColorTransferFunction()
    colors.AddRGBPoint(60, 0.1, 0.2, 0.7)
    colors.AddRGBPoint(150, 0.8, 0.8, 0.8)
    colors.AddRGBPoint(240, 0.9, 0.3, 0.1)
    opacity = vtk.vtkPiecewiseFunction()
    opacity.AddPoint(130, 0)
    opacity.AddPoint(220, 0.12)
    mapper = vtk.vtkGPUVolumeRayCastMapper()
    mapper.SetInputConnection(waves.GetOutputPort())
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(colors)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().ShadeOn()
    volume.GetProperty().SetInterpolationTypeToLinear()
    renderer.AddVolume(volume)
    for azimuth in range(-180, 180, 45):
        ball = vtk.vtkSphereSource()
        ball.SetCenter(around(azimuth, 10 * (azimuth % 4) - 10, 12))
        ball.SetRadius(1.5)
        ball.SetThetaResolution(40)
        ball.SetPhiResolution(40)
        add(renderer, ball, (0.3, 0.9, 0.4))


def make_sky():
    """A blue sky with a sun, and the ground: longitude across, latitude up."""
    width, height = 512, 256
    image = vtk.vtkImageData()
    image.SetDimensions(width, height, 1)
    image.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 3)
    for y in range(height):
        up = y / (height - 1) * 2 - 1
        for x in range(width):
            sun = math.hypot(x - 0.62 * width, y - 0.68 * height) < 9
            sky = (255, 240, 190) if sun else (
                150 - 110 * up, 190 - 90 * up, 240 - 40 * up) if up > 0 else (
                95 + 60 * up, 85 + 45 * up, 60 + 20 * up)
            for channel in range(3):
                image.SetScalarComponentFromFloat(x, y, 0, channel, sky[channel])
    return image


def draw_sky(renderer, _):
    """A skybox behind bodies of all shapes."""
    texture = vtk.vtkTexture()
    texture.SetInputData(make_sky())
    texture.InterpolateOn()
    texture.MipmapOn()
    sky = vtk.vtkSkybox()
    sky.SetProjectionToSphere()
    sky.SetTexture(texture)
    renderer.AddActor(sky)
    for i, azimuth in enumerate(range(-180, 180, 30)):
        ball = vtk.vtkSuperquadricSource()
        ball.SetCenter(around(azimuth, -8, 4))
        ball.SetPhiRoundness(0.2 + 0.15 * (i % 6))
        ball.SetThetaRoundness(0.2 + 0.15 * (i % 5))
        ball.SetSize(0.7)
        ball.SetThetaResolution(60)
        ball.SetPhiResolution(60)
        actor = add(renderer, ball, (0.9, 0.7 - 0.05 * (i % 6), 0.4))
        actor.GetProperty().SetInterpolationToPhong()
        actor.GetProperty().SetSpecular(0.5)


def draw_labels(renderer, _):
    """Followers, texts of so many pixels, and the axes of a box round the eye."""
    for azimuth in range(-180, 180, 45):
        text = vtk.vtkVectorText()
        text.SetText("%d" % azimuth)
        follower = vtk.vtkFollower()
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(text.GetOutputPort())
        follower.SetMapper(mapper)
        follower.SetScale(0.5)
        follower.SetPosition(around(azimuth - 6, 22, 4))
        follower.SetCamera(renderer.GetActiveCamera())
        follower.GetProperty().SetColor(1, 0.8, 0.3)
        renderer.AddActor(follower)
        billboard = vtk.vtkBillboardTextActor3D()
        billboard.SetInput("%d east" % azimuth)
        billboard.SetPosition(around(azimuth, -25, 4))
        billboard.GetTextProperty().SetFontSize(16)
        renderer.AddActor(billboard)
    axes = vtk.vtkCubeAxesActor()
    axes.SetBounds(-5, 5, -4, 4, -5, 5)
    axes.SetCamera(renderer.GetActiveCamera())
    axes.SetFlyModeToStaticEdges()
    renderer.AddActor(axes)


def draw_widgets(renderer, interactor):
    """Handles where they are seen: ahead, beside, behind."""
    kept = []
    for widget, representation, azimuth in (
            (vtk.vtkBoxWidget2, vtk.vtkBoxRepresentation, 0),
            (vtk.vtkImplicitPlaneWidget2, vtk.vtkImplicitPlaneRepresentation, 75),
            (vtk.vtkImplicitCylinderWidget, vtk.vtkImplicitCylinderRepresentation, 150),
            (vtk.vtkSphereWidget2, vtk.vtkSphereRepresentation, -75),
            (vtk.vtkBoxWidget2, vtk.vtkBoxRepresentation, -140)):
        x, y, z = around(azimuth, 5, 4)
        shown = representation()
        shown.SetPlaceFactor(1)
        shown.PlaceWidget((x - 1, x + 1, y - 1, y + 1, z - 1, z + 1))
        one = widget()
        one.SetInteractor(interactor)
        one.SetRepresentation(shown)
        one.SetDefaultRenderer(renderer)
        one.On()
        kept.append(one)
    return kept


def write(name, projection, draw):
    window, renderer, interactor = open_window(projection)
    renderer.SetBackground(0.1, 0.1, 0.14)
    kept = draw(renderer, interactor)
    window.Render()
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(name)
    writer.Write()
    for widget in kept or ():
        widget.Off()


def main():
    if len(sys.argv) != 2 or not os.path.isdir(sys.argv[1]):
        sys.exit("usage: drawables.py FOLDER, which is there")
    for name, projection, draw in (
            ("volume", "hammer", draw_volume), ("sky", "equirectangular", draw_sky),
            ("labels", "equirectangular", draw_labels), ("widgets", "hammer", draw_widgets)):
        write(os.path.join(sys.argv[1], name + ".png"), projection, draw)


if __name__ == "__main__":
    main()
