# SPDX-License-Identifier: BSD-3-Clause
"""Wide views in the renderers of other packages, which made them as they like."""

from typing import Optional, Sequence, Tuple

from vtkmodules.vtkRenderingCore import vtkRenderer

from ._render import _numbers, _set_pass, _set_view
from .vtkRenderingWideFoV import vtkWideFoVCamera, vtkWideFoVPass


def middle_of(renderer: vtkRenderer) -> Tuple[float, float, float]:
    """Of what there is to see."""
    b = renderer.ComputeVisiblePropBounds()
    if b[0] > b[1]:
        raise ValueError("enable: there is nothing yet to be inside of; call it when all is added")
    return (0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]))


def place(
    renderer: vtkRenderer, camera: vtkWideFoVCamera, inside: bool, eye: Optional[Sequence[float]]
) -> None:
    """As the renderer's camera is, or with that direction from another eye."""
    old = renderer.GetActiveCamera()
    position = old.GetPosition()
    if inside or eye is not None:
        position = middle_of(renderer) if eye is None else _numbers("eye", eye, 3)
    ahead = [a - b for a, b in zip(old.GetFocalPoint(), old.GetPosition())]
    camera.SetPosition(position)
    camera.SetFocalPoint([a + b for a, b in zip(position, ahead)])
    camera.SetViewUp(old.GetViewUp())


def make_wide(
    renderer: vtkRenderer, camera: vtkWideFoVCamera, projection: str, inside: bool,
    eye: Optional[Sequence[float]] = None, hfov: Optional[float] = None,
    vfov: Optional[float] = None, fov: Optional[float] = None, tilt: float = 0,
    technique: str = "auto", tolerance: float = 0.25,
) -> None:
    """Places the camera, and sets a pass that draws with it; the camera is set by who calls."""
    _set_view(camera, projection, hfov, vfov, fov, tilt)
    place(renderer, camera, inside, eye)
    wide = vtkWideFoVPass()
    _set_pass(wide, camera, technique, tolerance)
    renderer.SetPass(wide)
