# SPDX-License-Identifier: BSD-3-Clause
"""Whether a window can be opened. VTK ends the process where it finds no X server."""

import ctypes

from vtkmodules.vtkRenderingCore import vtkRenderWindow


def _is_reached() -> bool:
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return True  # then VTK has another, or says so itself
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XOpenDisplay.argtypes = [ctypes.c_char_p]
    x11.XCloseDisplay.argtypes = [ctypes.c_void_p]
    display = x11.XOpenDisplay(None)
    if display:
        x11.XCloseDisplay(display)
    return bool(display)


def check_display(window: vtkRenderWindow) -> None:
    """Raises RuntimeError where the window is one of X, and there is no X server."""
    if window.IsA("vtkXOpenGLRenderWindow") and not _is_reached():
        raise RuntimeError(
            "there is no display, and this VTK draws on none: put 'xvfb-run -a' in front of the command")
