# script-version: 2.0
# SPDX-License-Identifier: BSD-3-Clause
"""A Catalyst script: a numbered dome picture of each step of a simulation, seen from inside.

The environment variable WIDEFOV_PLUGIN is the path of WideFoV.so, WIDEFOV_PICTURES the folder of
the pictures. simulation.py beside this file runs it.
"""

import os

from paraview import catalyst, simple

simple.LoadPlugin(os.environ["WIDEFOV_PLUGIN"], remote=False, ns=vars(simple))

options = catalyst.Options()
options.ExtractsOutputDirectory = os.environ["WIDEFOV_PICTURES"]

# what the simulation calls "input"; without a simulation, a file or any other source would be here
wave = simple.TrivialProducer(registrationName="input")

view = simple.CreateView("WideFoVView")
view.OrientationAxesVisibility = 0
view.Projection = "azimuthal-equidistant"
view.HorizontalFieldOfView = 180
view.Tilt = 90
view.CameraPosition = [0, 0, 0]
view.CameraFocalPoint = [0, 0, -1]
view.CameraViewUp = [0, 1, 0]

# a layer of the neighbours' cells, without which slopes differ where two ranks meet
# its name up to ParaView 5.11, and since
ghosts = "GhostCells" if hasattr(simple, "GhostCells") else "GhostCellsGenerator"
whole = getattr(simple, ghosts)(Input=wave)
crests = simple.Contour(Input=whole, ContourBy=["POINTS", "wave"], Isosurfaces=[0.8])
# all round the eye, but open ahead
open_crests = simple.Clip(Input=crests, ClipType="Sphere")
open_crests.ClipType.Center = [0, 0, 0]
open_crests.ClipType.Radius = 5
open_crests.Invert = 0
display = simple.Show(open_crests, view)
display.DiffuseColor = [0.3, 0.6, 1]

dome = simple.CreateExtractor("WideFoVPicture", view)
dome.Trigger = "TimeStep"
dome.Writer.Size = [512, 512]
dome.Writer.FileName = "dome_{timestep:06d}.png"
