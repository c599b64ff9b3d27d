#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""widefov-run: programs that know nothing of wide views, beside a ray caster in double precision and
beside themselves without it; and how it fails.

    test_run.py BIN PROGRAM OTHER [unittest's options]

BIN: the folder of widefov-run; PROGRAM: made of program.cxx; OTHER: of other_vtk.c.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(1, os.path.join(HERE, "..", "Python"))
import program  # noqa: E402
import rays  # noqa: E402

BIN, PROGRAM, OTHER = (os.path.abspath(path) for path in sys.argv[1:4])
RUN = os.path.join(BIN, "widefov-run")
FACTORIES = os.path.join(BIN, "..", "lib", "widefov-run", "vtk")
IN_PYTHON = (sys.executable, "-B", os.path.join(HERE, "program.py"))
WIDE = "classes vtkWideFoVRenderer vtkWideFoVCamera vtkWideFoVPolyDataMapper"

IGNORED = "has no meaning in this view and is ignored"

# Of program.cxx.
CXX_BOXES = (
    ((-1, 0.5, -0.5, 1, -3, -2), (255, 0, 0)),
    ((-1, 1.5, -1.5, 1, 2, 3), (0, 255, 0)),
)


def call(*command, **variables):
    return subprocess.run(command, check=False, capture_output=True, text=True,
        stdin=subprocess.DEVNULL, env={**os.environ, **variables})


def read(file):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, 3)[::-1].copy()


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def draw(self, *command):
        """What a program that ends with the name of its file draws, and what it prints. All that is said
        is what of its camera has no meaning in a wide view."""
        file = os.path.join(self.folder.name, "picture.png")
        done = call(*command, file)
        said = [line for line in done.stderr.splitlines() if line.strip() and IGNORED not in line]
        self.assertEqual((done.returncode, said), (0, []), " ".join(command))
        return read(file), done.stdout.split("\n")


class Pictures(Case):
    def check(self, picture, directions, eye, boxes, background):
        true = rays.cast(eye, directions(program.SIZE), boxes, background)
        wrong = (picture != true).any(axis=-1) & rays.inner(true)
        self.assertGreater(len(numpy.unique(true.reshape(-1, 3), axis=0)), 2)
        self.assertEqual(wrong.sum(), 0, "first at row, column %s" % numpy.argwhere(wrong)[:1])

    def check_boxes(self, directions, eye, scene, *options):
        picture, said = self.draw(RUN, *options, *IN_PYTHON, scene)
        self.check(picture, directions, eye, program.BOXES, program.BACKGROUND)
        self.assertIn(WIDE, said)
        return said

    def test_inside(self):
        self.check_boxes(rays.equirectangular, program.CENTER, "boxes", "--inside")

    def test_where_the_program_looks_from(self):
        eye = (program.CENTER[0], program.CENTER[1], program.CENTER[2] + 7)
        self.check_boxes(rays.hammer, eye, "boxes", "--projection", "hammer")

    def test_dome(self):
        options = ("--projection", "azimuthal-equidistant", "--fov", "180", "--inside")
        self.check_boxes(rays.dome, program.CENTER, "boxes", *options)

    def test_python_subclass(self):
        said = self.check_boxes(rays.equirectangular, program.CENTER, "subclass", "--inside")
        self.assertIn("python OwnRenderer", said)

    def test_cxx(self):
        picture, said = self.draw(RUN, "--inside", PROGRAM)
        self.check(picture, rays.equirectangular, (0, 0, 0), CXX_BOXES, (0, 0, 0))
        self.assertIn(WIDE, said)

    def test_stereo(self):
        picture, _ = self.draw(RUN, "--inside", "--stereo", "omnidirectional", "--ipd", "0.4", PROGRAM)
        red, blue = picture[..., 0] > 0, picture[..., 2] > 0
        self.assertGreater((red != blue).sum(), 100, "both eyes see the same")


class Flat(Case):
    """With the projection perspective pictures stay what they are, to the bit."""

    def same(self, *command):
        stock, said = self.draw(*command)
        self.assertNotIn("vtkWideFoVRenderer", " ".join(said))
        flat, said = self.draw(RUN, "--projection", "perspective", *command)
        self.assertIn("vtkWideFoVRenderer", " ".join(said))
        self.assertGreater(len(numpy.unique(stock)), 1)
        self.assertTrue((stock == flat).all())

    def test_perspective(self):
        self.same(PROGRAM)
        for scene in ("boxes", "glass", "axes"):
            self.same(*IN_PYTHON, scene)

    def test_corner(self):
        """The axes in a corner are shown as ever; the scene is not in that corner."""
        stock, _ = self.draw(*IN_PYTHON, "axes")
        wide, _ = self.draw(RUN, *IN_PYTHON, "axes")
        height, width = int(0.4 * program.SIZE[1]), int(0.4 * program.SIZE[0])
        corner = stock[-height:, :width]
        self.assertGreater(len(numpy.unique(corner.reshape(-1, 3), axis=0)), 20)
        self.assertTrue((corner == wide[-height:, :width]).all())


class Refusals(unittest.TestCase):
    def refused(self, code, words, *command, **variables):
        """With one line, and that code."""
        done = call(*command, **variables)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("widefov-run: "), done.stderr)
        self.assertIn(words, done.stderr)

    def test_programs(self):
        self.refused(1, "'no-such-program' cannot be run: No such file", RUN, "no-such-program")
        self.refused(1, "cannot be run: Permission denied", RUN, os.path.join(HERE, "test_run.py")[:-11])
        self.refused(2, "name the program", RUN)
        self.refused(2, "name the program", RUN, "--inside")

    def test_options(self):
        self.refused(2, "--projection", RUN, "--projection", "bent", PROGRAM)
        self.refused(2, "no option --bent", RUN, "--bent", PROGRAM)
        self.refused(2, "--hfov", RUN, "--hfov", "wide", PROGRAM)
        self.refused(2, "--hfov", RUN, "--hfov", "nan", PROGRAM)
        self.refused(2, "horizontal field of view", RUN, "--projection", "panini", "--hfov", "350", PROGRAM)
        self.refused(2, "not round", RUN, "--fov", "180", PROGRAM)
        self.refused(2, "the program's own", RUN, "--projection", "perspective", "--inside", PROGRAM)

    def test_environment(self):
        for name, value in (
            ("WIDEFOV_PROJECTION", "bent"),
            ("WIDEFOV_STEREO", "both"),
            ("WIDEFOV_HFOV", "1e999"),
            ("WIDEFOV_TILT", "up"),
            ("WIDEFOV_INSIDE", "maybe"),
        ):
            command = (sys.executable, "-c", "import vtk; vtk.vtkRenderer(); print('drawn')")
            self.refused(2, name, *command, VTK_AUTOLOAD_PATH=FACTORIES, **{name: value})
            self.refused(2, name, PROGRAM, "x.png", VTK_AUTOLOAD_PATH=FACTORIES, **{name: value})

    def test_a_program_without_its_libraries(self):
        """It would show what the program is without it, in silence."""
        with tempfile.TemporaryDirectory() as folder:
            alone = shutil.copy(RUN, folder)
            self.refused(1, "which makes the views wide", alone, PROGRAM, "x.png")

    def test_other_vtk(self):
        loader = os.path.join(FACTORIES, "widefov-loader.so")
        self.refused(1, "has a VTK 8.9.7", OTHER, loader)

    def test_exit_codes_are_the_programs(self):
        self.assertEqual(call(RUN, "sh", "-c", "exit 7").returncode, 7)
        done = call(RUN, "sh", "-c", "echo $0 $1", "--projection", "x y")
        self.assertEqual(done.stdout, "--projection x y\n")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]], verbosity=2)
