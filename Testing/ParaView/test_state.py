# SPDX-License-Identifier: BSD-3-Clause
"""State files, Python state and the Python trace bring the same view and picture back; those that an
earlier version wrote, too. Scripts of a later version that set what there is not yet say so."""

import lzma
import os
import re

from paraview import simple, smstate, smtrace

import pixels
import scene

# None of them a default.
SETTINGS = {
    "Projection": "azimuthal-equidistant",
    "HorizontalFieldOfView": 210,
    "VerticalFieldOfView": 170,
    "Tilt": 60,
    "Lens": [0.6, 0, -0.01, 0, 0],
    "AutomaticClipSpheres": 0,
    "ClipSpheres": [0.02, 90],
    "DepthMapping": "Logarithmic",
    "Technique": "Exact",
    "Tolerance": 0.5,
    "StereoRender": 1,
    "StereoModel": "warped",
    "InterpupillaryDistance": 0.25,
    "PoleFade": [50, 80],
    "WarpedStereo": [0.25, 6, -0.5],
    "Separation": 0.02,
    "Convergence": 3,
}


HERE = os.path.dirname(os.path.abspath(__file__))

# What the states in the folder States set, which the plugin wrote before it had stereo; and what it
# could not know, which has to be as in a new view.
EARLIER = {
    "Projection": "hammer",
    "HorizontalFieldOfView": 300,
    "VerticalFieldOfView": 150,
    "Tilt": 20,
    "AutomaticClipSpheres": 0,
    "ClipSpheres": [0.02, 90],
    "DepthMapping": "Logarithmic",
    "Technique": "Exact",
    "Tolerance": 0.5,
    "StereoRender": 0,
    "StereoModel": "omnidirectional",
    "InterpupillaryDistance": 0.065,
    "DirectionMapFile": "",
}


def read_settings(view):
    return {name: view.GetProperty(name).GetData() for name in SETTINGS}


def check_loaded(options, before, picture, how):
    view = simple.GetActiveViewOrCreate("WideFoVView")
    scene.require(read_settings(view) == before, how + ": " + str(read_settings(view)))
    again = scene.save(view, os.path.join(options.output, how + ".png"), scene.SIZE)
    with open(picture, "rb") as first, open(again, "rb") as second:
        scene.require(first.read() == second.read(), how + ": another picture")
    print(how, "gives the same view")


def trace_settings(view):
    """What the trace records while the settings change, as by Apply in the window."""
    simple.SetActiveView(view)
    smtrace.start_trace()
    change = smtrace.PropertiesModified(view)
    for name, value in SETTINGS.items():
        setattr(view, name, value)
    change.finalize()
    text = smtrace.stop_trace()
    scene.require("WideFoV" in text, text)
    for name in SETTINGS:
        # an assignment, and since ParaView 6.0 a line of Set
        set_one = re.search(r"\bwideFoVView1\." + name + r" = |^    " + name + "=", text, re.M)
        scene.require(set_one, "the trace lacks " + name + ":\n" + text)


def check_earlier(options, how):
    view = simple.GetActiveViewOrCreate("WideFoVView")
    found = {name: view.GetProperty(name).GetData() for name in EARLIER}
    scene.require(found == EARLIER, how + " of before: " + str(found))
    picture = scene.save(view, os.path.join(options.output, how + "-before.png"), scene.SIZE)
    lit = len({number for row in pixels.read_rows(picture) for number in row})
    print(how, "of an earlier version:", lit, "colours")
    scene.require(lit > 10, "the ball of the state is not drawn")


def check_versions(options):
    """States that an earlier version wrote, and a script that a later one might write."""
    state = os.path.join(options.output, "before-stereo.pvsm")
    with lzma.open(os.path.join(HERE, "States", "before-stereo.pvsm.xz")) as packed:
        with open(state, "wb") as out:
            out.write(packed.read())
    simple.ResetSession()
    simple.LoadState(state)
    check_earlier(options, "pvsm")
    with open(os.path.join(HERE, "States", "before_stereo.py")) as file:
        script = file.read()
    simple.ResetSession()
    exec(compile(script, "before", "exec"), {})
    check_earlier(options, "python")
    # beside it: in ParaView 6.1 no script can name all of paraview.simple after a third new session
    later = script.replace("wideFoVView1.Tilt =", "wideFoVView1.Later = 7\nwideFoVView1.Tilt =")
    try:
        exec(compile(later, "later", "exec"), {})
    except AttributeError as error:
        scene.require("Later" in str(error), "the error names no property: " + str(error))
        print("a later script:", error)
    else:
        scene.require(False, "a property that there is not was taken")


def main(options):
    scene.load_plugin(options)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    # smoothing is a setting of the application, which no state file holds
    view = scene.make_view(UseFXAA=1)
    simple.Show(simple.XMLPolyDataReader(FileName=[mesh]), view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    trace_settings(view)
    before = read_settings(view)
    picture = scene.save(view, os.path.join(options.output, "before.png"), scene.SIZE)

    state = os.path.join(options.output, "state.pvsm")
    simple.SaveState(state)
    script = smstate.get_state()
    simple.ResetSession()
    simple.LoadState(state)
    check_loaded(options, before, picture, "pvsm")
    simple.ResetSession()
    exec(compile(script, "state", "exec"), {})
    check_loaded(options, before, picture, "python")
    check_versions(options)


scene.run(main)
