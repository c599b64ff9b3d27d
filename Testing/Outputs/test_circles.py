#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A round map whose circle lies anywhere is a part of a larger picture of the same circle, whatever is drawn.

    test_circles.py WIDEFOV_RENDER
"""

import os
import subprocess
import sys
import tempfile
import unittest

import numpy

RENDER = sys.argv[1]

SMALL = (260, 180)
LARGE = (900, 700)
CORNER = (180, 240)  # of the small picture in the large one, pixels from above

# Levels of 255 that two pixels may differ by, and the part of them that may differ more: places in the two
# pictures are rounded differently, which decides where a pixel's centre is on an edge.
LEVELS = 2
ON_EDGES = 0.002

# Surfaces, wide lines, points, balls, a gradient.
SCENES = {
    "surfaces": "--scene cornell",
    "lines": "--scene cornell --representation wireframe --line-width 4",
    "points": "--scene globe --representation points --point-size 5",
    "balls": "--scene balls",
    "gradient": "--scene cornell --background 1,0.5,0 --zenith 0,0.2,1",
}

# The centre of the circle and its radius, pixels of the large picture; the last is flat at its rim.
MAPS = {
    "azimuthal-equidistant --fov 220": (330, 310, 170),
    "brown-conrady --fov 110 --lens 1.2,0,-0.05": (150, 380, 260),
    "orthographic --fov 180": (420, 300, 140),
}


class Circles(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def draw(self, words, size, circle):
        path = os.path.join(self.folder.name, "picture.png")
        subprocess.run([RENDER, *words.split(), "--technique", "exact", "--samples", "0",
                        "--size", "%dx%d" % size, "--circle", "%r,%r,%r" % circle, "-o", path],
                       check=True, timeout=120)
        ppm = path + ".ppm"
        subprocess.run(["oiiotool", path, "--ch", "R,G,B", "-d", "uint8", "-o", ppm], check=True)
        with open(ppm, "rb") as file:
            for _ in range(3):
                file.readline()
            data = file.read()
        return numpy.frombuffer(data, numpy.uint8, 3 * size[0] * size[1]).reshape(size[1], size[0], 3)

    def test_small_is_part_of_large(self):
        for number, (name, scene) in enumerate(SCENES.items()):
            projection, (x, y, r) = list(MAPS.items())[number % len(MAPS)]
            words = "%s --projection %s --tilt 20" % (scene, projection)
            large = self.draw(words, LARGE, (x, y, r)).astype(int)
            small = self.draw(words, SMALL, (x - CORNER[0], y - CORNER[1], r)).astype(int)
            part = large[CORNER[1]:CORNER[1] + SMALL[1], CORNER[0]:CORNER[0] + SMALL[0]]
            with self.subTest(name):
                self.assertGreater(part.any(axis=2).mean(), 0.02)
                off = abs(part - small).max(axis=2) > LEVELS
                self.assertLess(off.mean(), ON_EDGES, "first at %s" % numpy.argwhere(off)[:1].tolist())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
