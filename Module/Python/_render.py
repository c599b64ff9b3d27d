# SPDX-License-Identifier: BSD-3-Clause
"""A picture in one call: `widefov.render`."""

from __future__ import annotations

import math
import numbers
from typing import TYPE_CHECKING, Any, Callable, Iterator, Optional, Sequence, Tuple, Union

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkRenderingCore import vtkAbstractMapper, vtkActor, vtkProp, vtkRenderWindow

from ._display import check_display
from ._messages import Messages
from .vtkRenderingWideFoV import vtkWideFoVPass, vtkWideFoVPolyDataMapper, vtkWideFoVRenderer

if TYPE_CHECKING:
    import numpy

Point = Tuple[float, float, float]

TECHNIQUES = {
    vtkWideFoVPass.GetTechniqueAsString(number): number for number in range(vtkWideFoVPass.VERTEX + 1)
}


def _surface(data: vtkDataObject) -> vtkPolyData:
    """What a renderer shows of data: polydata as they are, of all others the surface."""
    # only who has data needs these modules of VTK's
    from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter, vtkDataSetSurfaceFilter

    if isinstance(data, vtkPolyData):
        return data
    if isinstance(data, vtkCompositeDataSet):
        surface = vtkCompositeDataGeometryFilter()
    elif isinstance(data, vtkDataSet):
        surface = vtkDataSetSurfaceFilter()
    else:
        raise TypeError("render: %s has no surface" % data.GetClassName())
    surface.SetInputDataObject(data)
    surface.Update()
    return surface.GetOutput()


def _actor_of(data: vtkDataObject) -> vtkActor:
    mapper = vtkWideFoVPolyDataMapper()
    mapper.SetInputData(_surface(data))
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def _props_of(thing: Any) -> Iterator[vtkProp]:
    """Props as they are, an actor for data and for what a source makes, and all of a sequence."""
    if isinstance(thing, vtkProp):
        yield thing
    elif isinstance(thing, vtkDataObject):
        yield _actor_of(thing)
    elif isinstance(thing, vtkAlgorithm) and not isinstance(thing, vtkAbstractMapper):
        thing.Update()
        yield _actor_of(thing.GetOutputDataObject(0))
    elif isinstance(getattr(thing, "actor", None), vtkProp):  # as vedo's objects have
        yield thing.actor
    elif isinstance(thing, (list, tuple)):
        for each in thing:
            yield from _props_of(each)
    else:
        raise TypeError(
            "render: %s is neither data nor a source nor a prop of VTK's" % type(thing).__name__)


def _numbers(name: str, values: Sequence[float], count: int) -> tuple:
    """Returns so many finite numbers, or raises a ValueError that names them."""
    try:
        found = () if isinstance(values, str) else tuple(float(value) for value in values)
    except (TypeError, ValueError):
        found = ()
    if len(found) != count or not all(math.isfinite(number) for number in found):
        raise ValueError("render: %s is %d finite number%s, not %r" % (name, count, "s" if count > 1 else "", values))
    return found


def _color(value: Union[str, Sequence[float]]) -> tuple:
    """Returns red, green, blue of three numbers or of a name that vtkNamedColors knows."""
    from vtkmodules.vtkCommonColor import vtkNamedColors

    if not isinstance(value, str):
        return _numbers("background", value, 3)
    colors = vtkNamedColors()
    if not colors.ColorExists(value):
        raise ValueError("render: background is a colour's name or 3 numbers from 0 to 1, not %r" % value)
    return tuple(colors.GetColor3d(value))


def _samples(value: int) -> int:
    if isinstance(value, bool) or not isinstance(value, numbers.Integral) or value < 0:
        raise ValueError("render: samples is a whole number from 0, not %r" % (value,))
    return int(value)


def _pixels(size: Sequence[int]) -> Tuple[int, int]:
    width, height = (int(side) for side in _numbers("size", size, 2))
    if width < 1 or height < 1:
        raise ValueError("render: size is at least 1 x 1, not %d x %d" % (width, height))
    return width, height


def _center(renderer: vtkWideFoVRenderer) -> Point:
    b = renderer.ComputeVisiblePropBounds()
    if b[0] > b[1]:
        raise ValueError("render: there is nothing to see, so say where the eye is: eye=(x, y, z)")
    return (0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]))


def _aim(renderer, eye, direction, look_at, up) -> None:
    """Places the eye: by default in the middle of what is to be seen, looking down -z."""
    eye = _center(renderer) if eye is None else _numbers("eye", eye, 3)
    if direction is not None and look_at is not None:
        raise ValueError("render: give direction or look_at, not both")
    if look_at is not None:
        direction = [a - b for a, b in zip(_numbers("look_at", look_at, 3), eye)]
    d = _numbers("direction", (0, 0, -1) if direction is None else direction, 3)
    u = _numbers("up", up, 3)
    across = math.hypot(d[1] * u[2] - d[2] * u[1], d[2] * u[0] - d[0] * u[2], d[0] * u[1] - d[1] * u[0])
    if not across > 1e-12 * math.hypot(*d) * math.hypot(*u):
        raise ValueError("render: direction %s and up %s span no plane" % (d, u))
    length = math.hypot(*d)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(eye)
    camera.SetFocalPoint([a + b / length for a, b in zip(eye, d)])
    camera.SetViewUp(u)


def _set_view(camera, projection, hfov, vfov, fov, tilt) -> None:
    """What the camera refuses, or would clamp with a warning, is a ValueError with its words."""
    with Messages(camera) as messages:
        camera.SetProjection(projection)
        for degrees, set_field in (
            (hfov, camera.SetHorizontalFieldOfView),
            (vfov, camera.SetVerticalFieldOfView),
            (fov, camera.SetFieldOfView),
        ):
            if degrees is not None:
                set_field(_numbers("a field of view", [degrees], 1)[0])
        camera.SetTilt(_numbers("tilt", [tilt], 1)[0])
    if messages.texts:
        raise ValueError("render: " + messages.texts[0])


def _set_pass(wide: vtkWideFoVPass, camera, technique: str, tolerance: float) -> None:
    if technique not in TECHNIQUES:
        raise ValueError("render: no technique '%s', but %s" % (technique, ", ".join(TECHNIQUES)))
    (tolerance,) = _numbers("tolerance", [tolerance], 1)
    wide.SetTechnique(TECHNIQUES[technique])
    wide.SetTolerance(tolerance)
    camera.SetExactPerspective(wide.IsExact())


def _read(window: vtkRenderWindow, size: Tuple[int, int]) -> numpy.ndarray:
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

    width, height = size
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
    picture = vtk_to_numpy(pixels).reshape(height, width, 3)
    return numpy.ascontiguousarray(picture[::-1])  # VTK's first row is the lowest


def _draw(renderer: vtkWideFoVRenderer, size: Tuple[int, int], samples: int) -> numpy.ndarray:
    window = vtkRenderWindow()
    check_display(window)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(samples)
    window.SetSize(size)
    window.AddRenderer(renderer)
    try:
        window.Render()
        if tuple(window.GetSize()) != size:
            raise RuntimeError("render: OpenGL draws no picture of %d x %d here" % size)
        return _read(window, size)
    finally:
        # props may be of other windows as well
        renderer.RemoveAllViewProps()
        window.RemoveRenderer(renderer)
        window.Finalize()


def render(
    data_or_actors: Any, projection: str = "equirectangular", size: Tuple[int, int] = (1024, 512), *,
    eye: Optional[Point] = None, direction: Optional[Point] = None, look_at: Optional[Point] = None,
    up: Point = (0, 1, 0), hfov: Optional[float] = None, vfov: Optional[float] = None,
    fov: Optional[float] = None, tilt: float = 0, background: Union[str, Point] = (0, 0, 0), samples: int = 4,
    technique: str = "auto", tolerance: float = 0.25,
    prepare: Optional[Callable[[vtkWideFoVRenderer], Any]] = None,
) -> numpy.ndarray:
    """Draws data or actors as the eye sees them, and returns the picture.

    data_or_actors: data of VTK's (or PyVista's), a source or filter, a prop, or a list of these.
        Data are drawn by their surface, coloured by their active scalars.
    projection: a name, see vtkWideFoVCamera.SetProjection; size: width and height, pixels.
    eye: in the coordinates of the data (default: the middle of what is drawn); direction: where it
        looks (default: 0, 0, -1), or look_at, a point; up: what is up in the picture.
    hfov, vfov, or fov for round projections: the field of view, degrees (default: 360 by 180, or
        as much as there is); tilt: of the axis of the projection towards up, degrees.
    background: red, green, blue, 0 to 1, or a name of vtkNamedColors; samples: of each pixel, from 0.
    technique: a name of vtkWideFoVPass.GetTechniqueAsString; tolerance: pixels. See vtkWideFoVPass.
    prepare: called with the vtkWideFoVRenderer before it draws, to set what else there is.

    The array is height x width x 3, 0 to 255, the first row on top. Raises ValueError or TypeError
    for what makes no picture, and RuntimeError where there is nothing to draw on.
    """
    size = _pixels(size)
    samples = _samples(samples)
    renderer = vtkWideFoVRenderer()
    for prop in _props_of(data_or_actors):
        renderer.AddViewProp(prop)
    renderer.SetBackground(_color(background))
    _set_view(renderer.GetActiveCamera(), projection, hfov, vfov, fov, tilt)
    _set_pass(renderer.GetPass(), renderer.GetActiveCamera(), technique, tolerance)
    _aim(renderer, eye, direction, look_at, up)
    if prepare is not None:
        prepare(renderer)
    return _draw(renderer, size, samples)
