#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The viewer's panel, files that are dropped on it, and what it does while it reads.

    test_panel.py VIEWER RENDER [unittest option...]

One display and, but for the last tests, one viewer serve all, for starting takes longest.
"""

import os
import subprocess
import sys
import tempfile
import unittest

import numpy
from matplotlib import image

import targets
from desktop import Desktop, Source, Viewer

PROGRAMS = {}
# Of the file that takes a while: a second of reading and more, anywhere.
MANY_POINTS = 1500000


class Shared(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.desktop = Desktop("800x600")
        cls.addClassCleanup(cls.desktop.close)
        folder = tempfile.TemporaryDirectory(prefix="viewer-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        targets.write(cls.path("marks.vtk"))

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    def start(self, *words, waits=True):
        options = ["--eye", "0,0,0", "--size", "700x400", "--samples", "0", "--no-text"]
        viewer = Viewer(
            self.desktop, PROGRAMS["viewer"], list(words) + options, self.folder, waits
        )
        self.addCleanup(viewer.kill)
        viewer.point(5, 5)
        return viewer


class Panel(Shared):
    def test_widgets_do_what_keys_do(self):
        viewer = self.start("marks.vtk")
        plain = viewer.photograph()
        viewer.key("Tab", look=lambda s: s["panel"])
        left = viewer.state()["panel"]["projection"][0]
        changed = (viewer.photograph() != plain).any(2).any(0).nonzero()[0]
        self.assertGreater(changed[0], left - 50, "the picture beside the panel is as it was")

        viewer.click("projection")
        self.assertEqual(viewer.click("projection/hammer")["projection"], "hammer")
        self.assertIsNotNone(targets.find(viewer.photograph(), "red"))
        self.assertLess(viewer.click("field of view")["hfov"], 300)
        self.assertNotEqual(viewer.click("tilt")["tilt"], 0)

        before = viewer.state()
        places = before["panel"]["technique"]
        state = viewer.drag((int(places[0]) + 5, int(places[1]) - 60), (200, 200))
        self.assertEqual(state["direction"], before["direction"], "dragged through the panel")
        viewer.key("Escape", look=lambda s: not s["panel"])
        self.assertNotEqual(viewer.drag((200, 200), (250, 200))["direction"], before["direction"])

    def test_screenshots_and_poses(self):
        viewer = self.start("marks.vtk", "--poses", "tour.txt", "--panel")
        viewer.click("screenshot")
        name = viewer.wait(lambda s: "written" in s["message"])["message"].split()[-1]
        taken = numpy.rint(image.imread(self.path(name))[:, :, :3] * 255)
        viewer.key("Tab", look=lambda s: not s["panel"])
        self.assertEqual((taken != viewer.photograph()).any(2).sum(), 0)

        viewer.key("k", look=lambda s: "pose 1" in s["message"])
        viewer.key("Right", look=lambda s: s["yaw"] > 0)
        state = viewer.key("k", look=lambda s: "pose 2" in s["message"])
        with open(self.path("tour.txt"), encoding="utf-8") as stream:
            poses = [[float(word) for word in line.split()] for line in stream]
        self.assertEqual([len(pose) for pose in poses], [9, 9])
        self.assertEqual(poses[1], state["eye"] + state["direction"] + state["up"])
        self.assertNotEqual(poses[0][3:6], poses[1][3:6])
        self.desktop.key("q")
        self.assertEqual(viewer.end(), 0)


class Files(Shared):
    def test_dropped_files(self):
        with open(self.path("dot.vtk"), "w", encoding="utf-8") as stream:
            stream.write("# vtk DataFile Version 3.0\na dot\nASCII\nDATASET POLYDATA\n"
                "POINTS 2 float\n8 8 8\n9 9 9\nVERTICES 2 4\n1 0\n1 1\n")
        viewer = self.start("marks.vtk")
        self.assertIsNotNone(targets.find(viewer.photograph(), "red"))
        source = Source(self.desktop)
        for name in ("junk.vtk", "long.vtk"):
            with open(self.path(name), "wb") as stream:
                stream.write(b"no data\n" * (200000 if name == "long.vtk" else 1))
        for name, says in (("nowhere.vtk", "nowhere.vtk"), ("junk.vtk", "junk.vtk"),
                           ("long.vtk", "long.vtk"), ("dot.vtk", "opened")):
            before = viewer.state()
            source.drop(viewer.window, [self.path(name)])
            state = viewer.wait(lambda s, says=says: says in s["message"])
            opened = says == "opened"
            if opened: # outside of the data
                self.assertGreater(min(state["eye"]), 9)
            else:
                self.assertEqual(state["eye"], before["eye"])
            self.assertEqual(targets.find(viewer.photograph(), "red") is None, opened)
        said = [line for line in viewer.said().splitlines() if "the eye is" not in line]
        for name, line in zip(("nowhere.vtk", "junk.vtk", "long.vtk"), said, strict=True):
            self.assertIn(name, line)

    def test_what_takes_long_and_cannot_be_read(self):
        with open(self.path("long.vtk"), "wb") as stream:
            stream.write(b"no data\n" * 200000)
        done = subprocess.run([PROGRAMS["viewer"], "long.vtk"], cwd=self.folder, check=False,
            env={**os.environ, "DISPLAY": self.desktop.name}, stdin=subprocess.DEVNULL,
            stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn("long.vtk cannot be read", done.stderr)

    def test_quits_while_it_reads(self):
        with open(self.path("slow.vtk"), "w", encoding="utf-8") as stream:
            stream.write("# vtk DataFile Version 3.0\nmany\nASCII\nDATASET POLYDATA\n")
            stream.write("POINTS %d float\n" % MANY_POINTS)
            stream.write("0.25 0.5 0.75\n" * MANY_POINTS)
        viewer = self.start("slow.vtk", waits=False)
        self.assertEqual(viewer.states(), [], "it still reads")
        self.desktop.key("q")
        self.assertEqual(viewer.end(), 0)
        self.assertEqual((viewer.states(), viewer.said()), ([], ""), "it had read all")


if __name__ == "__main__":
    PROGRAMS["viewer"], PROGRAMS["render"] = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=[sys.argv[0], "--verbose"] + sys.argv[3:])
