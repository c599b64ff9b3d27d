#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Where the bar of --scalar-bar-at is seen, by directions and eyes reckoned in double.

    test_scalar_bar.py WIDEFOV_RENDER
"""

import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy
from matplotlib import image

RENDER = sys.argv[1]
SIZE = (720, 360)
ANGLE = 50  # degrees: the panel is so wide
RATIO = 4  # and so many times as wide as high
AT = (40, 20)
DEPTH, IPD = 2, 0.3

# A small triangle below the eye, to have an array: the bar is all else that there is to see.
DATA = """# vtk DataFile Version 3.0
three points
ASCII
DATASET POLYDATA
POINTS 3 float
0 -9 0  0.1 -9 0  0 -9 0.1
POLYGONS 1 4
3 0 1 2
POINT_DATA 3
SCALARS height float 1
LOOKUP_TABLE default
0 1 2
"""


def directions():
    """Of the picture's pixels: right, up, behind."""
    azimuth = ((numpy.arange(SIZE[0]) + 0.5) / SIZE[0] - 0.5) * 2 * math.pi
    elevation = (0.5 - (numpy.arange(SIZE[1]) + 0.5) / SIZE[1]) * math.pi
    a, e = numpy.meshgrid(azimuth, elevation)
    return numpy.stack([numpy.cos(e) * numpy.sin(a), numpy.sin(e), -numpy.cos(e) * numpy.cos(a)], -1)


def on_panel(origins, rays):
    """Where rays meet the panel's plane, from -1 to 1 on the panel; NaN behind."""
    a, e = numpy.radians(AT)
    middle = numpy.array((math.sin(a) * math.cos(e), math.sin(e), -math.cos(a) * math.cos(e)))
    right = numpy.array((math.cos(a), 0, math.sin(a)))
    up = numpy.cross(right, middle)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        t = (DEPTH - origins @ middle) / (rays @ middle)
    places = origins + numpy.where(t > 0, t, math.nan)[..., None] * rays
    half = DEPTH * math.tan(math.radians(ANGLE) / 2)
    return places @ right / half, places @ up / half * RATIO


def eye(side):
    """The eyes of omnidirectional stereo: beside the middle, at right angles to where each looks."""
    rays = directions()
    azimuth = numpy.arctan2(rays[..., 0], -rays[..., 2])
    right = numpy.stack([numpy.cos(azimuth), 0 * azimuth, numpy.sin(azimuth)], -1)
    return side * IPD / 2 * right, rays


def extent(picture, x, y):
    """The parts of the panel that coloured pixels lie at: of the bar itself, not its white letters."""
    colored = picture.max(-1) - picture.min(-1) > 0.3
    return numpy.array([numpy.nanmin(x[colored]), numpy.nanmax(x[colored]),
                        numpy.nanmin(y[colored]), numpy.nanmax(y[colored])]), colored


class Bars(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.data = os.path.join(cls.folder.name, "data.vtk")
        with open(cls.data, "w", encoding="utf-8") as file:
            file.write(DATA)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def call(self, at, *words, output="picture.png"):
        path = os.path.join(self.folder.name, output)
        done = subprocess.run(
            [RENDER, self.data, "--eye", "0,0,0", "--size", "%dx%d" % SIZE, "--samples", "0",
             "--colormap", "rainbow", "--scalar-bar-at", ",".join(map(str, at)), "-o", path, *words],
            stderr=subprocess.PIPE, text=True, timeout=120, check=False)
        return done, path

    def draw(self, at, *words):
        done, path = self.call(at, *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return image.imread(path)[..., :3]

    def check(self, picture, x, y, pixel):
        """The bar fills the panel's width, evenly, and nothing lies beside the panel."""
        found, colored = extent(picture, x, y)
        self.assertGreater(colored.sum(), 500)
        self.assertLess(abs(found[0] + found[1]), pixel, found)
        self.assertTrue(0.8 < found[1] <= 1 + pixel, found)
        self.assertTrue(-1 - pixel < found[2] < found[3] < 1 + pixel, found)
        return found

    def test_it_is_where_it_is_told(self):
        none = numpy.zeros(3)
        whole = self.draw(AT)
        pixel = 2 * 360 / SIZE[0] / (ANGLE / 2)
        self.check(whole, *on_panel(none, directions()), pixel)
        tiled = self.draw(AT, "--tile", "200x100")
        self.assertLess((abs(whole - tiled).max(-1) > 0.02).sum(), 20)

    def test_two_eyes_see_it_at_its_depth(self):
        both = self.draw((*AT, DEPTH), "--stereo", "omnidirectional", "--ipd", str(IPD),
                         "--layout", "top-bottom")
        left, right = both[: SIZE[1]], both[SIZE[1] :]
        pixel = 2 * 360 / SIZE[0] / (ANGLE / 2)
        seen = [self.check(left, *on_panel(*eye(-1)), pixel), self.check(right, *on_panel(*eye(1)), pixel)]
        self.assertLess(abs(seen[0] - seen[1]).max(), pixel, "the eyes see it at other places of the panel")
        # the other way round, or at another depth, it would not be there
        with self.assertRaises(AssertionError):
            self.check(left, *on_panel(*eye(1)), pixel)
        with self.assertRaises(AssertionError):
            self.check(left, *on_panel(numpy.zeros(3), directions()), pixel)

    def test_a_film_has_it(self):
        done, path = self.call(AT, "--film", "turn", "--seconds", "0.2", "--fps", "10", output="f_%02d.png")
        self.assertEqual(done.returncode, 0, done.stderr)
        pixel = 2 * 360 / SIZE[0] / (ANGLE / 2)
        for frame in (1, 2):  # the view turns by half a circle, and the bar with it
            picture = image.imread(path % frame)[..., :3]
            self.check(picture, *on_panel(numpy.zeros(3), directions()), pixel)

    def test_what_cannot_be_is_one_line(self):
        for at, words in (
            ((400, 0), ()), ((0, 91), ()), ((0, 0, 0), ()), ((0,), ()), (("nan", 0), ()),
            ((0, 0), ("--stereo", "omnidirectional")), ((0, 0), ("--technique", "cubemap")),
            ((0, 0, 5), ("--clip", "6,20")),
        ):
            done = self.call(at, *words)[0]
            self.assertEqual(done.returncode, 2, (at, words))
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn("--scalar-bar-at", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
