#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time steps, volumes, presets and sessions in the viewer.

    test_daily.py VIEWER RENDER [unittest option...]
"""

import os
import shlex
import subprocess
import sys
import tempfile
import unittest

import numpy
from matplotlib import image

from desktop import Desktop, Viewer

PROGRAMS = {}
# Of the squares of the time steps: where each is, scene units to the right.
PLACES = (-1.0, 0.0, 1.0)
SIDE = 0.4
# Columns of the window that the panel leaves free.
LEFT = 350
# Of the same state in numbers that went through text: rounding.
SAME = 1e-12


def write_steps(folder):
    """A square two units ahead, at another place in each step."""
    for i, x in enumerate(PLACES):
        with open(os.path.join(folder, "step%d.vtk" % i), "w", encoding="utf-8") as stream:
            stream.write("# vtk DataFile Version 3.0\na square\nASCII\nDATASET POLYDATA\n")
            stream.write("POINTS 4 float\n")
            for dx, dy in ((0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE)):
                stream.write("%g %g -2\n" % (x + dx - SIDE / 2, dy - SIDE / 2))
            stream.write("POLYGONS 1 5\n4 0 1 2 3\n")
    with open(os.path.join(folder, "steps.vtk.series"), "w", encoding="utf-8") as stream:
        stream.write('{"file-series-version": "1.0", "files": [%s]}' % ", ".join(
            '{"name": "step%d.vtk", "time": %g}' % (i, 10 * i) for i in range(len(PLACES))))


def write_volume(path):
    """A ball that is dense in the middle."""
    n = 16
    z, y, x = (numpy.indices((n, n, n)) - (n - 1) / 2) / n
    values = 1 - numpy.sqrt(x * x + y * y + z * z)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write("# vtk DataFile Version 3.0\na ball\nASCII\nDATASET STRUCTURED_POINTS\n"
            "DIMENSIONS %d %d %d\nORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA %d\n"
            "SCALARS density float 1\nLOOKUP_TABLE default\n" % (n, n, n, n**3))
        stream.write("\n".join("%g" % value for value in values.ravel()) + "\n")


class Daily(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.desktop = Desktop("900x600")
        cls.addClassCleanup(cls.desktop.close)
        folder = tempfile.TemporaryDirectory(prefix="viewer-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        write_steps(cls.folder)
        write_volume(os.path.join(cls.folder, "ball.vtk"))

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    def start(self, *words):
        options = [] if "--session" in words else ["--size", "700x500"]
        viewer = Viewer(self.desktop, PROGRAMS["viewer"],
            list(words) + options + ["--samples", "0", "--no-text"], self.folder)
        self.addCleanup(viewer.kill)
        viewer.point(5, 5)
        return viewer

    def refuse(self, code, *words):
        """The one line with which it ends."""
        done = subprocess.run([PROGRAMS["viewer"], *words], cwd=self.folder, check=False,
            env={**os.environ, "DISPLAY": self.desktop.name}, stdin=subprocess.DEVNULL,
            stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        return done.stderr

    def check_place(self, picture, step):
        """The square of that step is where it belongs, in a perspective of 90 degrees."""
        columns = picture.any(2).any(0).nonzero()[0]
        width = picture.shape[1]
        expected = width / 2 + width / 2 * PLACES[step] / 2
        self.assertLess(abs(columns.mean() + 0.5 - expected), 1, "step %d" % step)

    def render(self, viewer):
        """What widefov-render draws by the command that the viewer prints."""
        viewer.key("c", look=lambda s: "standard output" in s["message"])
        words = shlex.split(viewer.printed().splitlines()[-1])[1:]
        words[words.index("--output") + 1] = "rendered.png"
        subprocess.run([PROGRAMS["render"], *words], cwd=self.folder, check=True,
            env={**os.environ, "DISPLAY": self.desktop.name})
        return numpy.rint(image.imread(self.path("rendered.png"))[:, :, :3] * 255)


class Time(Daily):
    VIEW = ["--eye", "0,0,0", "--projection", "perspective", "--hfov", "90", "--no-colors"]

    def test_steps_by_keys_and_slider(self):
        viewer = self.start("steps.vtk.series", "--time", "10", *self.VIEW)
        self.assertEqual(viewer.state()["time"],
            {"step": 2, "steps": 3, "time": 10, "playing": False})
        self.check_place(viewer.photograph(), 1)
        viewer.key("period", look=lambda s: s["time"]["step"] == 3)
        picture = viewer.photograph()
        self.check_place(picture, 2)
        self.assertEqual((self.render(viewer) != picture).any(2).sum(), 0, "the command")
        viewer.key("period", look=lambda s: s["time"]["step"] == 1)
        viewer.key("comma", look=lambda s: s["time"]["step"] == 3)
        viewer.key("Tab", look=lambda s: s["panel"])
        viewer.click("time")
        viewer.wait(lambda s: s["time"]["step"] == 1)
        viewer.key("Tab", look=lambda s: not s["panel"])
        self.check_place(viewer.photograph(), 0)

    def test_plays_numbered_files_round_and_round(self):
        viewer = self.start("step%d.vtk", "--time-rate", "10", *self.VIEW)
        before = len(viewer.states())
        self.desktop.key("space")
        viewer.wait(lambda s: len(self.steps(viewer, before)) > 4)
        self.desktop.key("space")
        state = viewer.wait(lambda s: not s["time"]["playing"])
        steps = self.steps(viewer, before)
        for a, b in zip(steps, steps[1:]):
            self.assertEqual(b, a % 3 + 1, steps)
        self.check_place(viewer.photograph(), state["time"]["step"] - 1)

    @staticmethod
    def steps(viewer, first):
        """Those shown, each once."""
        shown = [s["time"]["step"] for s in viewer.states()[first:]]
        return [a for a, b in zip(shown, [None] + shown) if a != b]

    def test_what_does_not_change(self):
        self.assertIn("--time needs data", self.refuse(2, "step0.vtk", "--time", "1"))
        viewer = self.start("step0.vtk", *self.VIEW)
        self.assertIsNone(viewer.state()["time"])
        viewer.key("period", look=lambda s: "do not change" in s["message"])


class Session(Daily):
    KEPT = ("size", "projection", "technique", "hfov", "vfov", "tilt", "eye", "direction", "up",
            "time", "stereo", "layout")

    def test_begins_where_it_was_saved(self):
        viewer = self.start("steps.vtk.series", "--session", "my.conf", "--size", "500x300",
            "--projection", "hammer", "--background", "0.2,0.1,0", "--no-smooth")
        self.assertIn("my.conf is not there yet", viewer.said())
        viewer.key("Right", look=lambda s: s["yaw"] > 0)
        viewer.key("minus")
        viewer.key("o", look=lambda s: s["stereo"] != "mono")
        viewer.key("period", look=lambda s: s["time"]["step"] == 2)
        saved = viewer.key("F3", look=lambda s: "saved: my.conf" in s["message"])
        picture = viewer.photograph()
        viewer.kill()
        viewer = self.start("--session", "my.conf")
        state = viewer.state()
        for name in self.KEPT:
            if name in ("eye", "direction", "up"):
                self.assertLess(numpy.abs(numpy.subtract(state[name], saved[name])).max(), SAME)
            else:
                self.assertEqual(state[name], saved[name], name)
        self.assertEqual((viewer.photograph() != picture).any(2).sum(), 0)

    def test_bad_content(self):
        with open(self.path("junk.conf"), "wb") as stream:
            stream.write(b"\0\1\2 no options\n")
        with open(self.path("odd.conf"), "w", encoding="utf-8") as stream:
            stream.write("scene = winds\nprojektion = hammer\n")
        self.assertIn("junk.conf, line 1", self.refuse(2, "--session", "junk.conf"))
        self.assertIn("odd.conf, line 2", self.refuse(2, "--session", "odd.conf"))
        self.assertIn("is a folder", self.refuse(1, "--session", "."))


class Widgets(Daily):
    def test_opacity_and_presets(self):
        viewer = self.start("ball.vtk", "--panel")
        thick = viewer.photograph()[:, :LEFT].astype(float).mean()
        viewer.click("opacity")
        self.assertLess(viewer.photograph()[:, :LEFT].astype(float).mean(), 0.9 * thick)
        viewer.click("preset")
        state = viewer.click("preset/domemaster-4k")
        self.assertEqual([state[name] for name in ("projection", "hfov", "vfov", "tilt", "stereo")],
            ["azimuthal-equidistant", 180, 180, 90, "mono"])
        self.assertEqual(state["size"], [700, 500])


if __name__ == "__main__":
    PROGRAMS["viewer"], PROGRAMS["render"] = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=[sys.argv[0], "--verbose"] + sys.argv[3:])
