#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A window for each screen of a room, and recorded head poses, photographed.

    test_room.py WIDEFOV_VIEWER WIDEFOV_RENDER GROUP...
"""

import os
import shlex
import subprocess
import sys
import time
import unittest

import numpy

import targets
from desktop import wait_for
from test_viewer import IDLE_TIME, NEAR, PROGRAMS, UPRIGHT, Flight, ViewerTest, read_png

# Three walls of a CAVE two units wide, the head's rest in its middle.
CAVE = """<?xml version="1.0" ?>
<pvx><Process Type="server">
<EyeSeparation Value="0.2"/>
<Machine Name="Left" LowerLeft="-1 -1 1" LowerRight="-1 -1 -1" UpperRight="-1 1 -1"/>
<Machine Name="Front" LowerLeft="-1 -1 -1" LowerRight="1 -1 -1" UpperRight="1 1 -1"/>
<Machine Name="Right" LowerLeft="1 -1 -1" LowerRight="1 -1 1" UpperRight="1 1 1"/>
</Process></pvx>
"""
SCREENS = ("Left", "Front", "Right")
OUTSIDE = "the room from outside"
SIDE = 200  # pixels of a screen's window

# Of a unit vector: a pixel of a window 640 wide that shows 120 degrees, twice as wide beside
# the middle of a perspective.
PIXEL = 0.01

# Share of the pixels of a window that a move of the head changes at least.
MOVED = 0.01

# Way of the eye, in a room two units wide, that changes so many.
FLOWN = 0.2

# At rest, moved, moved and turned. The second one lasts three times as long.
SIX = "0 0 0 0 0 0 0 1\n0.2 0.4 0.2 -0.3 0 0 0 1\n0.8 -0.3 0 0.5 0 0.38268 0 0.92388\n"

# Turned to the left by 30 and by 60 degrees.
THREE = "0 0 0.258819 0 0.965926\n0.1 0 0.5 0 0.866025\n"


def distance(place, other):
    return numpy.linalg.norm(numpy.subtract(place, other))


class RoomTest(ViewerTest):
    """The files of screens and poses beside the marks."""

    def setUp(self):
        super().setUp()
        for name, text in (("cave.pvx", CAVE), ("six.txt", SIX), ("three.txt", THREE)):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as stream:
                stream.write(text)

    def start_cave(self, *arguments, text=False, scene=("--scene", "room")):
        viewer = self.start("--screens", "cave.pvx", "--size", "%dx%d" % (SIDE, SIDE),
            *arguments, scene=scene, text=text)
        self.desktop.point(SIDE * 3 + 50, SIDE + 50)
        viewer.wait()
        return viewer

    def shown(self):
        """The screens' pictures by their names: their windows stand in a row."""
        row = self.desktop.photograph(3 * SIDE, SIDE)
        return {name: row[:, i * SIDE : (i + 1) * SIDE] for i, name in enumerate(SCREENS)}

    def rendered(self, viewer, number=None):
        """What widefov-render draws by the command that the viewer prints, of one pose."""
        before = viewer.printed()
        self.desktop.point(SIDE // 2, SIDE // 2)
        viewer.key("c", look=lambda state: "standard output" in state["message"])
        words = shlex.split(viewer.printed()[len(before) :])
        words[words.index("--output") + 1] = os.path.join(self.folder, "drawn.png")
        subprocess.run([PROGRAMS["render"]] + words[1:], cwd=self.folder, check=True,
            env={**os.environ, "DISPLAY": self.desktop.name})
        suffix = "" if number is None else "-%04d" % number
        names = {name: "drawn-%s%s.png" % (name, suffix) for name in SCREENS}
        return {name: read_png(os.path.join(self.folder, names[name])) for name in SCREENS}

    def check_screens(self, viewer, number=None):
        drawn, shown = self.rendered(viewer, number), self.shown()
        for name in SCREENS:
            self.assertEqual((drawn[name] != shown[name]).any(2).sum(), 0, name)
        return shown

    def window(self, viewer, screen):
        return next(w for title, w in viewer.windows().items() if title.endswith(": " + screen))


class Screens(RoomTest):
    def drawn_room(self, viewer):
        room = viewer.preview(OUTSIDE)
        return room if (room[0] != room[0][0, 0]).any() else None

    def check_room(self, viewer):
        """From outside, from behind the audience on the right: all of it is there, and turns."""
        viewer.key("b")
        before, (left, top) = wait_for("the room", lambda: self.drawn_room(viewer))
        seen = (before != before[0, 0]).any(2)
        self.assertGreater(seen.mean(), 0.1)
        self.assertFalse(seen[0].any() or seen[-1].any() or seen[:, 0].any() or seen[:, -1].any())
        self.desktop.point(left + 300, top + 256)
        self.desktop.press("left")
        self.desktop.point(left + 400, top + 256)
        self.desktop.release("left")
        wait_for("the room that is turned",
            lambda: (before != viewer.preview(OUTSIDE)[0]).any(2).mean() > 0.1 or None)
        self.desktop.point(SIDE // 2, SIDE // 2)
        viewer.key("b")
        wait_for("the preview to go", lambda: len(viewer.windows()) == 3 or None)

    def test_windows_show_what_widefov_render_draws(self):
        viewer = self.start_cave()
        self.assertEqual(len(viewer.windows()), 3)
        self.assertEqual(viewer.state()["size"], [3 * SIDE, SIDE])
        mono = self.check_screens(viewer)
        self.check_room(viewer)
        viewer.key("o", look=lambda s: s["stereo"] == "offaxis")
        both = self.check_screens(viewer)
        self.assertGreater((mono["Right"] != both["Right"]).any(2).mean(), MOVED)
        viewer.key("p", look=lambda s: "corners" in s["message"])
        viewer.key("o", look=lambda s: s["stereo"] == "mono")
        viewer.key("F2", look=lambda s: "written" in s["message"])
        name = os.path.join(self.folder, viewer.state()["message"].split(": ")[1])
        self.assertEqual((read_png(name) != numpy.hstack(list(mono.values()))).sum(), 0)

    def test_a_drag_in_any_window_moves_all(self):
        for i, screen in enumerate(SCREENS):
            viewer = self.start_cave()
            before = self.shown()
            self.desktop.point(i * SIDE + 120, 110)
            self.desktop.press("left")
            self.desktop.point(i * SIDE + 70, 90)
            state = viewer.after(lambda: self.desktop.release("left"),
                lambda s: s["cursor"] == [70.5, 90.5])
            press = [line for line in viewer.states() if line["event"] == "press"][-1]
            self.assertEqual((press["screen"], press["cursor"]), (screen, [120.5, 110.5]))
            across, up = 2 * 120.5 / SIDE - 1, 1 - 2 * 110.5 / SIDE
            seen = {"Left": (-1, up, -across), "Front": (across, up, -1), "Right": (1, up, across)}
            numpy.testing.assert_allclose(press["under_cursor"],
                numpy.array(seen[screen]) / numpy.linalg.norm(seen[screen]), atol=UPRIGHT)
            if screen == "Front":  # at the sides a raised head raises nothing
                numpy.testing.assert_allclose(
                    state["under_cursor"], press["under_cursor"], atol=UPRIGHT)
            after = self.check_screens(viewer)
            for name in SCREENS:
                self.assertGreater((before[name] != after[name]).any(2).mean(), MOVED, name)
            viewer.kill()

    def test_a_key_in_any_window_flies_all(self):
        viewer = self.start_cave()
        for i in range(3):
            before = self.shown()
            eye = viewer.state()["eye"]
            self.desktop.point(i * SIDE + 100, 100)
            self.desktop.hold("w")
            wait_for("a flight", lambda v=viewer, e=eye: distance(v.state()["eye"], e) > FLOWN)
            viewer.after(lambda: self.desktop.let_go("w"), lambda s: s["event"] == "release")
            self.assertNotEqual(viewer.state()["eye"], eye)
            after = self.check_screens(viewer)
            # a wall of one colour that fills a window stays one
            moved = [(before[name] != after[name]).any(2).mean() for name in SCREENS]
            self.assertGreater(max(moved), MOVED)

    def test_the_wheel_makes_the_scene_larger_in_the_room(self):
        viewer = self.start_cave("--eye", "0,3,30", scene=("--scene", "cornell"))
        lit = (self.shown()["Front"] > 0).any(2).sum()
        for notches in (1, 2):
            self.desktop.point(SIDE + 100, 100)
            state = viewer.after(lambda: self.desktop.click("wheel up"),
                lambda s, n=notches: abs(s["room_scale"] - 1.1**-n) < 1e-9)
            # the middle of the box, the origin, is in the room where it was
            place = numpy.array(state["eye"]) / state["room_scale"]
            numpy.testing.assert_allclose(place, (0, 3, 30), atol=1e-9)
            larger = (self.shown()["Front"] > 0).any(2).sum()
            self.assertGreater(larger, 1.1 * lit)
            lit = larger
        viewer.key("Home", look=lambda s: s["room_scale"] == 1 and s["eye"] == [0, 3, 30])

    def test_a_larger_scene_is_what_widefov_render_draws(self):
        viewer = self.start_cave("--pose", "six.txt", "--pose-once", "--stereo", "offaxis")
        viewer.wait(lambda s: s["pose"] == 3)
        self.desktop.point(SIDE + 100, 100)
        viewer.after(lambda: self.desktop.click("wheel down"), lambda s: s["room_scale"] > 1)
        self.check_screens(viewer, 3)

    def test_there_are_fewer_monitors_than_screens(self):
        viewer = self.start_cave(text=True)
        self.desktop.point(50, 150)
        viewer.key("F11", look=lambda s: "fewer monitors" in s["message"])
        self.assertFalse(viewer.state()["full_screen"])
        viewer.kill()
        done = subprocess.run(
            [PROGRAMS["viewer"], "--scene", "room", "--screens", "cave.pvx", "--full-screen"],
            cwd=self.folder, env={**os.environ, "DISPLAY": self.desktop.name},
            capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertIn("there is no monitor 2, only 1", done.stderr)

    def test_any_size_of_any_window(self):
        viewer = self.start_cave(text=True)
        for screen, width, height in (("Front", 1, 1), ("Left", 2, 150), ("Right", 300, 20)):
            window = self.window(viewer, screen)

            def act(window=window, width=width, height=height):
                window.configure(width=width, height=height)
                self.desktop.display.sync()

            viewer.after(act)
        self.assertEqual(viewer.wait(lambda s: s["size"] == [303, 150])["size"], [303, 150])

    def test_the_others_go_on_without_a_hidden_one(self):
        viewer = self.start_cave()
        hidden = self.window(viewer, "Left")
        hidden.unmap()
        self.desktop.display.sync()
        self.desktop.point(SIDE + 100, 100)
        before = self.shown()["Front"]
        viewer.key("Right", look=lambda s: s["yaw"] > 0)
        self.assertGreater((self.shown()["Front"] != before).any(2).mean(), MOVED)
        hidden.map()
        self.desktop.display.sync()
        viewer.wait()
        viewer.key("Left", look=lambda s: s["yaw"] == 0)
        self.check_screens(viewer)

    def test_one_window_closed_ends_all(self):
        for held in (False, True):
            for screen in SCREENS:
                viewer = self.start_cave("--pose", "six.txt", "--pose-rate", "100")
                if held:
                    self.desktop.point(SIDE + 100, 100)
                    self.desktop.hold("w")
                    time.sleep(0.1)
                viewer.window = self.window(viewer, screen)
                viewer.ask_to_close()
                self.assert_ends(viewer, 0)
                self.desktop.let_go("w")

    def test_one_window_destroyed_ends_all(self):
        for screen in SCREENS:
            viewer = self.start_cave("--pose", "six.txt", "--pose-rate", "100")
            self.window(viewer, screen).destroy()
            self.desktop.display.sync()
            self.assert_ends(viewer, 1, "destroyed")


class Poses(RoomTest):
    def test_the_last_pose_stays(self):
        viewer = self.start_cave("--pose", "six.txt", "--pose-once")
        viewer.wait(lambda s: s["pose"] == 3)
        self.check_screens(viewer, 3)
        lines = len(viewer.states())
        before = Flight.seconds(viewer)
        time.sleep(1.5)
        self.assertLess(Flight.seconds(viewer) - before, IDLE_TIME)
        self.assertEqual(len(viewer.states()), lines)

    def test_poses_come_in_turn_and_stop(self):
        viewer = self.start("--screens", "cave.pvx", "--pose", "six.txt", "--pose-rate", "8",
            "--size", "40x40", scene=("--scene", "cornell"))

        def numbers():
            seen = [line["pose"] for line in viewer.states() if line["event"] == "frame"]
            changes = [b for a, b in zip([0] + seen, seen) if a != b]
            return changes if len(changes) > 8 else None

        end = time.monotonic() + 60
        while not numbers() and time.monotonic() < end:
            time.sleep(0.05)
        steps = {(b - a) % 3 for a, b in zip(numbers(), numbers()[1:])}
        self.assertIn(1, steps)
        self.assertTrue(steps <= {1, 2}, steps)  # one that is late is left out
        self.desktop.point(20, 20)
        state = viewer.key("space", look=lambda s: s["paused"])
        lines = len(viewer.states())
        time.sleep(0.5)
        self.assertEqual(len(viewer.states()), lines)
        viewer.key("space", look=lambda s, p=state["pose"]: s["pose"] != p)

    def test_every_pose_is_what_widefov_render_draws(self):
        viewer = self.start_cave("--pose", "six.txt")
        self.desktop.point(100, 100)
        seen = set()
        while len(seen) < 3:
            pose = viewer.wait(lambda s: s["pose"] not in seen)["pose"]
            stopped = viewer.key("space", look=lambda s: s["paused"])["pose"]
            self.check_screens(viewer, stopped)
            seen.update({stopped} & {pose, stopped})
            viewer.key("space", look=lambda s: not s["paused"])

    def test_a_turned_head_keeps_the_direction_grabbed(self):
        for projection in ("hammer", "perspective"):
            viewer = self.start("--pose", "three.txt", "--pose-once", "--projection", projection,
                "--hfov", "120")
            viewer.wait(lambda s: s["pose"] == 2)
            # 60 degrees to the left of ahead is in the middle: blue is at 20, red at 0
            start = [int(place) for place in self.find(viewer, "blue")]
            offset = self.find(viewer, "blue") - start
            end = (start[0] - 90, start[1])
            state = viewer.drag(start, end)
            press = [line for line in viewer.states() if line["event"] == "press"][-1]
            numpy.testing.assert_allclose(press["under_cursor"],
                targets.direction(*targets.TARGETS["blue"][1:]), atol=PIXEL)
            numpy.testing.assert_allclose(
                state["under_cursor"], press["under_cursor"], atol=UPRIGHT)
            missed = self.find(viewer, "blue") - end - offset
            self.assertLess(numpy.hypot(*missed), NEAR, projection)
            viewer.kill()


if __name__ == "__main__":
    PROGRAMS.update(viewer=os.path.abspath(sys.argv[1]), render=os.path.abspath(sys.argv[2]))
    unittest.main(argv=[sys.argv[0], "-v"] + sys.argv[3:])
