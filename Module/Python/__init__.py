# SPDX-License-Identifier: BSD-3-Clause
"""Wide field-of-view rendering for VTK.

Every class of the module under its VTK name, ready to draw: importing the package
loads VTK's OpenGL backend and text rendering as well.
"""

import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

from .vtkRenderingWideFoV import *  # noqa: F401,F403
