#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Drives widefov-viewer as a user does, and looks at its window.

    test_viewer.py VIEWER RENDER [unittest option...]

VIEWER and RENDER are widefov-viewer and widefov-render. Every test has a display of its own
with real key and mouse events; what is shown is measured in photographs of the window.
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
import unittest

import numpy
from matplotlib import image

import targets
from desktop import Desktop, Viewer, wait_for

# Pixels by which a mark may be off: half a pixel of the pointer, and what a few pixels'
# middle moves when the map bends them.
NEAR = 1.0
# Pixels between the direction grabbed and the one under the pointer, as the viewer says.
SAME_DIRECTION = 0.01
# Sine of the angle by which the horizon may lean: rounding.
UPRIGHT = 1e-9
# Of 255, on average: a picture that is made of one with pixels four times as large.
BLURRED = 12
# Seconds of processor time in one and a half with nothing to do.
IDLE_TIME = 0.1

PROGRAMS = {}


class ViewerTest(unittest.TestCase):
    """A display and a folder with the marks."""

    def setUp(self):
        self.desktop = Desktop()
        self.addCleanup(self.desktop.close)
        folder = tempfile.TemporaryDirectory(prefix="viewer-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        targets.write(os.path.join(self.folder, "marks.vtk"))

    def start(self, *arguments, scene=("marks.vtk",), text=False):
        words = list(scene) + ["--eye", "0,0,0"] if "--eye" not in arguments else list(scene)
        words += list(arguments) + ([] if text else ["--no-text"])
        if "--size" not in words:
            words += ["--size", "640x320"]
        if "--samples" not in words:
            # VTK resolves samples for a window in another way than for a file
            words += ["--samples", "0"]
        viewer = Viewer(self.desktop, PROGRAMS["viewer"], words, self.folder)
        self.addCleanup(viewer.kill)
        viewer.point(5, 5)
        return viewer

    def find(self, viewer, name):
        place = targets.find(viewer.photograph(), name)
        self.assertIsNotNone(place, "%s is not in the picture" % name)
        return place

    def render(self, viewer):
        """What widefov-render draws by the command that the viewer prints."""
        before = viewer.printed()
        viewer.key("c", look=lambda state: "standard output" in state["message"])
        words = shlex.split(viewer.printed()[len(before) :])
        self.assertEqual(words[0], "widefov-render")
        name = os.path.join(self.folder, "rendered.png")
        words[words.index("--output") + 1] = name
        subprocess.run(
            [PROGRAMS["render"]] + words[1:],
            cwd=self.folder,
            env={**os.environ, "DISPLAY": self.desktop.name},
            check=True,
        )
        return read_png(name)

    def check_same(self, viewer):
        photograph = viewer.photograph()
        rendered = self.render(viewer)
        self.assertEqual(photograph.shape, rendered.shape)
        different = (photograph != rendered).any(2).sum()
        state = viewer.state()
        self.assertEqual(different, 0, "%s %s" % (state["projection"], state["technique"]))
        return photograph

    def assert_ends(self, viewer, code, says=None):
        self.assertEqual(viewer.end(), code, viewer.said())
        lines = viewer.said().splitlines()
        self.assertEqual(len(lines), 0 if says is None else 1, lines)
        for line in lines:
            self.assertTrue(line.startswith("widefov-viewer: "), line)
            self.assertIn(says, line)


def read_png(name):
    """Rows from the top, red, green, blue."""
    return numpy.rint(image.imread(name)[:, :, :3] * 255).astype(numpy.uint8)


class Look(ViewerTest):
    def check_drag(self, viewer, name, end):
        start = [int(place) for place in self.find(viewer, name)]
        offset = self.find(viewer, name) - start
        state = viewer.drag(start, end)
        presses = [line for line in viewer.states() if line["event"] == "press"]
        before, after = [numpy.array(s["under_cursor"]) for s in (presses[-1], state)]
        pixel = numpy.radians(state["hfov"] / state["size"][0])
        self.assertLess(numpy.linalg.norm(before - after), SAME_DIRECTION * pixel)
        missed = self.find(viewer, name) - end - offset
        self.assertLess(numpy.hypot(*missed), NEAR, "%s: %s" % (state["projection"], missed))
        right = numpy.cross(state["direction"], state["up"])
        self.assertLess(abs(right[1]), UPRIGHT, "the horizon leans")
        return state

    def test_the_direction_grabbed_stays_under_the_pointer(self):
        for projection in ("equirectangular", "hammer", "perspective", "stereographic"):
            with self.subTest(projection=projection):
                viewer = self.start("--projection", projection, "--hfov", "120")
                self.addCleanup(viewer.kill)
                try:
                    self.check_drag(viewer, "red", (400, 190))
                    self.check_drag(viewer, "green", (250, 100))
                    self.check_drag(viewer, "red", (330, 170))
                finally:
                    viewer.kill()  # before the next one opens its window

    def test_drag_across_the_seam_behind(self):
        viewer = self.start()
        self.check_drag(viewer, "cyan", (20, 150))
        self.check_drag(viewer, "red", (620, 170))

    def test_orbit_keeps_the_centre_in_its_place(self):
        viewer = self.start("--projection", "perspective", "--hfov", "60", "--eye", "0,3,30",
            "--look-at", "0,0,0", scene=("--scene", "cornell"))
        first = viewer.state()
        second = viewer.drag((300, 160), (360, 130), button="right")
        self.assertNotEqual(first["eye"], second["eye"])
        center = numpy.zeros(3)  # of the box
        places = []
        for state in (first, second):
            away = center - state["eye"]
            right = numpy.cross(state["direction"], state["up"])
            places.append([away @ right, away @ state["up"], away @ state["direction"]])
        numpy.testing.assert_allclose(places[0], places[1], atol=1e-6)

    def test_a_moving_picture_is_coarser_and_a_still_one_is_not(self):
        for rate, coarser in (("1000", True), ("0", False)):
            viewer = self.start("--update-rate", rate, "--projection", "hammer",
                "--direction", "1,-0.3,-2", scene=("--scene", "cornell"))
            before = len(viewer.states())
            state = viewer.drag((300, 160), (340, 150), steps=40)
            moved = [s["relaxation"] for s in viewer.states()[before:] if s["event"] == "frame"]
            self.assertEqual(max(moved) > 0, coarser, "%s: %s" % (rate, moved))
            self.assertEqual(viewer.wait(lambda s: not s["pending"])["relaxation"], 0)
            self.assertFalse(state["pending"])
            self.check_same(viewer)
            viewer.kill()  # before the next one opens its window

    def test_large_scenes_have_fewer_triangles_while_they_move(self):
        """And all of them, with all samples, when they are let go."""
        viewer = self.start("--update-rate", "1000", "--samples", "4", scene=("--scene", "atrium"))
        still = viewer.photograph()
        all_of_them = viewer.state()["cluster_triangles"]["total"]
        before = len(viewer.states())
        viewer.point(300, 160)
        self.desktop.press("left")
        for x in (310, 340, 320, 300):  # there, and back
            viewer.after(lambda to=x: viewer.point(to, 160), lambda s, to=x: int(s["cursor"][0]) == to)
        viewer.after(lambda: self.desktop.release("left"), lambda s: not s["coarse"])
        moved = [s for s in viewer.states()[before:] if s["event"] == "frame" and s["coarse"]]
        self.assertTrue(moved)
        self.assertLess(max(s["cluster_triangles"]["total"] for s in moved), all_of_them / 5)
        self.assertEqual(viewer.wait(lambda s: not s["coarse"])["cluster_triangles"]["total"], all_of_them)
        self.assertLess((viewer.photograph() != still).any(2).sum(), 20)  # but for rounding

    def test_arrows_turn(self):
        viewer = self.start("--hfov", "120", "--vfov", "60")
        self.assertAlmostEqual(viewer.key("Right", look=lambda s: s["yaw"] > 0)["yaw"], 5)
        self.assertAlmostEqual(viewer.key("Up", look=lambda s: s["pitch"] > 0)["pitch"], 5)
        place = self.find(viewer, "red")
        # the eye turned to the right and up: what was in the middle went left and down
        self.assertLess(place[0], 320 - 20)
        self.assertGreater(place[1], 160 + 20)
        self.assertEqual(viewer.key("Home", look=lambda s: s["yaw"] == 0)["pitch"], 0)
        self.assertLess(numpy.hypot(*(self.find(viewer, "red") - (320, 160))), NEAR)


class Shown(ViewerTest):
    def test_keys_show_what_widefov_render_draws(self):
        viewer = self.start("--direction", "1,-0.3,-2", scene=("--scene", "room"))
        pictures = [self.check_same(viewer)]
        for key, shift in (("p", False), ("t", False), ("v", False), ("p", True), ("t", True)):
            viewer.key(key, shift)
            pictures.append(self.check_same(viewer))
        for one, two in zip(pictures[:4], pictures[1:4]):
            if one is not pictures[1]:  # another technique shows the same, all but a few pixels
                self.assertGreater((one != two).any(2).mean(), 0.05)

    def test_previews_beside_the_picture(self):
        """The plain one is what widefov-render draws, but for the pixels that it is made of."""
        viewer = self.start("--direction", "1,-0.3,-2", scene=("--scene", "room"))
        viewer.key("b")
        self.assertTrue(any(name.endswith("the dome from a seat") for name in viewer.windows()))
        viewer.key("b")
        drawn = os.path.join(self.folder, "plain.png")
        subprocess.run([PROGRAMS["render"], "--quiet", "--scene", "room", "--eye", "0,0,0", "--direction",
            "1,-0.3,-2", "--projection", "perspective", "--exact-perspective", "--vfov", "60", "--size", "640x512",
            "-o", drawn], check=True, env={**os.environ, "DISPLAY": self.desktop.name})
        plain = read_png(drawn).astype(float)

        def off(other):
            return numpy.abs(viewer.preview("a plain perspective")[0].astype(float) - other).mean()

        wait_for("the plain perspective", lambda: off(plain) < BLURRED or None)
        self.assertGreater(off(plain[:, ::-1]), 2 * BLURRED)
        viewer.key("b")
        wait_for("the preview to go", lambda: len(viewer.windows()) == 1 or None)

    def test_every_projection_and_technique_comes_and_goes(self):
        viewer = self.start("--size", "200x100")
        seen = {viewer.state()["projection"]}
        while len(seen) < 30:
            name = viewer.key("p")["projection"]
            if name in seen:
                break
            seen.add(name)
        listed = subprocess.run([PROGRAMS["render"], "--list-projections"],
            stdout=subprocess.PIPE, check=True).stdout.decode().split()
        self.assertEqual(seen, set(listed) - {"direction-map"})
        self.assertEqual(viewer.state()["projection"], "equirectangular")
        seen = [viewer.key("t")["technique"] for _ in range(5)]
        self.assertEqual(
            seen, ["exact", "preclip", "vertex", "cubemap", "auto"])

    def test_wheel_changes_the_field_of_view(self):
        viewer = self.start()
        for button, look in (("wheel up", lambda s: s["hfov"] < 330),
                             ("wheel up", lambda s: s["hfov"] < 300),
                             ("wheel down", lambda s: s["hfov"] > 300)):
            state = viewer.after(lambda b=button: self.desktop.click(b), look)
            apart = self.find(viewer, "green") - self.find(viewer, "blue")
            self.assertAlmostEqual(apart[0], 40 * 640 / state["hfov"], delta=NEAR)
            self.assertAlmostEqual(state["vfov"], state["hfov"] / 2)
        self.assertAlmostEqual(state["hfov"], 360 / 1.1)

    def test_borders(self):
        """The part of a picture that --borders names, in windows of any shape and wherever it looks."""
        viewer = self.start("--borders", "-60,90,-45,45", "--size", "600x360")
        state = viewer.drag((240, 180), (400, 200))
        self.assertLess(numpy.hypot(*(self.find(viewer, "red") - [400, 200])), NEAR)
        self.check_same(viewer)
        viewer.point(5, 5)
        viewer.resize(500, 200)
        viewer.after(lambda: self.desktop.click("wheel up"), lambda s: s["hfov"] < state["hfov"] - 1)
        self.check_same(viewer)
        self.assertEqual(viewer.key("p", shift=True)["projection"], "perspective")
        self.check_same(viewer)

    def test_text_and_help_come_and_go(self):
        viewer = self.start(text=True)
        text = viewer.photograph()
        viewer.key("F1", look=lambda s: s["help"])
        helped = viewer.photograph()
        self.assertGreater((helped[100:220, 200:440] == 255).all(2).sum(), 200, "white letters")
        viewer.key("Escape", look=lambda s: not s["help"])
        viewer.key("i", look=lambda s: not s["text"])
        plain = viewer.photograph()
        self.assertGreater((text != plain).any(2).sum(), 1000)
        self.check_same(viewer)

    def test_screenshot_is_the_picture_without_text(self):
        viewer = self.start(text=True)
        viewer.key("F2", look=lambda s: "written" in s["message"])
        name = re.search(r"written: (\S+)", viewer.state()["message"]).group(1)
        picture = read_png(os.path.join(self.folder, name))
        viewer.key("i", look=lambda s: not s["text"])
        self.assertEqual((picture != viewer.photograph()).any(2).sum(), 0)


class Flight(ViewerTest):
    def test_held_keys_fly(self):
        viewer = self.start()
        for key, axis in (("w", (0, 0, -1)), ("s", (0, 0, 1)), ("d", (1, 0, 0)),
                          ("a", (-1, 0, 0)), ("r", (0, 1, 0)), ("f", (0, -1, 0))):
            start = viewer.state()
            self.desktop.hold(key)
            time.sleep(0.1)
            end = viewer.after(lambda k=key: self.desktop.let_go(k))
            way = numpy.array(end["eye"]) - start["eye"]
            length = numpy.linalg.norm(way)
            self.assertGreater(length, 0.05, key)
            numpy.testing.assert_allclose(way / length, axis, atol=1e-9)

    def test_idle_costs_nothing(self):
        viewer = self.start()
        viewer.wait()
        lines = len(viewer.states())
        before = self.seconds(viewer)
        time.sleep(1)
        for i in range(10):  # the pointer moves, and nothing is grabbed
            viewer.point(100 + i, 100)
        time.sleep(0.5)
        self.assertLess(self.seconds(viewer) - before, IDLE_TIME)
        self.assertEqual(len(viewer.states()), lines)

    @staticmethod
    def seconds(viewer):
        """Processor time so far."""
        with open("/proc/%d/stat" % viewer.process.pid, encoding="utf-8") as stream:
            fields = stream.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Window(ViewerTest):
    def test_any_size(self):
        viewer = self.start(text=True)
        viewer.key("F1", look=lambda s: s["help"])
        for width, height in ((300, 500), (1, 1), (2, 300), (63, 33), (65, 33), (1500, 1100)):
            viewer.resize(width, height)
        viewer.key("F1", look=lambda s: not s["help"])
        viewer.key("i", look=lambda s: not s["text"])
        viewer.resize(640, 320)
        self.check_same(viewer)

    def test_perspective_keeps_its_proportions(self):
        viewer = self.start("--projection", "perspective")
        state = viewer.resize(400, 400)
        self.assertAlmostEqual(state["hfov"], state["vfov"])
        apart = self.find(viewer, "green") - self.find(viewer, "blue")
        expected = 400 * numpy.tan(numpy.radians(20)) / numpy.tan(numpy.radians(45))
        self.assertAlmostEqual(apart[0], expected, delta=NEAR)

    def test_hidden_and_shown_again(self):
        viewer = self.start()
        first = viewer.photograph()
        viewer.window.unmap()
        self.desktop.display.sync()
        time.sleep(0.2)
        viewer.window.map()
        self.desktop.display.sync()
        viewer.wait()
        viewer.key("Right", look=lambda s: s["yaw"] > 0)
        viewer.key("Left", look=lambda s: s["yaw"] == 0)
        self.assertEqual((viewer.photograph() != first).any(2).sum(), 0)

    def test_full_screen_and_back(self):
        viewer = self.start()
        for key in ("F11", "m"):
            viewer.key(key, look=lambda s: s["size"] == [1280, 1024] and s["full_screen"])
            self.assertIsNotNone(targets.find(viewer.photograph(), "red"))
            viewer.key("Escape", look=lambda s: s["size"] == [640, 320])
        self.desktop.key("Escape")
        self.assert_ends(viewer, 0)

    def test_closed(self):
        viewer = self.start()
        viewer.ask_to_close()
        self.assert_ends(viewer, 0)

    def test_closed_in_the_middle_of_a_frame(self):
        viewer = self.start(scene=("--scene", "cornell"))
        self.desktop.hold("w")
        time.sleep(0.2)
        viewer.ask_to_close()
        self.assert_ends(viewer, 0)

    def test_destroyed_from_outside(self):
        for held in (False, True):
            viewer = self.start()
            if held:
                self.desktop.hold("w")
                time.sleep(0.1)
            viewer.window.destroy()
            self.desktop.display.sync()
            self.assert_ends(viewer, 1, "destroyed")

    def test_display_lost(self):
        for held in (False, True):
            self.setUp()
            viewer = self.start()
            if held:
                self.desktop.hold("w")
                time.sleep(0.1)
            self.desktop.close()
            self.assert_ends(viewer, 1, "display is gone")


class Wall(ViewerTest):
    """Several windows that show one picture."""

    def start_wall(self, columns, rows, projection):
        viewer = self.start("--wall", "%dx%d" % (columns, rows), "--size", "300x200",
            "--projection", projection, "--direction", "1,0.2,-3", scene=("--scene", "room"))
        self.desktop.point(columns * 300 + 50, rows * 200 + 50)
        viewer.wait()
        return viewer

    def test_windows_together_show_the_picture(self):
        for columns, rows, projection in (
            (2, 2, "equirectangular"), (3, 1, "azimuthal-equidistant"), (1, 2, "hammer")):
            viewer = self.start_wall(columns, rows, projection)
            self.assertEqual(viewer.state()["size"], [300 * columns, 200 * rows])
            whole = self.desktop.photograph(300 * columns, 200 * rows)
            viewer.point(5, 5)
            # each window rounds the colours between its own vertices: by one level
            other = numpy.abs(whole.astype(int) - self.render(viewer)).max()
            self.assertLessEqual(other, 1, projection)
            viewer.key("p")
            while viewer.state()["projection"] != projection:
                self.assertNotEqual(viewer.state()["projection"], "perspective")
                viewer.key("p")
            viewer.ask_to_close()
            self.assert_ends(viewer, 0)

    def test_drag_from_window_to_window(self):
        viewer = self.start_wall(2, 1, "hammer")
        self.desktop.point(330, 110)
        self.desktop.press("left")
        self.desktop.point(250, 60)
        state = viewer.after(lambda: self.desktop.release("left"),
            lambda s: s["cursor"] == [250.5, 60.5])
        press = [line for line in viewer.states() if line["event"] == "press"][-1]
        self.assertEqual(press["cursor"], [330.5, 110.5])
        numpy.testing.assert_allclose(
            state["under_cursor"], press["under_cursor"], atol=UPRIGHT)


class Documented(unittest.TestCase):
    def test_the_page_has_the_keys_of_the_help(self):
        text = subprocess.run([PROGRAMS["viewer"], "--help"], stdout=subprocess.PIPE, check=True)
        text = text.stdout.decode().split("Keys and mouse:\n")[1]
        lines = [re.split(r"  +", line.strip(), maxsplit=1) for line in text.strip().split("\n")]
        name = os.path.join(os.path.dirname(__file__), "..", "..", "Documentation", "viewer.md")
        with open(name, encoding="utf-8") as stream:
            page = stream.read()
        rows = re.findall(r"^\| ([^|`]+) \| ([^|]+) \|$", page.split("## Options")[0], re.M)
        self.assertGreater(len(lines), 10)
        self.assertEqual([tuple(line) for line in lines], rows[2:])  # after the table's head


if __name__ == "__main__":
    PROGRAMS["viewer"], PROGRAMS["render"] = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=[sys.argv[0], "--verbose"] + sys.argv[3:])
