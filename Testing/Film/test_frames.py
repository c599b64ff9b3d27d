#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the frames of a film show: the camera's way, and the time steps of the data.

    test_frames.py WIDEFOV-RENDER
"""

import os

import numpy
from matplotlib.image import imread

from films import EMPTY, SIZE, SQUARE, FilmTest, main

FRAMES = ["-o", "frames/%05d.png"]


class Ways(FilmTest):
    def test_turn_is_a_shift_at_one_speed(self):
        self.film("--film", "turn", "--seconds", "0.16", *FRAMES)
        frames = self.frames()
        self.assertEqual(sorted(os.listdir(self.path("frames")))[0], "00001.png")
        self.assertEqual(len(frames), 4)
        for before, after in zip(frames, frames[1:] + frames[:1]):
            self.assertGreater(numpy.abs(before - after).mean(), 0.05)
            self.assert_same(after, numpy.roll(before, -SIZE[0] // 4, axis=1))

    def test_path_turns_at_constant_angular_speed(self):
        # two legs, one twice as wide as the other
        self.write("way.txt", "# ahead, 30 and 90 degrees to the right\n0 0 0  0 0 -1\n"
                   "0 0 0  0.5 0 -0.8660254  0 1 0\n0 0 0  1 0 0\n")
        self.film("--film", "path", "--path", "way.txt", "--seconds", "0.2", "--ease", "none", *FRAMES)
        frames = self.frames()
        self.assertEqual(len(frames), 5)
        for i, frame in enumerate(frames):
            self.assert_same(frame, numpy.roll(frames[0], -SIZE[0] * i // 16, axis=1), 0.05)
        self.assert_same(frames[4], numpy.roll(frames[0], -SIZE[0] // 4, axis=1))

    def test_ease(self):
        """Half the way is over in the middle, but little of it after a tenth."""
        self.write("way.txt", "0 0 0  0 0 -1\n0 0 0  1 0 0\n")
        self.film("--film", "path", "--path", "way.txt", "--seconds", "0.44", *FRAMES)
        frames = self.frames()
        self.assert_same(frames[5], numpy.roll(frames[0], -SIZE[0] // 8, axis=1))
        self.assert_same(frames[1], frames[0], 0.03)
        self.assert_same(frames[10], numpy.roll(frames[0], -SIZE[0] // 4, axis=1))

    def test_orbit_keeps_the_middle(self):
        self.write("square.vtp", SQUARE.format(heat=1))
        self.film("square.vtp", "--film", "orbit", "--seconds", "0.16", "--eye", "0,0,3", "--projection",
                  "perspective", "--hfov", "60", "--background", "0,0,1", *FRAMES)
        wide = []
        for frame in self.frames():
            seen = frame[:, :, 0] > 0.1
            wide.append(seen.any(axis=0).sum())
            self.assertTrue(wide[-1] < 4 or abs(numpy.nonzero(seen)[1].mean() - 31.5) < 1)
        # from the front and from behind it is a square, from the sides a line
        self.assertGreater(min(wide[0], wide[2]), 10)
        self.assertLess(max(wide[1], wide[3]), 4)

    def test_fly_follows_the_flow(self):
        side = 9
        ahead = " ".join(["0 0 -1"] * side**3)
        self.write("wind.vti", '<?xml version="1.0"?>\n<VTKFile type="ImageData" version="0.1">'
                   '<ImageData WholeExtent="0 8 0 8 0 8" Origin="-4 -4 -4" Spacing="1 1 1">'
                   '<Piece Extent="0 8 0 8 0 8"><PointData><DataArray type="Float32" Name="wind" '
                   'NumberOfComponents="3" format="ascii">%s</DataArray></PointData></Piece>'
                   "</ImageData></VTKFile>" % ahead)
        fly = ["wind.vti", "--film", "fly", "--vectors", "wind", "--seconds", "0.12", "--background", "0,0,1"]
        self.film(*fly, "--eye", "0.5,0.5,3", *FRAMES)
        frames = self.frames()
        self.assertEqual(len(frames), 3)
        self.assertGreater(numpy.abs(frames[0] - frames[2]).mean(), 0.01)
        self.assertEqual(self.film(*fly, *FRAMES), "")  # the line says where the eye is

    def test_a_path_says_where_the_eye_is(self):
        self.write("square.vtp", SQUARE.format(heat=1))
        self.write("way.txt", "0 0 0  0 0 -1\n0 0 1  0 0 -1\n")
        path = ["square.vtp", "--film", "path", "--path", "way.txt", "--seconds", "0.12", *FRAMES]
        self.assertEqual(self.film(*path), "")
        self.write("one.txt", "0 0 0  0 0 -1\n")
        self.assertEqual(self.film("square.vtp", "--film", "path", "--path", "one.txt", "--seconds", "0.08", "-o", "one/%d.png"),
                         "widefov-render: warning: one.txt has one pose: the camera stands still")
        frames = self.frames()
        self.film(*path, "--eye", "5,5,5")  # which says nothing
        self.assertEqual([a.tobytes() for a in frames], [b.tobytes() for b in self.frames()])

    def test_borders(self):
        """Each frame is the part that a picture shows, with the bar at the same place of it."""
        self.write("square.vtp", SQUARE.format(heat=1))
        self.write("way.txt", "0 0 0  0 0 -1\n")
        part = ["square.vtp", "--eye", "0,0,0", "--direction", "0,0,-1", "--borders", "-60,90,-45,45", "--size", "250x150"]
        for eyes in ([], ["--stereo", "omnidirectional", "--ipd", "0.1", "--layout", "top-bottom"]):
            self.film(*part, *eyes, "--film", "path", "--path", "way.txt", "--seconds", "0.08", *FRAMES)
            self.film(*part, *eyes, "-o", "picture.png")
            picture = imread(self.path("picture.png"))[:, :, :3]
            self.assertGreater(picture[:140].std(), 0.1)
            for frame in self.frames():
                self.assertEqual(numpy.abs(frame - picture).max(), 0)
            os.remove(self.path("picture.png"))

    def test_separate_eyes_have_folders(self):
        self.film("--film", "turn", "--seconds", "0.08", "--stereo", "omnidirectional", "--ipd", "0.3",
                  "--layout", "separate", *FRAMES)
        left, right = self.frames("frames/left"), self.frames("frames/right")
        self.assertEqual((len(left), len(right)), (2, 2))
        self.assertGreater(numpy.abs(left[0] - right[0]).mean(), 0.005)


class Steps(FilmTest):
    """Data that change with time: the colour tells the step."""

    TIME = ["--film", "time", "--projection", "perspective", "--hfov", "60", "--eye", "0,0,0", *FRAMES]

    def setUp(self):
        super().setUp()
        for i in range(3):
            self.write("square%d.vtp" % i, SQUARE.format(heat=i))

    def colours(self):
        return [tuple(frame[SIZE[1] // 2, SIZE[0] // 2]) for frame in self.frames()]

    def assert_three_steps(self):
        """From cold to warm in one range of colours."""
        cold, _, warm = colours = self.colours()
        self.assertEqual(len(set(colours)), 3, colours)
        self.assertGreater(cold[2], cold[0])
        self.assertGreater(warm[0], warm[2])
        return colours

    def test_lists(self):
        entry = '<DataSet timestep="%d" part="0" file="square%d.vtp"/>'
        self.write("all.pvd", '<?xml version="1.0"?>\n<VTKFile type="Collection"><Collection>%s'
                   "</Collection></VTKFile>" % "".join(entry % (10 * i, i) for i in (2, 0, 1)))
        self.write("all.vtp.series", '{"file-series-version": "1.0", "files": [%s]}' % ", ".join(
            '{"name": "square%d.vtp", "time": %d}' % (i, i) for i in range(3)))
        colours = None
        for data in (["all.pvd"], ["all.vtp.series"], ["square%d.vtp"],
                     ["square0.vtp", "square1.vtp", "square2.vtp"]):
            self.film(*data, *self.TIME)
            self.assertEqual(colours or self.assert_three_steps(), self.colours(), data)
            colours = self.colours()

    def test_the_eye_sees_all_steps(self):
        for i, x in enumerate((0, 4, 9)):
            corners = "%d -1 -1  %d -1 -1  %d 1 -1  %d 1 -1" % (x - 1, x + 1, x + 1, x - 1)
            self.write("square%d.vtp" % i, SQUARE.format(heat=i).replace(
                "-1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1", corners))
        for more in ([], ["--range", "0,2"]):  # which is known without all steps
            self.film("square%d.vtp", "--film", "time", "--projection", "perspective", *more, *FRAMES)
            lit = [frame.max(axis=2) > 0.05 for frame in self.frames()]
            self.assertGreater(min(mask.sum() for mask in lit), 20)
            columns = numpy.nonzero(numpy.any(lit, axis=(0, 1)))[0]
            self.assertTrue(columns[0] > 0 and columns[-1] < SIZE[0] - 1, columns)

    def test_times_that_are_not_equal(self):
        """The times 0, 1 and 8 of twelve: one frame, seven, and the mean, four."""
        self.write("all.vtp.series", '{"files": [%s]}' % ", ".join(
            '{"name": "square%d.vtp", "time": %d}' % pair for pair in ((0, 0), (1, 1), (2, 8))))
        self.film("all.vtp.series", "--range", "0,2", "--seconds", "0.48", *self.TIME)
        colours = self.colours()
        self.assertEqual([colours.count(c) for c in dict.fromkeys(colours)], [1, 7, 4])

    def test_moving_data_under_a_moving_camera(self):
        self.film("square%d.vtp", "--range", "0,2", "--seconds", "0.24", "--film", "turn", "--sweep", "30",
                  "--ease", "none", *self.TIME[2:])
        # the light moves with the camera, red against blue tells the step
        self.assertEqual([round(float(c[0] - c[2])) for c in self.colours()], [-1, -1, 0, 0, 1, 1])
        self.assertEqual(len({frame.tobytes() for frame in self.frames()}), 6)

    def test_broken_step_repeats_the_one_before(self):
        self.write("square1.vtp", "<VTKFile nonsense")
        said = self.film("square%d.vtp", *self.TIME).splitlines()
        self.assertEqual(len(said), 1, said)
        self.assertIn("time step 1", said[0])
        cold, again, warm = self.colours()
        self.assertEqual(cold, again)
        self.assertNotEqual(cold, warm)
        strict = self.run_film("square%d.vtp", *self.TIME, "--strict")
        self.assertEqual(strict.returncode, 1)
        self.assertIn("square1.vtp", strict.stderr)

    def test_empty_steps_are_empty_and_others_grey(self):
        """The second step has no points, the third another array; each may come first."""
        self.write("empty.vtp", EMPTY)
        self.write("other.vtp", SQUARE.format(heat=5).replace('"heat"', '"cold"'))
        for order, more in (("square0 empty other square2", []), ("square0 empty other square2", ["--range", "0,2"]),
                            ("empty other square0 square2", ["--color-by", "heat"])):
            data = [name + ".vtp" for name in order.split()]
            said = self.film(*data, *self.TIME, "--no-scalar-bar", *more).splitlines()
            self.assertEqual(len(said), 1, said)
            self.assertRegex(said[0], "time step [12] has no array 'heat' and is drawn without it")
            color = dict(zip(order.split(), self.colours()))
            self.assertEqual(max(color["empty"]), 0)
            self.assertGreater(min(color["other"]), 0.3)
            self.assertLess(numpy.ptp(color["other"]), 0.01)
            self.assertGreater(color["square0"][2], color["square0"][0])
            self.assertGreater(color["square2"][0], color["square2"][2])
        still = self.run_film("empty.vtp", "square0.vtp", "--film", "time", "--seconds", "0.08", *FRAMES)
        self.assertIn("the eye is outside", still.stderr)
        self.write("all.vtp.series", '{"files": [{"name": "square0.vtp"}, {"name": "empty.vtp"}]}')
        self.assertIn("time step 1 has no points or cells: the picture is empty",
                      self.film("all.vtp.series", "--time", "1", "-o", "one.png"))
        none = self.run_film("empty.vtp", "empty.vtp", *self.TIME)
        self.assertEqual((none.returncode, none.stderr.count("\n")), (1, 1), none.stderr)
        self.assertIn("no time step has points or cells", none.stderr)

    def test_exodus(self):
        import vtkmodules.all as vtk
        source = vtk.vtkTimeSourceExample()
        writer = vtk.vtkExodusIIWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(self.path("steps.ex2"))
        writer.WriteAllTimeStepsOn()
        writer.Write()
        self.film("steps.ex2", *self.TIME[:2], "--eye", "0,0,0.4", "--color-by", "Point Value", *FRAMES)
        frames = self.frames()
        self.assertEqual(len(frames), 10)
        self.assertGreater(len({frame.tobytes() for frame in frames}), 5)


if __name__ == "__main__":
    main()
