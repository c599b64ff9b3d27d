# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of web pages share: a scene of balls in known directions, and pages of it."""

import math
import os
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

RENDER = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else ""
SKIPPED = 77  # what CTest takes for that

# Azimuth to the right and elevation of each ball round the eye, degrees.
BALLS = ((0, 0), (40, 10), (90, -15), (150, 40), (-60, 20), (-120, -35))
RADIUS = 0.05  # at the distance 1: 2.9 degrees


def unit(azimuth, elevation):
    """View coordinates: x right, y up, looking down -z; angles in degrees."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return (math.cos(e) * math.sin(a), math.sin(e), -math.cos(e) * math.cos(a))


def write_balls(path):
    """Every point has a heat from 0 to 1, so that there is a bar of colours."""
    scene = vtkAppendPolyData()
    for ball in BALLS:
        sphere = vtkSphereSource()
        sphere.SetCenter(unit(*ball))
        sphere.SetRadius(RADIUS)
        sphere.SetThetaResolution(24)
        sphere.SetPhiResolution(24)
        scene.AddInputConnection(sphere.GetOutputPort())
    scene.Update()
    data = scene.GetOutput()
    heat = vtkFloatArray()
    heat.SetName("heat")
    for _ in range(data.GetNumberOfPoints()):
        heat.InsertNextValue(1)
    data.GetPointData().SetScalars(heat)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.Write()


class PageTest(unittest.TestCase):
    """Each class in a folder of its own, with balls.vtp in it."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="web-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        write_balls(cls.path("balls.vtp"))

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    @classmethod
    def render(cls, *words, **more):
        words = [RENDER, "balls.vtp", "--samples", "0", "--eye", "0,0,0", "--background", "0,0,0.5", "--color-by", "heat", "--scalar-bar", "--range", "0,1",
                 "--colormap", "viridis", *words]
        return subprocess.run(words, cwd=cls.folder, capture_output=True, text=True, timeout=120, check=False, **more)

    def draw(self, page, *words):
        done = self.render("--web", page, *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr


def main():
    unittest.main(argv=sys.argv[:1])
