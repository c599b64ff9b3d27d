#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the file of data that the pages draw: balls round the eye, with an array `pressure`.

    data.py FILE.vtu
"""

import sys

from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageShrink3D, vtkRTAnalyticSource
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

HALF = 10  # of the box
EVERY = 4  # so that none is where the eye is


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    wavelet = vtkRTAnalyticSource()
    wavelet.SetWholeExtent(-HALF, HALF, -HALF, HALF, -HALF, HALF)
    places = vtkImageShrink3D()
    places.SetInputConnection(wavelet.GetOutputPort())
    places.SetShrinkFactors(EVERY, EVERY, EVERY)
    ball = vtkSphereSource()
    ball.SetRadius(1)
    ball.SetThetaResolution(16)
    ball.SetPhiResolution(12)
    balls = vtkGlyph3D()
    balls.SetInputConnection(places.GetOutputPort())
    balls.SetSourceConnection(ball.GetOutputPort())
    balls.SetScaleModeToDataScalingOff()
    balls.Update()
    balls.GetOutput().GetPointData().GetScalars().SetName("pressure")
    grid = vtkAppendFilter()
    grid.SetInputConnection(balls.GetOutputPort())
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputConnection(grid.GetOutputPort())
    writer.SetFileName(sys.argv[1])
    sys.exit(0 if writer.Write() else "data.py: cannot write " + sys.argv[1])


if __name__ == "__main__":
    main()
