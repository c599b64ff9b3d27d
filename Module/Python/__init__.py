# SPDX-License-Identifier: BSD-3-Clause
"""Wide field-of-view rendering for VTK.

Every class of the module under its VTK name, ready to draw: importing the package
loads VTK's OpenGL backend and text rendering as well. `render` makes a picture in one call, and `show` a
panorama that turns in a notebook.
"""

from vtkmodules.vtkCommonCore import vtkVersion as _vtkVersion

from ._built_for import VTK_VERSION as _BUILT_FOR

# Another VTK, from a package index say, has libraries of its own, and two VTKs in one process
# crash sooner or later; so before anything else of either is loaded.
# Versions that differ in their third number alone fit each other.
if _vtkVersion.GetVTKVersion().split(".")[:2] != _BUILT_FOR.split(".")[:2]:
    raise ImportError(
        "widefov was built for VTK %s, but this Python's vtkmodules is VTK %s (%s)"
        % (_BUILT_FOR, _vtkVersion.GetVTKVersion(), __import__("vtkmodules").__path__[0])
    )

import vtkmodules.vtkInteractionStyle  # noqa: E402,F401
import vtkmodules.vtkRenderingFreeType  # noqa: E402,F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: E402,F401

from .vtkRenderingWideFoV import *  # noqa: E402,F401,F403
from ._overlays import place_overlay  # noqa: E402,F401
from ._render import render  # noqa: E402,F401
from ._show import show  # noqa: E402,F401
