# SPDX-License-Identifier: BSD-3-Clause
"""Wide views in vedo's plotters: `widefov.vedo.enable`."""

from typing import Any

from ._plotters import make_wide
from .vtkRenderingWideFoV import vtkWideFoVCamera


def enable(
    plotter: Any, projection: str = "equirectangular", inside: bool = False, **view: Any
) -> None:
    """Shows a wide view in every renderer of a vedo.Plotter, from now on.

    Call it when all is added, by plotter.add(..) or by plotter.show(.., interactive=False).
    projection: a name, see vtkWideFoVCamera.SetProjection. inside: the eye goes to the middle of what
    there is to see and looks on in its direction; else it stays where it is. view: eye, a point,
    instead of the middle; hfov, vfov, fov, tilt, technique and tolerance as of widefov.render.
    Raises ValueError for what is no view.
    """
    for renderer in plotter.renderers:
        camera = vtkWideFoVCamera()
        make_wide(renderer, camera, projection, inside, **view)
        renderer.SetActiveCamera(camera)
        plotter.camera = camera
    plotter.resetcam = False  # it would be placed outside again
