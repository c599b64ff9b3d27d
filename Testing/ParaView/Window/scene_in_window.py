# SPDX-License-Identifier: BSD-3-Clause
"""Run by ParaView's window: the view and data in it, and a line in a log for every change."""

import json
import math
import os

from paraview import simple

SETTINGS = ["Projection", "HorizontalFieldOfView", "Tilt", "StereoRender", "StereoModel"]
LOG = os.path.join(os.environ["WIDEFOV_PHOTOGRAPHS"], "settings.log")

simple.LoadPlugin(os.environ["WIDEFOV_PLUGIN"], remote=False, ns=vars(simple))
simple._DisableFirstRenderCameraReset()  # the eye is in the data
old = simple.GetActiveView()
layout = simple.GetLayout()
view = simple.CreateView("WideFoVView")
if old:
    simple.Delete(old)
simple.AssignViewToLayout(view=view, layout=layout)
simple.SetActiveView(view)

wavelet = simple.Wavelet()
gradient = simple.Gradient(Input=wavelet, ScalarArray=["POINTS", "RTData"])
gradient.UpdatePipeline()
lines = simple.StreamTracer(Input=gradient, SeedType="Point Cloud", Vectors=["POINTS", "Gradient"])
lines.SeedType.Radius = 9
lines.SeedType.NumberOfPoints = 50
simple.Show(simple.Outline(Input=wavelet), view).LineWidth = 3
display = simple.Show(simple.Tube(Input=lines, Radius=0.06), view)
simple.ColorBy(display, ("POINTS", "RTData"))
display.RescaleTransferFunctionToDataRange()
ball = simple.Sphere(Center=[4, 3, -5], Radius=2, ThetaResolution=64, PhiResolution=64)
simple.Show(ball, view)
view.CameraPosition = [1, 1, 1]
view.CameraFocalPoint = [1.5, 1.2, -4]
view.InterpupillaryDistance = 0.2
view.LODThreshold = 1000  # megabytes: the photographs show all of the data, at any moment
simple.Render(view)


def log(*_):
    """The settings as they are now, the eye to whole units."""
    values = {name: view.GetProperty(name).GetData() for name in SETTINGS}
    eye = list(view.CameraPosition)
    ahead = [end - start for start, end in zip(eye, view.CameraFocalPoint)]
    length = math.sqrt(sum(x * x for x in ahead))
    values["Eye"] = [round(x) for x in eye]
    values["Ahead"] = [round(x / length, 2) for x in ahead] if length else ahead
    values["Up"] = list(view.CameraViewUp)
    values["PreviewMode"] = list(layout.PreviewMode)
    with open(LOG, "a") as out:
        out.write(json.dumps(values) + "\n")


log()  # the driver waits for it
view.SMProxy.AddObserver("PropertyModifiedEvent", log)
layout.SMProxy.AddObserver("PropertyModifiedEvent", log)
