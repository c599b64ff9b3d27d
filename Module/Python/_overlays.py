# SPDX-License-Identifier: BSD-3-Clause
"""Texts and scalar bars that stand in a direction, not in the picture: `widefov.place_overlay`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Tuple

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkActor, vtkProp, vtkRenderer, vtkRenderWindow, vtkTexture

from ._display import check_display
from .vtkRenderingWideFoV import vtkWideFoVPolyDataMapper

if TYPE_CHECKING:
    import numpy


def _check(overlay: Any, azimuth: float, elevation: float, width: float, depth: float) -> None:
    if not isinstance(overlay, vtkProp):
        raise TypeError("place_overlay: %s is no prop of VTK's" % type(overlay).__name__)
    if not math.isfinite(azimuth) or not -90 <= elevation <= 90:
        raise ValueError("place_overlay: no direction %g, %g" % (azimuth, elevation))
    if not 0 < width < 180:
        raise ValueError("place_overlay: the width is more than 0 and less than 180, not %g" % width)
    if not 0 < depth < math.inf:
        raise ValueError("place_overlay: the depth is a length, not %g" % depth)


def _unblended(colors: numpy.ndarray, cover: numpy.ndarray) -> numpy.ndarray:
    """The colours that blending has multiplied by what they cover, 0 to 1. What is clear has those beside
    it: filters of textures mix them in."""
    import numpy

    for step in 2 ** numpy.arange(10):
        sides = [(step, 0), (-step, 0), (0, step), (0, -step)]
        near = [sum(numpy.roll(part, side, (0, 1)) for side in sides) for part in (colors, cover)]
        colors, cover = (numpy.where(cover > 0, part, other)
                         for part, other in zip((colors, cover), near))
    return colors / numpy.where(cover > 0, cover, 1)


def _picture(overlay: vtkProp, size: Tuple[int, int]) -> vtkImageData:
    """The overlay on nothing, with how much of each pixel it covers."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

    window = vtkRenderWindow()
    check_display(window)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    window.SetSize(size)
    renderer = vtkRenderer()
    renderer.SetBackgroundAlpha(0)
    renderer.AddViewProp(overlay)
    window.AddRenderer(renderer)
    window.Render()
    pixels = vtkUnsignedCharArray()
    window.GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels)
    renderer.RemoveAllViewProps()
    window.Finalize()
    values = vtk_to_numpy(pixels).reshape(size[1], size[0], 4)
    colors = _unblended(values[..., :3].astype(float), values[..., 3:] / 255)
    both = numpy.concatenate((colors.round().clip(0, 255).astype("u1"), values[..., 3:]), -1)
    image = vtkImageData()
    image.SetDimensions(size[0], size[1], 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(both.reshape(-1, 4), True, VTK_UNSIGNED_CHAR))
    return image


def _panel(azimuth: float, elevation: float, width: float, depth: float, aspect: float):
    """A rectangle that faces the eye, in the camera's axes: x right, y up, looking down -z."""
    from vtkmodules.vtkFiltersSources import vtkPlaneSource

    a, e = math.radians(azimuth), math.radians(elevation)
    middle = (math.sin(a) * math.cos(e), math.sin(e), -math.cos(a) * math.cos(e))
    right = (math.cos(a), 0, math.sin(a))
    up = (-math.sin(a) * math.sin(e), math.cos(e), math.cos(a) * math.sin(e))
    half = math.tan(math.radians(width) / 2)

    def corner(x, y):
        return [depth * (m + x * half * r + y * half / aspect * u)
                for m, r, u in zip(middle, right, up)]

    plane = vtkPlaneSource()
    plane.SetOrigin(corner(-1, -1))
    plane.SetPoint1(corner(1, -1))
    plane.SetPoint2(corner(-1, 1))
    return plane


def place_overlay(
    renderer: vtkRenderer, overlay: vtkProp, azimuth: float = 0, elevation: float = 0, *,
    width: float = 30, depth: float = 1, size: Tuple[int, int] = (512, 256),
) -> vtkActor:
    """Shows a text, a scalar bar or another overlay in a direction, as on a panel that faces the eye.

    azimuth, elevation: of the panel's middle, degrees to the right of where the camera looks and
        above the horizon of its view up. The panel turns with the camera.
    width: of the panel, degrees; depth: of its middle, scene units from the eye (what is nearer hides
        it, and two eyes see it there).
    size: of the panel, pixels. The overlay's own coordinates are in a window of this size.

    Returns the actor that is added to the renderer. The panel has the overlay as it is now.
    """
    _check(overlay, azimuth, elevation, width, depth)
    size = (max(int(size[0]), 1), max(int(size[1]), 1))
    texture = vtkTexture()
    texture.SetInputData(_picture(overlay, size))
    texture.InterpolateOn()
    texture.MipmapOn()
    mapper = vtkWideFoVPolyDataMapper()
    panel = _panel(azimuth, elevation, width, depth, size[0] / size[1])
    mapper.SetInputConnection(panel.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetTexture(texture)
    actor.ForceTranslucentOn()
    actor.GetProperty().LightingOff()
    axes = vtkMatrix4x4()
    actor.SetUserMatrix(axes)

    def follow(caller, _event):
        vtkMatrix4x4.Invert(caller.GetActiveCamera().GetViewTransformMatrix(), axes)

    renderer.AddObserver("StartEvent", follow)
    renderer.AddViewProp(actor)
    return actor
