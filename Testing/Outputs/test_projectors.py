#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures for projectors: a mesh that changes nothing, one that moves and darkens, a display of two.

    test_projectors.py WIDEFOV_RENDER
"""

import json
import os
import sys
import unittest

import numpy

from all_directions import LEVELS, SkyTest, read_picture, run

RENDER = sys.argv[1]

# Levels of 255 of a white picture behind a mask: a half for rounding, a half for the mask's own.
MASK_LEVELS = 1

# Largest error of the summed light of two projectors, as a fraction of white: half a level each, gamma 2.2.
LIGHT = 2 * 2.2 * 0.5 / 255 + 1e-3

SIZE = 128


def mesh(shown):
    """A mesh of 3 x 3 nodes; shown: place in the picture, 0 to 1, to u, v and intensity."""
    lines = ["2", "3 3"]
    for i in range(9):
        x, y = 0.5 * (i % 3), 0.5 * (i // 3)
        lines.append("%.9g %.9g %.9g %.9g %.9g" % ((2 * x - 1, 2 * y - 1) + shown(x, y)))
    return "\n".join(lines) + "\n"


class Projectors(SkyTest):
    def draw(self, *words):
        run(RENDER, self.path("speck.obj"), "--eye", "0,0,0", "--samples", "0", "-o",
            self.path("drawn.png"), *words)

    def drawn(self, *words):
        self.draw(*words)
        return read_picture(self.path("drawn.png"))

    def check_same(self, ours, theirs):
        inside = ours.any(axis=2) & theirs.any(axis=2)
        self.assertGreater(inside.mean(), 0.5)
        off = abs(ours - theirs).max(axis=2) > LEVELS
        worst = numpy.argwhere(off & inside)
        self.assertEqual((off & inside).sum(), 0, "first of them at %s" % (worst[:1][:, ::-1].tolist(),))

    def test_mesh_of_itself(self):
        """A mesh whose u, v are its places shows the fisheye that it refers to."""
        path = self.write("same.data", mesh(lambda x, y: (x, y, 1)))
        fisheye = ["--sky", self.sky, "--projection", "azimuthal-equidistant", "--fov", "180", "--tilt", "30",
                   "--size", "%dx%d" % (SIZE, SIZE)]
        self.check_same(self.drawn(*fisheye, "--warp", path), self.drawn(*fisheye))

    def test_part_of_a_picture(self):
        """A mesh that shows the upper right quarter shows it as large as the quarter of a larger picture."""
        path = self.write("quarter.data", mesh(lambda x, y: (0.5 + 0.5 * x, 0.5 + 0.5 * y, 1)))
        map_of = ["--sky", self.sky, "--projection", "azimuthal-equidistant", "--fov", "180"]
        whole = self.drawn(*map_of, "--size", "%dx%d" % (2 * SIZE, 2 * SIZE))
        part = self.drawn(*map_of, "--size", "%dx%d" % (SIZE, SIZE), "--warp", path)
        self.check_same(part, whole[:SIZE, SIZE:])

    def test_intensity(self):
        """A white picture is as bright as the mesh says, from left to right."""
        path = self.write("ramp.data", mesh(lambda x, y: (x, y, x)))
        row = self.drawn("--background", "1,1,1", "--projection", "equirectangular", "--size",
                         "%dx%d" % (SIZE, SIZE), "--warp", path)[SIZE // 2, :, 0]
        expected = 255 * (numpy.arange(SIZE) + 0.5) / SIZE
        self.assertLessEqual(abs(row - expected).max(), MASK_LEVELS)

    def test_tiles(self):
        """Tiles of a picture are as bright as the picture."""
        path = self.write("ramp.data", mesh(lambda x, y: (x, y, 0.5 * x + 0.5 * y)))
        words = ["--background", "1,1,1", "--projection", "equirectangular", "--size",
                 "%dx%d" % (SIZE, SIZE), "--warp", path]
        self.assertEqual(abs(self.drawn(*words) - self.drawn(*words, "--tile", "64x64")).max(), 0)

    def test_display(self):
        """Two projectors on a wall: each has a file, and shows its part of the same picture."""
        projectors = [
            {"name": name, "size": [SIZE, SIZE],
             "lens": {"position": [x, 0, 0], "direction": [0, 0, -1], "throw-ratio": 1}}
            for name, x in (("left", -0.375), ("right", 0.375))
        ]
        wall = {"type": "plane", "lower-left": [-2, -2, -1], "lower-right": [2, -2, -1],
                "upper-right": [2, 2, -1]}
        path = self.write("wall.json", json.dumps({"surface": wall, "projectors": projectors}))
        self.draw("--background", "1,1,1", "--display", path)
        left = read_picture(self.path("drawn-left.png"))[SIZE // 2, :, 0]
        right = read_picture(self.path("drawn-right.png"))[SIZE // 2, :, 0]
        self.assertEqual(left[0], 255)
        self.assertEqual(right[-1], 255)
        # light of both adds up to white where they overlap: a quarter of each, pixel upon pixel
        shift = SIZE * 3 // 4
        both = (left[shift:] / 255) ** 2.2 + (right[: SIZE - shift] / 255) ** 2.2
        self.assertLess(abs(both - 1).max(), LIGHT)
        self.draw("--background", "1,1,1", "--display", path, "--projector", "right", "-o",
                  self.path("one.png"))
        self.assertTrue(os.path.exists(self.path("one-right.png")))
        self.assertFalse(os.path.exists(self.path("one-left.png")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
