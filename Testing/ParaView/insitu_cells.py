# script-version: 2.0
# SPDX-License-Identifier: BSD-3-Clause
"""The Catalyst script of test_insitu.py: a picture of each step by each technique, in which every cell
is a number."""

import json
import os

from paraview import catalyst, simple

import scene

folder = os.environ["WIDEFOV_PICTURES"]
simple.LoadPlugin(os.environ["WIDEFOV_PLUGIN"], remote=False, ns=vars(simple))

options = catalyst.Options()
options.ExtractsOutputDirectory = folder

views = []
source = simple.TrivialProducer(registrationName="input")
for technique in ("Exact", "Automatic"):
    view = scene.make_view(Projection="hammer", Technique=technique)
    views.append(view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    scene.show_cells(source, view)
    extractor = simple.CreateExtractor("WideFoVPicture", view)
    extractor.Trigger = "TimeStep"
    extractor.Trigger.Frequency = 2
    extractor.Writer.Size = [480, 240]  # larger than the view: tiles
    extractor.Writer.FileName = technique + "-{timestep:02d}.png"
for view in views:
    view.UseFXAA = 0  # a setting of the application, which each new view brings back


def catalyst_finalize():
    """What the pictures show, for the check."""
    with open(os.path.join(folder, "view.json"), "w") as file:
        json.dump(scene.describe(view), file)
