#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""widefov-render --screens and --pose: the files that appear, their sizes, what they show.

    test_room.py WIDEFOV-RENDER
"""

import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy
from matplotlib.image import imread

PROGRAM = ""

CAVE = """<?xml version="1.0" ?>
<pvx><Process Type="server">
<EyeSeparation Value="0.2"/>
<Machine Name="Left" Geometry="60x40+0+0"
  LowerLeft="-1 -1 1" LowerRight="-1 -1 -1" UpperRight="-1 1 -1"/>
<Machine Name="Front"
  LowerLeft="-1 -1 -1" LowerRight="1 -1 -1" UpperRight="1 1 -1"/>
<Machine Name="Front"
  LowerLeft="1 -1 -1" LowerRight="1 -1 1" UpperRight="1 1 1"/>
</Process></pvx>
"""

# One screen that shows what a perspective of 90 by 90 degrees does from the origin.
FRONT = """<?xml version="1.0" ?>
<pvx><Machine Name="Front" LowerLeft="-1 -1 -1" LowerRight="1 -1 -1" UpperRight="1 1 -1"/></pvx>
"""


class RoomTest(unittest.TestCase):
    """Each test in a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="room-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write("cave.pvx", CAVE)
        self.write("front.pvx", FRONT)

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as stream:
            stream.write(text)

    def render(self, *options):
        """The new files, sorted."""
        before = set(os.listdir(self.folder))
        command = [PROGRAM, "--scene", "cornell", "--samples", "0"]
        command += [] if "--eye" in options else ["--eye", "0.1,0.2,0.9"]
        done = subprocess.run(
            command + list(options), cwd=self.folder, capture_output=True, text=True, check=False
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        return sorted(set(os.listdir(self.folder)) - before)

    def picture(self, name):
        return imread(os.path.join(self.folder, name))

    def difference(self, first, second):
        """The share of pixels that differ."""
        a, b = self.picture(first), self.picture(second)
        self.assertEqual(a.shape, b.shape)
        return numpy.mean(numpy.any(a != b, axis=2))

    def test_one_file_a_screen(self):
        files = self.render("--screens", "cave.pvx", "-o", "cave.png")
        self.assertEqual(files, ["cave-Front-2.png", "cave-Front.png", "cave-Left.png"])
        self.assertEqual(self.picture("cave-Left.png").shape[:2], (40, 60))
        self.assertEqual(self.picture("cave-Front.png").shape[:2], (1024, 1024))

    def test_size_is_that_of_every_screen(self):
        self.render("--screens", "cave.pvx", "--size", "30x20", "-o", "cave.png")
        for name in ("Left", "Front", "Front-2"):
            self.assertEqual(self.picture("cave-%s.png" % name).shape[:2], (20, 30))

    def test_eyes_and_poses_in_the_names(self):
        self.write("poses.txt", "0 0 0 0 0 0 0 1\n# half a unit to the right\n1 .5 0 0 0 0 0 1\n")
        files = self.render(
            "--screens", "front.pvx", "--pose", "poses.txt", "--stereo", "offaxis",
            "--layout", "separate", "--ipd", "0.2", "--size", "64x64", "-o", "a.png",
        )
        names = ["a-Front-%s-%04d.png" % (eye, n) for eye in ("left", "right") for n in (1, 2)]
        self.assertEqual(files, sorted(names))
        self.assertGreater(self.difference(names[0], names[2]), 0.01)
        self.assertGreater(self.difference(names[0], names[1]), 0.01)

    def test_a_screen_ahead_is_a_perspective(self):
        self.render("--screens", "front.pvx", "--size", "64x64", "-o", "screen.png")
        self.render(
            "--projection", "perspective", "--hfov", "90", "--size", "64x64", "-o", "flat.png"
        )
        a, b = self.picture("screen-Front.png"), self.picture("flat.png")
        # the light differs: from the eye here, along the axis there; what is black does not
        black = numpy.mean(numpy.all(a == 0, axis=2) != numpy.all(b == 0, axis=2))
        self.assertLess(black, 0.01)

    def test_file_says_how_far_eyes_are_apart(self):
        options = ["--stereo", "offaxis", "--layout", "left", "--size", "64x64"]
        self.render("--screens", "cave.pvx", *options, "-o", "a.png")
        self.render("--screens", "cave.pvx", *options, "--ipd", "0.2", "-o", "b.png")
        self.render("--screens", "cave.pvx", *options, "--ipd", "0.4", "-o", "c.png")
        self.assertEqual(self.difference("a-Front.png", "b-Front.png"), 0)
        self.assertGreater(self.difference("a-Front.png", "c-Front.png"), 0.01)

    def test_scale_of_the_room(self):
        self.render("--screens", "front.pvx", "--size", "64x64", "-o", "a.png")
        self.render("--screens", "front.pvx", "--room-scale", "7", "--size", "64x64", "-o", "b.png")
        self.assertEqual(self.difference("a-Front.png", "b-Front.png"), 0)

    def test_three_degrees_turn_the_view(self):
        half = math.radians(30) / 2
        self.write("turn.txt", "0 0 %r 0 %r\n" % (math.sin(half), math.cos(half)))
        view = ["--fov", "150", "--projection", "azimuthal-equidistant", "--size", "64x64"]
        ahead = "%r,0,%r" % (-math.sin(2 * half), -math.cos(2 * half))
        self.render(*view, "--pose", "turn.txt", "-o", "pose.png")
        self.render(*view, "--direction", ahead, "-o", "turned.png")
        self.assertLess(self.difference("pose.png", "turned.png"), 0.002)

    def test_six_degrees_move_the_eye(self):
        self.write("move.txt", "0 0.1 -0.2 -0.5 0 0 0 1\n")
        view = ["--projection", "hammer", "--size", "64x32"]
        self.render(*view, "--pose", "move.txt", "-o", "pose.png")
        self.render(*view, "--eye", "0.2,0,0.4", "-o", "moved.png")
        self.assertLess(self.difference("pose.png", "moved.png"), 0.002)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
