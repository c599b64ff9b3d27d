#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Calibrated cameras: small squares all round the eye are drawn through a lens, and OpenCV, which knows where
they ought to be, finds them in the picture.

    test_lens_files.py WIDEFOV_RENDER
"""

import os
import subprocess
import sys
import tempfile
import unittest

import cv2
import numpy

RENDER = sys.argv[1]

# Pixels that the middle of a square may be off: its edges are drawn with four samples a pixel, and the map of a
# square is not quite a square.
OFF = 0.15

SIZE = (1280, 960)
HALF = 3.5  # of a square's side, pixels at the axis

# Pixels from the picture's border, and of two squares from each other, with which they are looked for.
BORDER = 12
APART = 20

OPENCV = """%%YAML:1.0
---
calibration_time: "today"
image_width: %d
image_height: %d
%s
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ %r, 0., %r, 0., %r, %r, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: %d
   cols: 1
   dt: d
   data: [ %s ]
"""


def opencv_file(model, matrix, coefficients, size=SIZE):
    fx, fy, cx, cy = matrix
    numbers = ", ".join(repr(c) for c in coefficients)
    return OPENCV % (*size, model, fx, cx, fy, cy, len(coefficients), numbers)


def directions(most):
    """Of the squares: OpenCV's axes, x to the right, y down, z ahead."""
    rings = numpy.radians(numpy.arange(0, most, 9))
    found = [(0.0, 0.0, 1.0)]
    for theta in rings[1:]:
        for azimuth in numpy.radians(numpy.arange(0, 360, 24) + 100 * theta):
            s = numpy.sin(theta)
            found.append((s * numpy.cos(azimuth), s * numpy.sin(azimuth), numpy.cos(theta)))
    return numpy.array(found)


def squares(points, half):
    """An .obj file of a square round each point, half its side in radians, seen from the origin; y up and z
    behind."""
    lines = []
    for number, point in enumerate(points):
        d = point * (1, -1, -1)
        u = numpy.cross(d, (1, 0, 0) if abs(d[0]) < 0.5 else (0, 1, 0))
        u *= half / numpy.linalg.norm(u)
        v = numpy.cross(d, u)
        for corner in (d - u - v, d + u - v, d + u + v, d - u + v):
            lines.append("v %r %r %r" % tuple(float(c) for c in corner))
        lines.append("f %d %d %d %d" % tuple(4 * number + i for i in (1, 2, 3, 4)))
    return "\n".join(lines) + "\n"


class Lenses(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name, text=None):
        path = os.path.join(self.folder.name, name)
        if text is not None:
            with open(path, "w", encoding="ascii") as file:
                file.write(text)
        return path

    def find(self, lens, points, half, words=()):
        """The middles of what is drawn, OpenCV's pixels, and the picture's size."""
        picture = self.path("picture.png")
        subprocess.run([RENDER, self.path("squares.obj", squares(points, half)), "--eye", "0,0,0",
                        "--clip", "0.5,2", "--lens-file", lens, *words, "-o", picture],
                       check=True, timeout=120)
        grey = cv2.imread(picture).max(axis=2).astype(numpy.float32)
        parts = cv2.connectedComponents((grey > 0).astype(numpy.uint8))[1]
        rows, columns = numpy.indices(grey.shape)
        sums = [numpy.bincount(parts.ravel(), (grey * w).ravel())[1:] for w in (columns, rows, 1)]
        return numpy.stack([sums[0] / sums[2], sums[1] / sums[2]], axis=-1), grey.shape[::-1]

    def check(self, lens, points, places, focal, size=SIZE, words=()):
        found, drawn = self.find(lens, points, HALF / focal, words)
        self.assertEqual(drawn, size)
        inside = ((places > BORDER) & (places < numpy.array(size) - BORDER)).all(axis=1)
        self.assertGreater(inside.sum(), 30)
        for place in places[inside]:
            if numpy.sort(numpy.linalg.norm(places - place, axis=1))[1] < APART:
                continue
            off = numpy.linalg.norm(found - place, axis=1).min()
            self.assertLess(off, OFF, "of the square that belongs to %s" % place)

    def check_opencv(self, matrix, coefficients, words=(), size=SIZE, scale=1):
        fx, fy, cx, cy = matrix
        lens = self.path("lens.yml", opencv_file("flags: 0", matrix, coefficients))
        k = numpy.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]], float)
        points = directions(50)
        zero = numpy.zeros(3)
        places = cv2.projectPoints(points, zero, zero, k, numpy.array(coefficients, float))[0][:, 0]
        self.check(lens, points, scale * (places + 0.5) - 0.5, scale * fx, size, words)

    def test_fisheye(self):
        matrix, coefficients = (411.3, 415.9, 655.2, 470.4), (-0.021, 0.0043, -0.0061, 0.0009)
        fx, fy, cx, cy = matrix
        k = numpy.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]], float)
        points = directions(86)
        zero = numpy.zeros(3)
        places = cv2.fisheye.projectPoints(
            points[:, None], zero, zero, k, numpy.array(coefficients, float))[0][:, 0]
        for model in ("fisheye_model: 1", "distortion_model: equidistant"):
            lens = self.path("lens.yml", opencv_file(model, matrix, coefficients))
            self.check(lens, points, places, fx)
        # COLMAP counts from the corner of the first pixel
        lens = self.path("cameras.txt", "# cameras\n7 OPENCV_FISHEYE %d %d %r %r %r %r %r %r %r %r\n" % (
            *SIZE, fx, fy, cx + 0.5, cy + 0.5, *coefficients))
        self.check(lens, points, places, fx)

    def check_colmap(self, model, numbers, places):
        """places: of the directions, in COLMAP's pixels divided by the focal lengths."""
        matrix = numbers[:4]
        lens = self.path("cameras.txt", "7 %s %d %d %s\n" % (model, *SIZE, " ".join(map(repr, numbers))))
        self.check(lens, directions(60), places * matrix[:2] + matrix[2:] - 0.5, matrix[0])

    def test_colmap_fov(self):
        x, y, z = directions(60).T
        r, w = numpy.hypot(x, y) / z, 0.9
        factor = numpy.where(r > 0, numpy.arctan(2 * r * numpy.tan(w / 2)) / w / numpy.maximum(r, 1e-9), 1)
        self.check_colmap("FOV", (605.5, 611.0, 640.5, 470.0, w), numpy.stack([x, y], 1) * (factor / z)[:, None])

    def test_colmap_thin_prism_fisheye(self):
        k1, k2, p1, p2, k3, k4, sx, sy = prism = (-0.02, 0.004, 0.003, -0.002, 0.001, -0.0005, 0.004, -0.003)
        x, y, z = directions(60).T
        theta = numpy.arctan2(numpy.hypot(x, y), z)
        u, v = (theta * c / numpy.maximum(numpy.hypot(x, y), 1e-9) for c in (x, y))
        s = theta * theta
        radial = 1 + s * (k1 + s * (k2 + s * (k3 + s * k4)))
        places = numpy.stack([u * radial + 2 * p1 * u * v + p2 * (s + 2 * u * u) + sx * s,
                              v * radial + 2 * p2 * u * v + p1 * (s + 2 * v * v) + sy * s], 1)
        self.check_colmap("THIN_PRISM_FISHEYE", (605.5, 611.0, 640.5, 470.0, *prism), places)

    def test_kalibr(self):
        matrix, k = (905.5, 899.1, 611.0, 502.5), (-0.21, 0.09, 0.004, -0.003)
        lens = self.path("cams.yaml", "cam0:\n  camera_model: pinhole\n  intrinsics: %s\n  distortion_model: radtan\n"
                         "  distortion_coeffs: %s\n  resolution: %s\n" % (list(matrix), list(k), list(SIZE)))
        fx, fy, cx, cy = matrix
        points, zero = directions(50), numpy.zeros(3)
        eye = numpy.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
        self.check(lens, points, cv2.projectPoints(points, zero, zero, eye, numpy.array(k))[0][:, 0], fx)

    def test_radial(self):
        self.check_opencv((905.5, 899.1, 611.0, 502.5), (-0.21, 0.09, 0, 0, -0.012))

    def test_another_size(self):
        half = (SIZE[0] // 2, SIZE[1] // 2)
        self.check_opencv((905.5, 899.1, 611.0, 502.5), (-0.11, 0.03, 0, 0, 0),
                          ["--size", "%dx%d" % half], half, 0.5)

    def test_pinhole(self):
        self.check_opencv((905.5, 905.5, 200.0, 479.5), (0, 0, 0, 0))

    def test_decentering(self):
        self.check_opencv((905.5, 899.1, 611.0, 502.5), (-0.21, 0.09, 0.004, -0.003, -0.012))

    def test_rational(self):
        self.check_opencv((905.5, 899.1, 611.0, 502.5), (0.3, 0.05, 0.001, 0.002, 0.01, 0.5, 0.1, 0.02))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
