#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Wide views in plotters of PyVista and vedo beside a ray caster in double precision.

    PYTHONPATH=FOLDER test_plotters.py PyVista|Vedo [PICTURES]

PICTURES: a folder that the pictures are written into. Ends with 77 where the package is not there.
"""

import importlib
import os
import sys
import tempfile
import unittest

import numpy
import rays
from test_render import BACKGROUND, BOXES, EYE, box

GROUP = sys.argv[1]
PICTURES = sys.argv[2] if len(sys.argv) > 2 else None
SIZE = (400, 200)


class Case(unittest.TestCase):
    def check(self, picture, directions, eye=EYE):
        if PICTURES:
            from matplotlib import image

            image.imsave(os.path.join(PICTURES, self.id() + ".png"), picture)
        height, width, _ = picture.shape
        true = rays.cast(eye, directions((width, height)), BOXES, BACKGROUND)
        wrong = (picture != true).any(axis=-1) & rays.inner(true)
        self.assertEqual(wrong.sum(), 0, "first at row, column %s" % numpy.argwhere(wrong)[:1])


class PyVista(Case):
    def plotter(self):
        import pyvista

        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
        plotter.disable_anti_aliasing()  # what is smaller than a pixel would show in part
        self.addCleanup(plotter.close)
        plotter.set_background([part / 255 for part in BACKGROUND])
        for bounds, color in BOXES:
            plotter.add_mesh(pyvista.Box(bounds), color=[part / 255 for part in color], lighting=False)
        plotter.camera_position = [(EYE[0], EYE[1], EYE[2] + 5), EYE, (0, 1, 0)]
        return plotter

    def enabled(self, *arguments, **options):
        import widefov.pyvista

        plotter = self.plotter()
        widefov.pyvista.enable(plotter, *arguments, **options)
        return plotter

    def test_hammer(self):
        plotter = self.enabled("hammer", eye=EYE)
        self.check(plotter.screenshot(), rays.hammer)
        self.check(plotter.screenshot(window_size=(600, 300)), rays.hammer)

    def test_inside(self):
        plotter = self.enabled(inside=True)
        low, high = (numpy.array([b for b, _ in BOXES])[:, i::2] for i in (0, 1))
        self.check(plotter.screenshot(), rays.equirectangular, 0.5 * (low.min(axis=0) + high.max(axis=0)))

    def test_where_it_is(self):
        self.check(self.enabled().screenshot(), rays.equirectangular, (EYE[0], EYE[1], EYE[2] + 5))

    def test_camera_is_theirs(self):
        plotter = self.enabled()
        plotter.camera.position = EYE
        plotter.camera.focal_point = (EYE[0], EYE[1], EYE[2] - 1)
        self.check(plotter.screenshot(), rays.equirectangular)

    def test_movie(self):
        try:
            import imageio  # PyVista's package brings it
        except ImportError:
            self.skipTest("PyVista makes no movies here")
        plotter = self.enabled(eye=EYE)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "turn.gif")
            plotter.open_gif(file)
            plotter.write_frame()
            plotter.camera.azimuth = 40
            plotter.write_frame()
            plotter.mwriter.close()
            frames = imageio.mimread(file)
        self.assertEqual(len(frames), 2)
        self.assertEqual(frames[0].shape[:2], SIZE[::-1])
        self.assertGreater((frames[0] != frames[1]).sum(), 1000)

    def test_refusals(self):
        import pyvista
        import widefov.pyvista

        with self.assertRaisesRegex(ValueError, "bent"):
            self.enabled("bent")
        empty = pyvista.Plotter(off_screen=True)
        with self.assertRaisesRegex(ValueError, "nothing yet"):
            widefov.pyvista.enable(empty, inside=True)


class Vedo(Case):
    def test_hammer(self):
        import vedo
        import widefov.vedo

        vedo.settings.multi_samples = 0
        plotter = vedo.Plotter(offscreen=True, size=SIZE, bg=[part / 255 for part in BACKGROUND])
        actors = [box(*each) for each in BOXES]
        plotter.show(*actors, interactive=False)
        for actor in actors:
            self.assertTrue(plotter.renderer.HasViewProp(actor))
        camera = plotter.camera
        camera.SetPosition(EYE[0], EYE[1], EYE[2] + 5)
        camera.SetFocalPoint(EYE)
        camera.SetViewUp(0, 1, 0)
        widefov.vedo.enable(plotter, "hammer", eye=EYE)
        plotter.render()
        self.check(plotter.screenshot(asarray=True), rays.hammer)


if __name__ == "__main__":
    try:
        importlib.import_module(GROUP.lower())
    except ImportError as error:
        print(error)
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], GROUP], verbosity=2)
