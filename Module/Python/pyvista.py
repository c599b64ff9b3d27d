# SPDX-License-Identifier: BSD-3-Clause
"""Wide views in PyVista's plotters: `widefov.pyvista.enable`."""

from typing import Any

import pyvista

from ._plotters import make_wide
from .vtkRenderingWideFoV import vtkWideFoVCamera


class WideCamera(vtkWideFoVCamera, pyvista.Camera):
    """A wide camera with the properties of PyVista's."""


def enable(
    plotter: pyvista.Plotter, projection: str = "equirectangular", inside: bool = False, **view: Any
) -> None:
    """Shows a wide view in every renderer of a plotter, from now on.

    Call it when all is added. projection: a name, see vtkWideFoVCamera.SetProjection. inside: the eye
    goes to the middle of what there is to see and looks on in its direction; else it stays where it
    is. view: eye, a point, instead of the middle; hfov, vfov, fov, tilt, technique and tolerance as of
    widefov.render. Screenshots, movies and windows are PyVista's own. Raises ValueError for what is
    no view.
    """
    for renderer in plotter.renderers:
        if not renderer.camera_set:
            # as PyVista does when it first shows something
            renderer.camera_position = renderer.get_default_cam_pos()
            renderer.ResetCamera()
        camera = WideCamera()
        make_wide(renderer, camera, projection, inside, **view)
        renderer.camera = camera
