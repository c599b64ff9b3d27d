#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does widefov-render --dump-shaders write the programs that OpenGL has?

    test_dump.py WIDEFOV-RENDER

Mesa writes the programs that it links, too: each file must be the text of one of those.
"""

import glob
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
ENDINGS = ("vert", "geom", "frag")
PART = re.compile(r"^// WideFoV: ((?:Shaders|Projections|Stereo)/\S+\.glsl)$", re.M)
MODULE = os.path.join(os.path.dirname(__file__), "..", "..", "Module")


def read(path):
    with open(path, encoding="utf-8", errors="replace") as stream:
        return stream.read()


class Dump:
    """A folder with the programs of a small picture: the files' texts by their names."""

    def __init__(self, *options, frames=1):
        with tempfile.TemporaryDirectory(prefix="dump-") as folder:
            out, seen = (os.path.join(folder, name) for name in ("out", "seen"))
            os.mkdir(out)
            os.mkdir(seen)
            command = [PROGRAM, "--scene", "room", "--size", "64x32", "--frames", str(frames)]
            done = subprocess.run(
                [*command, "--dump-shaders", out, *options],
                cwd=folder,
                capture_output=True,
                text=True,
                check=False,
                env={**os.environ, "MESA_SHADER_CAPTURE_PATH": seen, "GALLIVM_PERF": "nopt"},
            )
            if done.returncode:
                raise AssertionError(done.stdout + done.stderr)
            self.files = {name: read(os.path.join(out, name)) for name in os.listdir(out)}
            self.captured = [read(path) for path in glob.glob(seen + "/*.shader_test")]
        self.list = self.files.pop("programs.txt").splitlines()

    def stages(self):
        """Name of a program -> the endings of its files."""
        stages = {}
        for name in self.files:
            program, _, ending = name.rpartition(".")
            stages.setdefault(program, []).append(ending)
        return stages


class DumpTest(unittest.TestCase):
    """What is in the folder."""

    def check(self, dump, program, endings):
        """The program has these stages, each as Mesa has it and of parts that are there."""
        self.assertEqual(sorted(dump.stages().get(program, [])), sorted(endings), dump.stages())
        for ending in endings:
            text = dump.files[program + "." + ending]
            for part in PART.findall(text):
                self.assertTrue(os.path.isfile(os.path.join(MODULE, part)), part)
            if dump.captured:
                # (which ends a text with a line feed)
                self.assertTrue(any(text.strip() in c for c in dump.captured), program + ending)

    def test_exact(self):
        """Three stages, and what each is made of."""
        dump = Dump("--technique", "exact", "--projection", "hammer", "--samples", "0")
        self.assertEqual(list(dump.stages()), ["prop0-triangles-exact"])
        self.check(dump, "prop0-triangles-exact", ["vert", "geom", "frag"])
        self.assertEqual(dump.list, ["prop0 vtkWideFoVPolyDataMapper prop0-triangles-exact"])
        vertex, geometry, fragment = (
            dump.files["prop0-triangles-exact." + ending] for ending in ("vert", "geom", "frag")
        )
        self.assertIn("Shaders/common/eye_vertex.glsl", PART.findall(vertex))
        for part in ("Shaders/triangles/preclip_cover.glsl", "Projections/hammer.glsl"):
            self.assertIn(part, PART.findall(geometry))
        self.assertIn("Shaders/triangles/cover_fragment.glsl", PART.findall(fragment))
        # once in float32, and once more in double
        self.assertEqual(PART.findall(fragment).count("Projections/hammer.glsl"), 2)

    def test_projected(self):
        """Without a geometry stage."""
        dump = Dump("--technique", "vertex")
        self.check(dump, "prop0-triangles-projected", ["vert", "frag"])
        self.assertIn(
            "Projections/equirectangular.glsl",
            PART.findall(dump.files["prop0-triangles-projected.vert"]),
        )

    def test_others(self):
        """Lines, points and bodies have names of their own; more frames write nothing else."""
        lines = ("--representation", "wireframe", "--line-width", "3", "--technique", "exact")
        for options, program in (
            (lines, "prop0-lines-exact"),
            ((*lines, "--lines-as-tubes"), "prop0-tubes-exact"),
            (("--representation", "points", "--point-size", "5"), "prop0-points-"),
        ):
            dump = Dump(*options, frames=2)
            names = [name for name in dump.stages() if name.startswith(program)]
            self.assertEqual(len(names), 1, dump.stages())
            self.check(dump, names[0], ["vert", "geom", "frag"])

    def test_picture(self):
        """It is the same with the files written."""
        with tempfile.TemporaryDirectory(prefix="dump-") as folder:
            pictures = []
            for options in ([], ["--dump-shaders", folder]):
                path = os.path.join(folder, "picture%d.png" % len(pictures))
                command = [PROGRAM, "--scene", "room", "--size", "128x64", *options, "-o", path]
                subprocess.run(command, check=True)
                with open(path, "rb") as stream:
                    pictures.append(stream.read())
            self.assertEqual(*pictures)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
