# SPDX-License-Identifier: BSD-3-Clause
"""Whether a window can be opened. VTK ends the process where it finds no X server."""

import ctypes
import os
from typing import Any, Dict

from vtkmodules.vtkRenderingCore import vtkRenderWindow

# Kept to the end of the process: a server that was started without -noreset begins anew when its
# last client leaves, and whoever connects meanwhile is thrown out.
_connections: Dict[str, Any] = {}


def _is_reached() -> bool:
    name = os.environ.get("DISPLAY", "")
    if _connections.get(name):
        return True
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return True  # then VTK has another, or says so itself
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XOpenDisplay.argtypes = [ctypes.c_char_p]
    _connections[name] = x11.XOpenDisplay(None)
    return bool(_connections[name])


def check_display(window: vtkRenderWindow) -> None:
    """Raises RuntimeError where the window is one of X, and there is no X server."""
    if window.IsA("vtkXOpenGLRenderWindow") and not _is_reached():
        raise RuntimeError(
            "there is no display, and this VTK draws on none: put 'xvfb-run -a' in front of the command")
