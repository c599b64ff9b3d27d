# SPDX-License-Identifier: BSD-3-Clause
"""A panorama and a dome picture of a data set, seen from inside, in ParaView's Python.

    pvpython panorama.py WideFoV.so FOLDER
"""

import os
import sys

from paraview import simple

plugin, folder = sys.argv[1:3]
simple.LoadPlugin(plugin, remote=False, ns=globals())
os.makedirs(folder, exist_ok=True)

view = simple.CreateView("WideFoVView")
view.ViewSize = [1024, 512]
view.OrientationAxesVisibility = 0

wavelet = simple.Wavelet()
gradient = simple.Gradient(Input=wavelet, ScalarArray=["POINTS", "RTData"])
gradient.UpdatePipeline()
lines = simple.StreamTracer(
    Input=gradient, SeedType="Point Cloud", Vectors=["POINTS", "Gradient"]
)
lines.SeedType.Radius = 9
lines.SeedType.NumberOfPoints = 50
tubes = simple.Tube(Input=lines, Radius=0.06)
simple.Show(simple.Outline(Input=wavelet), view).LineWidth = 3
display = simple.Show(tubes, view)
simple.ColorBy(display, ("POINTS", "RTData"))
display.RescaleTransferFunctionToDataRange()
sphere = simple.Sphere(Center=[4, 3, -5], Radius=2, ThetaResolution=64, PhiResolution=64)
simple.Show(sphere, view)

# the eye, inside the data
view.CameraPosition = [1, 1, 1]
view.CameraFocalPoint = [1.5, 1.2, -4]
view.CameraViewUp = [0, 1, 0]
simple.SaveScreenshot(os.path.join(folder, "panorama.png"), view, ImageResolution=[2048, 1024])

# a dome master: the zenith in the middle, what is ahead at the bottom
view.Projection = "azimuthal-equidistant"
view.HorizontalFieldOfView = 180
view.Tilt = 90
simple.SaveScreenshot(os.path.join(folder, "dome.png"), view, ImageResolution=[1024, 1024])
