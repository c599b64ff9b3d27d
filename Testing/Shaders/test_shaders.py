#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Is every shader program GLSL as the Khronos Group's reference compiler reads it?

    test_shaders.py WIDEFOV-RENDER WIDEFOV-COMPARE-TESTS

Mesa forgives what other drivers refuse. It writes the programs that it links into the folder
MESA_SHADER_CAPTURE_PATH; glslangValidator compiles them anew, and links them if it can.
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
COMPARE = ""
WALL = os.path.join(os.path.dirname(__file__), "..", "..", "Examples", "wall-direction-map.py")

# The part of a captured file's headings, and what glslangValidator calls the stage.
STAGES = {
    "vertex": "vert",
    "geometry": "geom",
    "fragment": "frag",
}
# What OpenGL lets an invocation of a geometry stage write at least; drivers of NVIDIA link no more.
MOST_COMPONENTS = 1024
BUILT_IN = {"gl_Position": 4, "gl_PrimitiveID": 1, "gl_Layer": 1, "gl_PointSize": 1}

HEADING = re.compile(r"^\[(" + "|".join(STAGES) + r") shader\]\n", re.MULTILINE)

# Under every technique; the others under two, which have all formulas in all stages.
THOROUGH = ("equirectangular", "hammer", "stereographic")

LINES = ["--representation", "wireframe", "--line-width", "3"]
POINTS = ["--representation", "points", "--point-size", "5"]

# Beside every projection.
OTHERS = [
    ["--lines-as-tubes", *LINES],
    ["--points-as-spheres", *POINTS],
    ["--representation", "surface-with-edges"],
    ["--debug-view"],
    ["--depth", "log"],
    ["--depth", "reversed"],
    ["--samples", "0", "--aov", "room.exr"],
    ["--stereo", "omnidirectional", "--pole-fade", "60,80"],
    ["--stereo", "omnidirectional", *LINES],
    ["--stereo", "omnidirectional", *POINTS],
    ["--stereo", "warped"],
    ["--stereo", "warped", *LINES],
    ["--projection", "azimuthal-equidistant", "--lens", "1,0,-0.01,0,0", "--tilt", "30"],
]


def read_stages(path):
    """The stages of a captured program: (glslangValidator's name, source)."""
    with open(path, encoding="utf-8", errors="replace") as stream:
        parts = HEADING.split(stream.read())
    return [(STAGES[name], source) for name, source in zip(parts[1::2], parts[2::2])]


def preprocessed(stage, source):
    """The source without what its conditions leave out."""
    with tempfile.NamedTemporaryFile("w", suffix="." + stage, encoding="utf-8") as stream:
        stream.write(source)
        stream.flush()
        done = subprocess.run(
            ["glslangValidator", "-E", stream.name], capture_output=True, text=True, check=True
        )
    return done.stdout


def components_of(kind):
    """Of an output of that type; doubles count twice."""
    matrix = re.fullmatch(r"mat(\d)", kind)
    if matrix:
        return int(matrix[1]) ** 2
    vector = re.search(r"vec(\d)$", kind)
    return (int(vector[1]) if vector else 1) * (2 if kind.startswith("d") else 1)


def written_components(source):
    """What one invocation of a geometry stage may write: all outputs of all its vertices."""
    text = preprocessed("geom", source)
    vertices = max(int(n) for n in re.findall(r"max_vertices\s*=\s*(\d+)", text))
    outputs = re.findall(r"\bout\s+(\w+)\s+\w+\s*;", text)
    built_in = sum(n for name, n in BUILT_IN.items() if re.search(name + r"\s*=", text))
    return vertices * (built_in + sum(components_of(kind) for kind in outputs))


def compile_program(stages):
    """What is wrong with it, or nothing."""
    for stage, source in stages:
        written = written_components(source) if stage == "geom" else 0
        if written > MOST_COMPONENTS:
            return "a geometry stage writes %d components" % written
    with tempfile.TemporaryDirectory(prefix="shaders-") as folder:
        files = []
        for stage, source in stages:
            files.append(os.path.join(folder, "program." + stage))
            if "gl_InvocationID" in source:
                # glslangValidator does not know it of the extension GL_ARB_gpu_shader5
                source = source.replace("#version 150", "#version 400", 1)
            with open(files[-1], "w", encoding="utf-8") as stream:
                stream.write(source)
        done = subprocess.run(
            ["glslangValidator", "-l", *files], capture_output=True, text=True, check=False
        )
    lines = [line for line in done.stdout.splitlines() if "ERROR" in line]
    return "\n".join(lines[:5]) or (done.stderr if done.returncode else "")


def programs_of(command):
    """The programs, as lists of stages, that a command draws with."""
    with tempfile.TemporaryDirectory(prefix="shaders-") as folder:
        # nobody looks at the pictures: how fast the programs run counts less than how long Mesa
        # takes to make them fast
        done = subprocess.run(
            command,
            cwd=folder,
            capture_output=True,
            text=True,
            check=False,
            env={**os.environ, "MESA_SHADER_CAPTURE_PATH": folder, "GALLIVM_PERF": "nopt"},
        )
        if done.returncode != 0:
            raise AssertionError(done.stdout + done.stderr)
        files = sorted(name for name in os.listdir(folder) if name.endswith(".shader_test"))
        return [read_stages(os.path.join(folder, name)) for name in files]


def picture(*options, size=("--size", "64x32")):
    """What draws a small picture."""
    return [PROGRAM, "--scene", "room", *size, *options, "-o", "room.png"]


class ShadersTest(unittest.TestCase):
    """The programs of small pictures."""

    @classmethod
    def setUpClass(cls):
        if not programs_of(picture()):
            raise unittest.SkipTest("this OpenGL is not Mesa's and writes no programs")

    def check(self, command):
        """At least one of the programs is of the module, and all of those compile."""
        own = [p for p in programs_of(command) if any("wfv" in source for _, source in p)]
        self.assertTrue(own, command)
        for stages in own:
            with self.subTest(command=command, stages=[stage for stage, _ in stages]):
                self.assertEqual(compile_program(stages), "")

    def test_projections(self):
        """Every projection under the techniques that have formulas of their own."""
        done = subprocess.run(
            [PROGRAM, "--list-projections"], capture_output=True, text=True, check=True
        )
        others = ("perspective", "direction-map")  # the first of these is stock VTK's
        names = [name for name in done.stdout.split() if name not in others]
        self.assertGreaterEqual(len(names), 17)
        for name in names:
            more = ("auto", "preclip", "vertex") if name in THOROUGH else ()
            for technique in ("exact", *more):
                self.check(picture("--projection", name, "--technique", technique))

    def test_others(self):
        """Lines, points, stereo and what else has variants of its own."""
        for options in OTHERS:
            self.check(picture(*options))

    def test_direction_map(self):
        """A map that is a file."""
        with tempfile.TemporaryDirectory(prefix="shaders-") as folder:
            path = os.path.join(folder, "wall.exr")
            subprocess.run([sys.executable, "-B", WALL, path], check=True)
            for options in ([], LINES, POINTS):
                view = ("--projection", "direction-map", "--direction-map", path)
                self.check(picture(*view, *options, size=()))

    def test_quadrics(self):
        """Balls, sticks, tubes and splats, by the test of their mappers."""
        for suite in ("CompareQuadrics", "CompareStereoQuadrics"):
            self.check([COMPARE, "--gtest_filter=All/%s.*/equirectangular" % suite])

    def test_too_much_output(self):
        """A geometry stage that NVIDIA's driver does not link is told."""
        source = (
            "#version 150\nlayout(points) in;\nlayout(points, max_vertices = %d) out;\n"
            "out mat4 a;\nflat out int b;\n"
            "void main() { a = mat4(1.0); b = 1; gl_Position = vec4(0.0); EmitVertex(); }\n"
        )
        vertex = "#version 150\nvoid main() { gl_Position = vec4(0.0); }\n"
        self.assertEqual(compile_program([("vert", vertex), ("geom", source % 48)]), "")
        told = compile_program([("vert", vertex), ("geom", source % 49)])
        self.assertIn("1029 components", told)

    def test_a_wrong_program(self):
        """The compiler is strict: it refuses what Mesa lets pass."""
        source = "#version 150\nvoid main() { int i = 1.0; }\n"
        self.assertIn("ERROR", compile_program([("vert", source)]))


if __name__ == "__main__":
    PROGRAM, COMPARE = (os.path.abspath(sys.argv.pop(1)) for _ in range(2))
    unittest.main()
