# SPDX-License-Identifier: BSD-3-Clause
"""Texts and scalar bars that stand in a direction, not in the picture: `widefov.place_overlay`."""

from __future__ import annotations

import math
from typing import Any, Tuple

from vtkmodules.vtkRenderingCore import vtkProp, vtkRenderer, vtkRenderWindow

from ._display import check_display
from .vtkRenderingWideFoV import vtkWideFoVOverlayPanel


def _check(overlay: Any, azimuth: float, elevation: float, width: float, depth: float) -> None:
    if not isinstance(overlay, vtkProp):
        raise TypeError("place_overlay: %s is no prop of VTK's" % type(overlay).__name__)
    if not math.isfinite(azimuth) or not -90 <= elevation <= 90:
        raise ValueError("place_overlay: no direction %g, %g" % (azimuth, elevation))
    if not 0 < width < 180:
        raise ValueError("place_overlay: the width is more than 0 and less than 180, not %g" % width)
    if not 0 < depth < math.inf:
        raise ValueError("place_overlay: the depth is a length, not %g" % depth)


def place_overlay(
    renderer: vtkRenderer, overlay: vtkProp, azimuth: float = 0, elevation: float = 0, *,
    width: float = 30, depth: float = 1, size: Tuple[int, int] = (512, 256),
) -> vtkWideFoVOverlayPanel:
    """Shows a text, a scalar bar or another overlay in a direction, as on a panel that faces the eye.

    azimuth, elevation: of the panel's middle, degrees to the right of where the camera looks and
        above the horizon of its view up. The panel turns with the camera.
    width: of the panel, degrees; depth: of its middle, scene units from the eye (what is nearer hides
        it, and two eyes see it there).
    size: of the panel, pixels. The overlay's own coordinates are in a window of this size.

    Returns the actor that is added to the renderer. The panel has the overlay as it is now.
    """
    _check(overlay, azimuth, elevation, width, depth)
    check_display(vtkRenderWindow())
    panel = vtkWideFoVOverlayPanel()
    panel.SetDirection(azimuth, elevation)
    panel.SetAngle(width)
    panel.SetDepth(depth)
    panel.SetOverlay(overlay, max(int(size[0]), 1), max(int(size[1]), 1))
    panel.Follow(renderer)
    renderer.AddViewProp(panel)
    return panel
