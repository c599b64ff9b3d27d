#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""widefov.place_overlay beside the rays of the pictures' pixels.

    PYTHONPATH=FOLDER test_overlays.py
"""

import math
import unittest

import numpy
import rays
import vtk
import widefov

EYE = (0.3, -0.2, 0.5)
SIZE = (200, 100)  # of a panel
LEFT, RIGHT = (255, 0, 0), (0, 128, 255)


def half(color, left, right):
    """Covers the panel from one of its columns to another."""
    plane = vtk.vtkPlaneSource()
    plane.SetOrigin(left, 0, 0)
    plane.SetPoint1(right, 0, 0)
    plane.SetPoint2(left, SIZE[1], 0)
    mapper = vtk.vtkPolyDataMapper2D()
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = vtk.vtkActor2D()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor([part / 255 for part in color])
    return actor


def both():
    made = vtk.vtkPropAssembly()
    made.AddPart(half(LEFT, 0, SIZE[0] // 2))
    made.AddPart(half(RIGHT, SIZE[0] // 2, SIZE[0]))
    return made


def expected(directions, azimuth, elevation, width):
    """What each pixel is to show of a panel."""
    a, e = numpy.radians((azimuth, elevation))
    middle = numpy.array((math.sin(a) * math.cos(e), math.sin(e), -math.cos(a) * math.cos(e)))
    right = numpy.array((math.cos(a), 0, math.sin(a)))
    up = numpy.cross(right, middle)
    ahead = directions @ middle
    with numpy.errstate(divide="ignore", invalid="ignore"):
        x, y = directions @ right / ahead, directions @ up / ahead
    most = math.tan(math.radians(width) / 2)
    seen = (ahead > 0) & (abs(x) < most) & (abs(y) < most * SIZE[1] / SIZE[0])
    picture = numpy.zeros(directions.shape, int)
    picture[seen & (x < 0)] = LEFT
    picture[seen & (x >= 0)] = RIGHT
    return picture


class Panels(unittest.TestCase):
    def check(self, projection, directions, size, azimuth, elevation, width, **options):
        drawn = widefov.render(
            [], projection, size, eye=EYE, samples=0,
            prepare=lambda r: widefov.place_overlay(
                r, both(), azimuth, elevation, width=width, depth=2, size=SIZE), **options)
        true = expected(directions(size), azimuth, elevation, width)
        for color in (LEFT, RIGHT):
            self.assertGreater((true == color).all(axis=-1).sum(), 100, "the panel is too small")
        # but for the edges, and two texels that are mixed in the middle
        wrong = (abs(drawn.astype(int) - true) > 2).any(axis=-1) & rays.inner(true)
        self.assertEqual(wrong.sum(), 0, "first at row, column %s" % numpy.argwhere(wrong)[:1])

    def test_equirectangular(self):
        self.check("equirectangular", rays.equirectangular, (400, 200), 50, 35, 60)

    def test_on_the_seam(self):
        self.check("equirectangular", rays.equirectangular, (400, 200), 170, -20, 50)

    def test_dome(self):
        self.check("azimuthal-equidistant", rays.dome, (300, 300), -40, 20, 50, fov=180)

    def test_it_turns_with_the_camera(self):
        self.check("equirectangular", rays.equirectangular, (400, 200), 50, 35, 60, direction=(2, 0.5, 1))

    def test_what_is_clear_stays_clear(self):
        """A text is as bright as it is told, and the scene is seen between its letters."""
        text = vtk.vtkTextActor()
        text.SetInput("Ahoy")
        text.GetTextProperty().SetFontSize(60)
        text.GetTextProperty().SetColor(1, 1, 1)
        picture = widefov.render(
            [], size=(800, 400), eye=EYE, background=(0, 0, 1),
            prepare=lambda r: widefov.place_overlay(r, text, width=80, size=SIZE))
        self.assertTrue((picture[..., 2] > 250).all(), "letters have dark edges")
        share = (picture[..., 0] > 250).mean()
        self.assertTrue(0.001 < share < 0.03, share)


class Refusals(unittest.TestCase):
    def test_one_line_each(self):
        text = vtk.vtkTextActor()
        for error, thing, options in (
            (TypeError, "Ahoy", {}),
            (ValueError, text, {"azimuth": math.nan}),
            (ValueError, text, {"elevation": 91}),
            (ValueError, text, {"width": 180}),
            (ValueError, text, {"depth": 0}),
        ):
            with self.assertRaises(error) as raised:
                widefov.place_overlay(widefov.vtkWideFoVRenderer(), thing, **options)
            self.assertIn("place_overlay: ", str(raised.exception))


if __name__ == "__main__":
    unittest.main()
