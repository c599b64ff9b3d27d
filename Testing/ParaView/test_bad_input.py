# SPDX-License-Identifier: BSD-3-Clause
"""Pipelines without data, time steps that fail, values that are none, volumes, state files of
another version: a message in ParaView's log where there is something to say, and the view goes on."""

import os
import re

from paraview import simple

import pixels
import scene
from messages import Log


def count_lit(options, view, name):
    picture = scene.save(view, os.path.join(options.output, name + ".png"))
    # not counted here: programmable sources put a sum of their own into this module
    return pixels.count_lit(picture)


def check_empty(options, view):
    """No data, data without cells, data that a filter took away: a black picture."""
    with Log(options, "empty") as log:
        scene.require(count_lit(options, view, "nothing") == 0, "nothing is drawn as something")
        nothing = simple.Threshold(Input=simple.Wavelet(), LowerThreshold=1e6, UpperThreshold=2e6)
        simple.Show(nothing, view)
        simple.Show(simple.ProgrammableSource(Script=""), view)
        scene.require(count_lit(options, view, "empty") == 0, "emptiness is drawn")
        scene.require(log.count("ERR") + log.count("ERROR") == 0, "an error of no data")
    simple.Delete(nothing)


FAILS = """
time = self.GetOutputInformation(0).Get(vtk.vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
if time == 1:
    raise RuntimeError('this time step cannot be read')
sphere = vtk.vtkSphereSource()
sphere.SetRadius(1 + time)
sphere.Update()
self.GetOutput().ShallowCopy(sphere.GetOutput())
"""

STEPS = """
info = self.GetOutputInformation(0)
keys = vtk.vtkStreamingDemandDrivenPipeline
info.Set(keys.TIME_STEPS(), [0.0, 1.0, 2.0], 3)
info.Set(keys.TIME_RANGE(), [0.0, 2.0], 2)
"""


def check_time(options, view):
    """The step in the middle fails, and is said; those before and after it are drawn."""
    source = simple.ProgrammableSource(
        OutputDataSetType="vtkPolyData", Script="import vtk\n" + FAILS,
        ScriptRequestInformation="import vtk\n" + STEPS)
    simple.Show(source, view)
    scene.place_eye(view, [0, 0, 6], [0, 0, 0])
    lit = []
    with Log(options, "time") as log:
        for step in range(3):
            view.ViewTime = step
            lit.append(count_lit(options, view, "time%d" % step))
        errors = log.count("cannot be read")
    print("lit", lit, "errors", errors)
    scene.require(0 < lit[0] < lit[2] and errors > 0, "time steps")
    simple.Delete(source)


def check_values(options, view):
    """What a camera refuses is said, and the old value stays in the picture."""
    ball = simple.Sphere(Center=[0, 0, -4])
    simple.Show(ball, view)
    scene.place_eye(view, [0, 0, 0], [0, 0, -1])
    view.AutomaticClipSpheres = 0
    lit = count_lit(options, view, "before")
    for name, value in (("ClipSpheres", [5, 1]), ("PoleFade", [80, 20]),
                        ("WarpedStereo", [0.5, -1, 0]), ("Projection", "no-such-map"),
                        ("StereoModel", "no-such-model")):
        with Log(options, name) as log:
            old = view.GetProperty(name).GetData()
            try:
                setattr(view, name, value)
                simple.Render(view)
            except ValueError as error:
                print(name, "refused:", error)
            else:
                scene.require(log.count("ERR") > 0, name + " is taken silently")
            setattr(view, name, old)
    scene.require(count_lit(options, view, "after") == lit, "another picture")
    view.AutomaticClipSpheres = 1
    simple.Delete(ball)


def check_volume(options, view):
    """Of tetrahedra, which are drawn on a flat picture: one warning, however many frames, and the
    rest of the scene is drawn."""
    wavelet = simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])
    tetrahedra = simple.Tetrahedralize(Input=wavelet)
    with Log(options, "volume") as log:
        display = simple.Show(tetrahedra, view)
        display.SetRepresentationType("Volume")
        ball = simple.Sphere(Center=[0, 0, -4])
        simple.Show(ball, view)
        lit = count_lit(options, view, "volume")
        for _ in range(3):
            view.CameraPosition = [0, 0, 0.01 * _]
            simple.Render(view)
        warnings = log.count("a volume is left out")
    print("volume: lit", lit, "warnings", warnings)
    scene.require(lit > 10 and warnings == 1, "volumes")
    simple.Delete(tetrahedra)
    simple.Delete(wavelet)
    simple.Delete(ball)


def check_versions(options, view):
    """States of a version before stereo, and of a later one."""
    view.Projection = "hammer"
    view.Tilt = 20
    state = os.path.join(options.output, "state.pvsm")
    simple.SaveState(state)
    with open(state) as file:
        text = file.read()
    before = re.sub(r'<Property name="(?:Stereo|Inter|Pole|Warped)\w*" id=.*?</Property>', "", text,
                    flags=re.S)
    scene.require(len(before) < len(text), "the state has no such property")
    later = text.replace('<Property name="Projection" id=', '<Property name="Later" id="1.Later"'
                         ' number_of_elements="1"><Element index="0" value="7"/></Property>'
                         '<Property name="Projection" id=')
    scene.require(later != text, "the state has no projection")
    for name, content in (("before", before), ("later", later)):
        path = os.path.join(options.output, name + ".pvsm")
        with open(path, "w") as file:
            file.write(content)
        simple.ResetSession()
        simple.LoadState(path)
        found = simple.GetActiveViewOrCreate("WideFoVView")
        settings = [found.GetProperty(p).GetData() for p in ("Projection", "Tilt", "StereoModel")]
        print(name, settings)
        scene.require(settings == ["hammer", 20, "omnidirectional"], name)


def main(options):
    scene.load_plugin(options)
    view = scene.make_view()
    check_empty(options, view)
    check_time(options, view)
    check_values(options, view)
    check_volume(options, view)
    check_versions(options, view)


scene.run(main)
