# SPDX-License-Identifier: BSD-3-Clause
"""Follows the Python lines of the README: looks at what they drew, in `window`."""

import sys

import vtkmodules.vtkCommonCore
import widefov

# The renderer looks at the cone from outside: some of the picture, not most of it. In a
# Hammer picture of 360 by 180 degrees the corners are outside the map.
LEAST_COVERED = 0.005
MOST_COVERED = 0.1

CLASSES = (
    "vtkWideFoVCamera vtkWideFoVDataPass vtkWideFoVPass vtkWideFoVPolyDataMapper"
    " vtkWideFoVRenderer"
).split()


def check_picture(window):
    """Prints what it found; True where it is the cone and nothing else."""
    width, height = window.GetSize()
    pixels = vtkmodules.vtkCommonCore.vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
    drawn = [sum(pixels.GetTuple3(i)) > 0 for i in range(pixels.GetNumberOfTuples())]
    covered = sum(drawn) / (width * height)
    ahead = drawn[height // 2 * width + width // 2]
    corner = drawn[0]
    print("covered %g (%g to %g)" % (covered, LEAST_COVERED, MOST_COVERED))
    print("ahead %s (True), corner %s (False)" % (ahead, corner))
    return LEAST_COVERED < covered < MOST_COVERED and ahead and not corner


def check_classes():
    """True where every class bears its VTK name and can be made by it."""
    found = [getattr(widefov, name)().GetClassName() for name in CLASSES]
    print("classes %s" % " ".join(found))
    return found == CLASSES


def check_errors():
    """True where a wrong projection is refused and changes nothing."""
    camera = widefov.vtkWideFoVCamera()
    errors = []
    camera.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    camera.SetProjection("bent")
    print("unknown projection: %d errors (1), still %s" % (len(errors), camera.GetProjection()))
    return len(errors) == 1 and camera.GetProjection() == "equirectangular"


sys.exit(0 if all([check_picture(window), check_classes(), check_errors()]) else 1)  # noqa: F821
