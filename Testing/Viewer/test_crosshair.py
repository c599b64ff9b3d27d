#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The crosshair: where photographs show it for either eye, against closed forms.

    test_crosshair.py WIDEFOV_VIEWER WIDEFOV_RENDER GROUP...
"""

import os
import sys
import unittest

import numpy

import targets
from test_room import CAVE, SIDE
from test_viewer import NEAR, PROGRAMS, ViewerTest

# Scene units, of marks at ten of them: the module's depths are right to 1e-5 of the distance and
# its edges to 0.02 pixels, which are a hundredth of a radian; an eye aside by half a unit sees a
# mark askew by a twentieth.
PLACE = 2e-4
# The same in a perspective: steps of stock VTK's depth are as the square of the distance over that
# of the near plane, nearly a hundredth of a unit there, and a float holds two of them.
PERSPECTIVE_PLACE = 0.02
# Of a unit vector: the pointer's pixel is nearly a hundredth of a radian wide.
PIXEL = 0.01
# Pixels that an arm is long at least and at most, along the axes of the picture in its middle.
ARM = (14, 19)

# Pixels of four arms of 16 that are two wide, less their middle and ends; one wide they have 64.
WIDE = 100

# Both eyes in one picture; the border shows as well as the lines, and neither has steps.
RED_BLUE = ("--layout", "red-blue", "--background", "0.2,0.2,0.2")
SMOOTH = ("--samples", "4")


class Crosshair(ViewerTest):
    def aim(self, viewer, at):
        """Turns the crosshair on at that pixel; the photographs before and after, the state."""
        viewer.point(*at)
        viewer.wait(lambda s: s["crosshair"] is None)
        before = viewer.photograph()
        state = viewer.key("x", look=lambda s: s["crosshair"])
        after = viewer.photograph()
        viewer.key("x", look=lambda s: s["crosshair"] is None)
        self.assertEqual((viewer.photograph() != before).sum(), 0, "it goes again")
        return before, after, state

    def place(self, before, after, channel):
        """Where the crosshair is in a colour: the middle of what it changed, and its arms."""
        change = numpy.abs(after[:, :, channel].astype(float) - before[:, :, channel])
        places = numpy.argwhere(change > 0)
        self.assertGreater(len(places), 20)
        rows, columns = numpy.mgrid[0 : change.shape[0], 0 : change.shape[1]] + 0.5
        middle = numpy.array([(columns * change).sum(), (rows * change).sum()]) / change.sum()
        return middle, (places.max(0) - places.min(0) + 1)[::-1] / 2

    def check_plane(self, state, name):
        """It is on the mark, which faces the origin at a known distance."""
        ahead = targets.direction(*targets.TARGETS[name][1:])
        flat = state["projection"] == "perspective"
        self.assertAlmostEqual(ahead @ state["crosshair"], targets.DISTANCE,
            delta=PERSPECTIVE_PLACE if flat else PLACE)

    def test_is_under_the_pointer_in_every_projection(self):
        listed = os.popen(PROGRAMS["render"] + " --list-projections").read().split()
        for projection in sorted(set(listed) - {"direction-map"}):
            whole = projection == "equi-angular-cubemap"  # always
            view = ("--hfov", "360" if whole else "120", "--size", "600x400" if whole else "400x400")
            viewer = self.start("--projection", projection, *view)
            at = [int(place) for place in self.find(viewer, "red")]
            before, after, state = self.aim(viewer, at)
            self.check_plane(state, "red")
            middle, arms = self.place(before, after, 0)
            missed = middle - at - (0.5, 0.5)
            self.assertLess(numpy.hypot(*missed), NEAR, "%s: %s" % (projection, missed))
            self.assertGreaterEqual(arms.min(), ARM[0], projection)
            self.assertLessEqual(arms.min(), ARM[1], projection)
            lines = (before != after).any(2).sum()
            self.assertGreater(lines, WIDE, projection)
            viewer.kill()  # before the next one opens its window

    def disparity(self, name, *options):
        """Pixels from the right eye's crosshair to the left eye's, pointed at a mark."""
        left = self.start_eye("left", *options)  # before the other one opens its window
        viewer = self.start(*options, *RED_BLUE, *SMOOTH)
        at = [int(place) for place in left[name]]
        before, after, state = self.aim(viewer, at)
        self.check_plane(state, name)
        places = [self.place(before, after, channel)[0] for channel in (0, 2)]
        missed = places[0] - at - (0.5, 0.5)
        self.assertLess(numpy.hypot(*missed), NEAR, "the left eye's: %s" % missed)
        self.assertLess(abs(places[1][1] - places[0][1]), NEAR, "the eyes' rows")
        viewer.kill()
        return places[0][0] - places[1][0]

    def start_eye(self, eye, *options):
        """Where an eye sees the marks."""
        viewer = self.start(*options, "--layout", eye, *SMOOTH)
        picture = viewer.photograph()
        viewer.kill()
        return {name: targets.find(picture, name) for name in targets.TARGETS}

    def test_both_eyes_see_it_round_about(self):
        ipd = 1
        for name in ("red", "magenta", "cyan"):
            latitude = numpy.radians(targets.TARGETS[name][2])
            across = targets.DISTANCE * numpy.cos(latitude)
            expected = 2 * numpy.arcsin(ipd / 2 / across) / (2 * numpy.pi) * 640
            found = self.disparity(name, "--stereo", "omnidirectional", "--ipd", str(ipd))
            self.assertAlmostEqual(found, expected, delta=NEAR, msg=name)

    def test_both_eyes_see_it_through_a_window(self):
        for convergence, parallax in ((4, 0.6), (10, 0), (20, -1)):
            expected = -0.1 * parallax * 640
            found = self.disparity("red", "--projection", "perspective", "--stereo", "offaxis",
                "--separation", "0.1", "--convergence", str(convergence))
            self.assertAlmostEqual(found, expected, delta=NEAR, msg=str(convergence))

    def test_both_eyes_see_it_in_a_warped_volume(self):
        options = ("--stereo", "warped", "--offset", "0.2", "--clip", "1,20")
        left, right = [self.start_eye(eye, *options)["red"] for eye in ("left", "right")]
        found = self.disparity("red", *options)
        self.assertGreater(abs(left[0] - right[0]), 3)
        self.assertAlmostEqual(found, left[0] - right[0], delta=NEAR)

    def test_beside_everything_it_is_as_far_as_before(self):
        viewer = self.start()
        at = [int(place) for place in self.find(viewer, "red")]
        viewer.point(*at)
        before = viewer.key("x", look=lambda s: s["crosshair"])
        state = viewer.after(lambda: viewer.point(320, 60), lambda s: s["cursor"] == [320.5, 60.5])
        away = numpy.linalg.norm(state["crosshair"])
        self.assertAlmostEqual(away, numpy.linalg.norm(before["crosshair"]), delta=PLACE)
        numpy.testing.assert_allclose(
            numpy.array(state["crosshair"]) / away, state["under_cursor"], atol=PIXEL)

    def test_stock_cubemaps_have_none(self):
        viewer = self.start("--technique", "cubemap")
        viewer.key("x", look=lambda s: "no crosshair" in s["message"])
        self.assertIsNone(viewer.state()["crosshair"])

    def test_walls_and_screens(self):
        with open(os.path.join(self.folder, "cave.pvx"), "w", encoding="utf-8") as stream:
            stream.write(CAVE)
        side = "%dx%d" % (SIDE, SIDE)
        wall = ("--wall", "3x1", "--size", side, "--hfov", "300")
        for options in (wall, ("--screens", "cave.pvx", "--size", side)):
            viewer = self.start(*options)
            for name in ("red", "magenta"):
                self.desktop.point(5, 5)
                row = self.desktop.photograph(3 * SIDE, SIDE)
                at = [int(place) for place in targets.find(row, name)]
                self.desktop.point(*at)
                state = viewer.key("x", look=lambda s: s["crosshair"])
                self.check_plane(state, name)
                middle, _ = self.place(row, self.desktop.photograph(3 * SIDE, SIDE), 0)
                if name == "red":  # elsewhere the axes of the scene are askew in the picture
                    self.assertLess(numpy.hypot(*(middle - at - (0.5, 0.5))), NEAR)
                viewer.key("x", look=lambda s: s["crosshair"] is None)
            viewer.kill()


if __name__ == "__main__":
    PROGRAMS.update(viewer=os.path.abspath(sys.argv[1]), render=os.path.abspath(sys.argv[2]))
    unittest.main(argv=[sys.argv[0], "-v"] + sys.argv[3:])
