#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""widefov.render beside a ray caster in double precision, its arguments, and its refusals.

    PYTHONPATH=FOLDER test_render.py
"""

import inspect
import subprocess
import sys
import unittest

import numpy
import rays
import vtk
import widefov
from vtk.util.numpy_support import vtk_to_numpy

EYE = (0.3, -0.2, 0.5)
BACKGROUND = (51, 102, 153)  # a fifth, two, three
# All round the eye: ahead, on the seam behind it, overhead, and to the lower right.
BOXES = (
    ((-0.6, 0.9, -0.5, 0.4, -3.0, -2.0), (255, 0, 0)),
    ((-1.0, 1.5, -0.8, 1.1, 3.0, 4.0), (0, 255, 0)),
    ((-0.7, 0.8, 2.0, 2.5, -0.5, 1.2), (0, 0, 255)),
    ((2.0, 3.0, -2.0, -0.5, -1.0, 0.3), (255, 255, 0)),
)


def box(bounds, color):
    """A flat colour: its light is all ambient."""
    source = vtk.vtkCubeSource()
    source.SetBounds(bounds)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor([part / 255 for part in color])
    actor.GetProperty().LightingOff()
    return actor


def colored_sphere():
    sphere = vtk.vtkSphereSource()
    elevation = vtk.vtkElevationFilter()
    elevation.SetInputConnection(sphere.GetOutputPort())
    elevation.Update()
    return elevation


class Pictures(unittest.TestCase):
    def setUp(self):
        self.actors = [box(*each) for each in BOXES]

    def check(self, projection, directions, size, **options):
        background = [part / 255 for part in BACKGROUND]
        drawn = widefov.render(
            self.actors, projection, size, eye=EYE, background=background, samples=0, **options)
        true = rays.cast(EYE, directions(size), BOXES, BACKGROUND)
        colors = {tuple(color) for color in true.reshape(-1, 3)}
        self.assertGreaterEqual(len(colors), 4, "the scene shows too little")
        # auto keeps edges within a quarter of a pixel, so a pixel whose neighbours are alike is right
        wrong = (drawn != true).any(axis=-1) & rays.inner(true)
        self.assertEqual(wrong.sum(), 0, "first at row, column %s" % numpy.argwhere(wrong)[:1])
        return drawn

    def test_equirectangular(self):
        drawn = self.check("equirectangular", rays.equirectangular, (400, 200))
        self.assertEqual((drawn.shape, drawn.dtype), ((200, 400, 3), numpy.uint8))
        self.assertTrue(drawn.flags["C_CONTIGUOUS"])

    def test_hammer(self):
        self.check("hammer", rays.hammer, (400, 200), technique="exact")

    def test_dome(self):
        self.check("azimuthal-equidistant", rays.dome, (300, 240), fov=180)

    def test_directions(self):
        ahead = widefov.render(self.actors, size=(400, 200), eye=EYE, samples=0)
        right = widefov.render(self.actors, size=(400, 200), eye=EYE, samples=0, direction=(2, 0, 0))
        point = [a + b for a, b in zip(EYE, (3, 0, 0))]
        other = widefov.render(self.actors, size=(400, 200), eye=EYE, samples=0, look_at=point)
        self.assertTrue((right == other).all())
        turned = numpy.roll(ahead, -100, axis=1)
        differ = (turned != right).any(axis=-1) & rays.inner(turned)
        self.assertLess(differ.sum(), 1)

    def test_perspective(self):
        wide = widefov.render(self.actors, "perspective", (300, 300), eye=EYE, hfov=60, vfov=60)
        camera = vtk.vtkCamera()
        camera.SetPosition(EYE)
        camera.SetFocalPoint(EYE[0], EYE[1], EYE[2] - 1)
        camera.SetViewAngle(60)
        window, renderer = vtk.vtkRenderWindow(), vtk.vtkRenderer()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(4)
        window.SetSize(300, 300)
        window.AddRenderer(renderer)
        renderer.SetActiveCamera(camera)
        for actor in self.actors:
            renderer.AddActor(actor)
        renderer.ResetCameraClippingRange()
        window.Render()
        pixels = vtk.vtkUnsignedCharArray()
        window.GetPixelData(0, 0, 299, 299, 0, pixels, 0)
        stock = vtk_to_numpy(pixels).reshape(300, 300, 3)[::-1]
        self.assertTrue((stock == wide).all())


class Things(unittest.TestCase):
    """What is drawn: all kinds of arguments alike."""

    def same(self, *things):
        pictures = [widefov.render(thing, size=(128, 64), eye=(0, 0, 1)) for thing in things]
        self.assertGreater(len(numpy.unique(pictures[0])), 20, "it shows too little")
        for picture in pictures[1:]:
            self.assertTrue((picture == pictures[0]).all())

    def test_data(self):
        source = colored_sphere()
        data = source.GetOutput()
        blocks = vtk.vtkMultiBlockDataSet()
        blocks.SetBlock(0, data)
        grid = vtk.vtkAppendFilter()
        grid.SetInputData(data)
        self.same(source, data, [data], (source,), blocks, grid)

    def test_object_with_an_actor(self):
        class Mesh:
            actor = box((-1, 1, -1, 1, -3, -2), (255, 128, 0))

        picture = widefov.render(Mesh(), size=(64, 32), samples=0)
        self.assertIn([255, 128, 0], picture.reshape(-1, 3).tolist())

    def test_eye_is_in_the_middle(self):
        actor = box((9, 11, 19, 21, 29, 31), (0, 255, 0))
        picture = widefov.render(actor, size=(64, 32))
        self.assertTrue((picture == (0, 255, 0)).all())

    def test_props_stay_as_they_were(self):
        actor = box((-1, 1, -1, 1, -3, -2), (255, 128, 0))
        first = widefov.render(actor, size=(64, 32))
        widefov.render(actor, "hammer", size=(64, 32))
        self.assertTrue((widefov.render(actor, size=(64, 32)) == first).all())
        self.assertEqual(actor.GetReferenceCount(), 1)

    def test_prepare(self):
        seen = []
        widefov.render(colored_sphere(), size=(64, 32), prepare=seen.append)
        self.assertIsInstance(seen[0], widefov.vtkWideFoVRenderer)


class Refusals(unittest.TestCase):
    def refused(self, error, words, *things, **options):
        things = things or (colored_sphere(),)
        with self.assertRaises(error) as raised:
            widefov.render(*things, **options)
        text = str(raised.exception)
        self.assertIn(words, text)
        self.assertEqual(len(text.splitlines()), 1)

    def test_arguments(self):
        self.refused(ValueError, "bent", projection="bent")
        self.refused(ValueError, "400", hfov=400)
        self.refused(ValueError, "finite", hfov=float("nan"))
        self.refused(ValueError, "size", size=(0, 10))
        self.refused(ValueError, "size", size=(10,))
        self.refused(ValueError, "size is 2 finite numbers, not '64x32'", size="64x32")
        self.refused(ValueError, "size", size=64)
        self.refused(ValueError, "samples is a whole number from 0, not -1", samples=-1)
        self.refused(ValueError, "samples", samples=2.5)
        self.refused(ValueError, "not both", direction=(1, 0, 0), look_at=(0, 0, 1))
        self.refused(ValueError, "a colour's name", background="bleu")
        self.refused(ValueError, "eye", eye=(1, 2))
        self.refused(ValueError, "no plane", up=(0, 0, 1))
        self.refused(ValueError, "no technique", technique="magic")

    def test_background_by_name(self):
        picture = widefov.render(vtk.vtkConeSource(), size=(16, 8), eye=(0, 0, 9), background="tomato", samples=0)
        self.assertEqual(tuple(picture[0, 0]), (255, 99, 71))

    def test_things(self):
        self.refused(TypeError, "str", "sphere.vtk")
        self.refused(TypeError, "vtkTable", vtk.vtkTable())
        self.refused(TypeError, "Mapper", vtk.vtkPolyDataMapper())
        self.refused(ValueError, "nothing to see", [])
        self.refused(ValueError, "nothing to see", vtk.vtkPolyData())

    def test_no_display(self):
        if vtk.vtkRenderWindow().GetClassName() != "vtkXOpenGLRenderWindow":
            self.skipTest("this VTK needs no display")
        code = "import vtk, widefov; widefov.render(vtk.vtkConeSource())"
        done = subprocess.run(
            ["env", "DISPLAY=:12345", sys.executable, "-B", "-c", code], check=False,
            capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("RuntimeError: there is no display", done.stderr)

    def test_display_stays_connected(self):
        """A server that resets when its last client leaves would throw VTK out."""
        if vtk.vtkRenderWindow().GetClassName() != "vtkXOpenGLRenderWindow":
            self.skipTest("this VTK needs no display")
        code = """if True:
            import os, vtk
            from widefov._display import check_display
            def sockets():
                files = ["/proc/self/fd/" + name for name in os.listdir("/proc/self/fd")]
                return sum(os.readlink(file).startswith("socket:") for file in files if os.path.islink(file))
            before = sockets()
            check_display(vtk.vtkRenderWindow())
            check_display(vtk.vtkRenderWindow())
            print(sockets() - before)"""
        done = subprocess.run(
            [sys.executable, "-B", "-c", code], check=True, capture_output=True, text=True)
        self.assertEqual(done.stdout.strip(), "1")


class Words(unittest.TestCase):
    def test_documentation(self):
        parameters = inspect.signature(widefov.render).parameters
        for name in parameters:
            self.assertIn(name, widefov.render.__doc__)
        for name in ("vtkWideFoVCamera", "vtkWideFoVPass", "vtkWideFoVRenderer"):
            self.assertGreater(len(getattr(widefov, name).__doc__), 100)

    def test_properties(self):
        if not hasattr(vtk.vtkCamera, "view_angle"):
            self.skipTest("this VTK has no properties in Python")
        camera = widefov.vtkWideFoVCamera(projection="hammer")
        self.assertEqual(camera.projection, "hammer")
        camera.horizontal_field_of_view = 200
        self.assertEqual(camera.GetHorizontalFieldOfView(), 200)


if __name__ == "__main__":
    unittest.main(verbosity=2)
