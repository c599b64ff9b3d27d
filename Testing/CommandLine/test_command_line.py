#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Asks widefov-render what it would draw, and reads what it prints.

    test_command_line.py WIDEFOV_RENDER ROOT [GROUP...]
"""

import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest

RENDER = os.path.abspath(sys.argv[1])
ROOT = sys.argv[2]
SECONDS = 120  # until a run counts as hanging

MESH = """# vtk DataFile Version 3.0
one triangle
ASCII
DATASET POLYDATA
POINTS 3 float
-1 -1 -2 1 -1 -2 0 1 -2
POLYGONS 1 4
3 0 1 2
POINT_DATA 3
SCALARS heat float
LOOKUP_TABLE default
1 2 4
VECTORS wind double
3 4 0 0 0 0 1 0 0
CELL_DATA 1
SCALARS zone int
LOOKUP_TABLE default
7
"""


def run(*words, **more):
    more.setdefault("stdin", subprocess.DEVNULL)
    return subprocess.run(
        [RENDER, *words], capture_output=True, timeout=SECONDS, check=False, **more
    )


def plan(*words):
    """What --dry-run says as JSON."""
    done = run("--dry-run", "--json", *words)
    if done.returncode != 0:
        raise AssertionError(done.stderr.decode())
    return json.loads(done.stdout)


def refusal(*words):
    done = run("--dry-run", *words)
    assert done.returncode == 2, "%s ends with %d" % (words, done.returncode)
    return done.stderr.decode()


class Base(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)
        self.mesh = self.file("mesh.vtk", MESH)

    def file(self, name, text):
        path = os.path.join(self.place.name, name)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        return path


class Names(Base):
    def test_case_and_hyphens_do_not_matter(self):
        found = plan("--scene", "ROOM", "--projection", "Azimuthal_Equal_Area", "--technique", "Exact")
        self.assertEqual(found["scene"], "room")
        self.assertEqual(found["projection"], "azimuthal-equal-area")
        self.assertEqual(found["technique"], "exact")

    def test_lenses_have_other_names(self):
        for name, own in {
            "equisolid": "azimuthal-equal-area",
            "equidistant": "azimuthal-equidistant",
            "rectilinear": "perspective",
            "Pannini": "panini",
        }.items():
            self.assertEqual(plan("--scene", "room", "--projection", name)["projection"], own)

    def test_tessellate_is_auto_and_says_so_once(self):
        words = ("--scene", "room", "--technique", "tessellate")
        self.assertEqual(plan(*words)["technique"], "auto")
        done = run(*words, "--dry-run")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stderr.decode().count("\n"), 1)
        self.assertIn(b"--technique tessellate is called auto;", done.stderr)

    def test_aliases_are_no_names_and_mean_one_thing(self):
        listed = json.loads(run("--list-projections", "--json").stdout)
        names = [p["name"] for p in listed] + [alias for p in listed for alias in p["aliases"]]
        self.assertGreater(len(names), len(listed) + 20)
        self.assertEqual(len(names), len(set(names)))

    def test_slips_get_a_suggestion(self):
        for words, meant in {
            ("--projection", "hamer"): "did you mean hammer;",
            ("--projection", "equisold"): "did you mean equisolid;",
            ("--scene", "ruum"): "did you mean room;",
            ("--background", "slategry"): "did you mean slategray;",
            ("--tollerance", "1"): "did you mean --tolerance;",
            ("--hfvo=90",): "did you mean --hfov;",
        }.items():
            said = refusal(*words, *(() if "--scene" in words else ("--scene", "room")))
            self.assertIn(meant, said)
            self.assertEqual(said.count("\n"), 1)
        self.assertNotIn("did you mean", refusal("--scene", "room", "--projection", "qqqqqqqq"))


def corner(path):
    """The first pixel of a picture."""
    words = ["oiiotool", path, "--cut", "1x1+0+0", "--ch", "R,G,B", "-d", "uint8", "-o", path + ".ppm"]
    subprocess.run(words, check=True, timeout=SECONDS)
    with open(path + ".ppm", "rb") as stream:
        return tuple(stream.read()[-3:])


class Presets(Base):
    def presets(self):
        return json.loads(run("--list-presets", "--json").stdout)

    def test_each_is_what_would_be_drawn(self):
        self.assertGreater(len(self.presets()), 10)
        for preset in self.presets()[::3]:
            found = plan("--scene", "room", "--preset", preset["name"])
            for key in set(preset) - {"name", "title", "codec"}:
                self.assertEqual(found[key], preset[key], "%s of %s" % (key, preset["name"]))

    def test_names_are_listed(self):
        names = run("--list-presets").stdout.decode().split()
        self.assertEqual(names, [preset["name"] for preset in self.presets()])

    def test_documents_have_the_table(self):
        with open(os.path.join(ROOT, "Documentation", "presets.md"), encoding="utf-8") as stream:
            rows = [line.strip() for line in stream if line.startswith("| `")]
        self.assertEqual(rows, [row_of(preset) for preset in self.presets()])

    def test_the_command_line_goes_before(self):
        preset = ["--scene", "room", "--preset", "planetarium-stereo"]
        found = plan(*preset, "--fov", "220", "--size", "64x64", "--tilt", "75", "--ipd", "0.1")
        self.assertEqual((found["fov"], found["tilt"], found["ipd"]), (220, 75, 0.1))
        self.assertEqual(found["size"], [64, 64])
        found = plan(*preset, "--stereo", "mono")
        self.assertIsNone(found["layout"])
        found = plan(*preset, "--layout", "top-bottom", "--pole-fade", "10,20")
        self.assertEqual(found["picture"], [4096, 8192])
        self.assertEqual(found["pole_fade"], [10, 20])
        self.assertEqual(plan(*preset, "--hfov", "90")["fov"], 90)

    def test_another_projection_has_its_own_fields(self):
        found = plan("--scene", "room", "--preset", "domemaster-1k", "--projection", "hammer")
        self.assertEqual((found["hfov"], found["vfov"], found["tilt"]), (360, 180, 90))
        found = plan("--scene", "room", "--preset", "360-photo", "--projection", "mercator")
        self.assertLess(found["vfov"], 171)
        found = plan("--scene", "room", "--preset", "domemaster-1k", "--projection", "equisolid")
        self.assertEqual(found["fov"], 180)


def row_of(preset):
    """A row of the table in the documents."""
    if "fov" in preset:
        field = "%g° across" % preset["fov"]
    else:
        field = "%g° by %g°" % (preset["hfov"], preset["vfov"])
    eyes = preset["layout"] or "one"
    cells = [
        "`%s`" % preset["name"], preset["title"], preset["projection"], field,
        "%g°" % preset["tilt"], "%d × %d" % tuple(preset["size"]), eyes, preset["codec"] or "",
    ]
    return re.sub(" +", " ", "| " + " | ".join(cells) + " |")


class Config(Base):
    def test_a_file_gives_what_the_command_line_does_not(self):
        path = self.file(
            "view.conf",
            "# a view\n\nprojection = Hammer\nhfov=90\n--size = '64x32'\ndebug_view\n"
            "exact-perspective = no\nscene = room\n",
        )
        found = plan("--config", path, "--hfov", "100")
        self.assertEqual(found["projection"], "hammer")
        self.assertEqual((found["hfov"], found["size"]), (100, [64, 32]))
        self.assertEqual(plan("--config", path, self.mesh)["scene"], None)

    def test_it_may_name_a_preset_and_files(self):
        text = "preset = domemaster-1k\nsize = 512x512\noutput = a.png\noutput = b.png\nfile = %s\n"
        found = plan("--config", self.file("dome.conf", text % self.mesh))
        self.assertEqual((found["size"], found["fov"], found["tilt"]), ([512, 512], 180, 90))
        self.assertEqual(found["outputs"], ["a.png", "b.png"])
        self.assertEqual(found["files"], [self.mesh])

    def test_what_is_wrong_is_said_with_its_line(self):
        for text, said in {
            "hfov = 90\nhfvo = 9\n": "line 2: there is no option --hfvo, did you mean --hfov;",
            "hfov = 900\n": "line 1: --hfov: '900'",
            "two words\n": "line 1: 'two words' is not of the form NAME = VALUE",
            "debug-view = maybe\n": "line 1: --debug-view: there is no 'maybe'",
            "config = other\n": "is for the command line",
            "hfov = 1\nhfov = 2\n": "line 1: --hfov: At Most 1",
        }.items():
            self.assertIn(said, refusal("--scene", "room", "--config", self.file("c", text)))


class DryRun(Base):
    def test_nothing_is_drawn(self):
        path = os.path.join(self.place.name, "p.png")
        done = run(self.mesh, "--dry-run", "--output", path, env={"PATH": os.environ["PATH"]})
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.assertFalse(os.path.exists(path))
        text = done.stdout.decode()
        self.assertIn("projection: equirectangular\n", text)
        self.assertIn("size: 2048 1024\n", text)
        self.assertIn("outputs: " + path + "\n", text)

    def test_it_knows_the_scene(self):
        found = plan(self.mesh, "--eye", "0,0,1")
        self.assertEqual(found["eye"], [0, 0, 1])
        self.assertEqual(found["bounds"], [-1, 1, -1, 1, -2, -2])
        self.assertEqual(found["primitives"]["triangles"], 1)

    def test_files_of_two_eyes_are_named(self):
        eyes = ["--stereo", "omnidirectional", "--layout", "separate", "--output", "p.png"]
        self.assertEqual(plan(self.mesh, *eyes)["outputs"], ["p-left.png", "p-right.png"])

    def test_arrays_are_listed(self):
        lines = run("--list-arrays", self.mesh).stdout.decode().splitlines()
        self.assertEqual(
            lines,
            ["points  heat  float  1 to 4", "points  wind  double x 3  0 to 5", "cells  zone  int  7 to 7"],
        )
        wind = json.loads(run("--list-arrays", self.mesh, "--json").stdout)[1]
        self.assertEqual(
            wind,
            {"name": "wind", "of": "points", "type": "double", "components": 3, "range": [0, 5]},
        )


class Eyes(Base):
    EYES = ["--scene", "room", "--stereo", "omnidirectional"]

    def test_auto_is_by_the_nearest_thing_seen(self):
        # the triangle is seen at 2 straight ahead, and nowhere nearer
        words = [self.mesh, "--eye", "0,0,0", "--stereo", "omnidirectional", "--ipd", "auto"]
        self.assertAlmostEqual(plan(*words)["ipd"], 2 * 0.065 / 0.75, delta=2e-3)
        # no more than the scale matters
        far = plan(*words[:1], "--eye", "0,0,98", *words[3:])
        self.assertAlmostEqual(far["ipd"], 100 * 0.065 / 0.75, delta=0.1)

    def test_what_is_behind_does_not_count(self):
        words = [self.mesh, "--stereo", "omnidirectional", "--ipd", "auto", "--eye", "0,0,0"]
        half = ["--hfov", "180", "--vfov", "180", "--direction", "0,0,1"]
        done = run("--dry-run", *words, *half)
        self.assertIn(b"nothing is seen", done.stderr)

    def said(self, *words):
        return run("--dry-run", *self.EYES, *words).stderr.decode()

    def test_bad_distances_are_said_once(self):
        for ipd, said in {
            "1e-4": "under one nobody sees depth",
            "0.4": "is uncomfortable",
            "100": "--ipd 100 is larger",
        }.items():
            text = self.said("--ipd", ipd)
            self.assertIn(said, text)
            self.assertIn("give --ipd auto", text)
            self.assertEqual(text.count("\n"), 1)
            self.assertEqual(self.said("--ipd", ipd, "--quiet"), "")
        self.assertEqual(self.said("--ipd", "auto"), "")

    def test_flat_pictures_are_judged_too(self):
        flat = ["--dry-run", "--scene", "room", "--stereo", "offaxis", "--projection", "perspective"]
        near = run(*flat, "--convergence", "100").stderr.decode()
        self.assertIn("another --separation", near)


class Streams(Base):
    def test_a_picture_goes_to_standard_output(self):
        path = os.path.join(self.place.name, "p.png")
        words = [self.mesh, "--eye", "0,0,0", "--size", "32x16", "--samples", "0", "--verbose"]
        done = run(*words, "--background", "Tomato", "--output", path, "--output", "-")
        for said in ("reading " + self.mesh, "written: " + path):
            self.assertIn("widefov-render: %s\n" % said, done.stderr.decode())
        with open(path, "rb") as stream:
            self.assertEqual(done.stdout, stream.read())
        self.assertEqual(struct.unpack(">II", done.stdout[16:24]), (32, 16))
        self.assertEqual(corner(path), (255, 99, 71))

    def test_data_come_from_standard_input(self):
        ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        ply += "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
        ply += "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
        facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
        stl = "solid s\n" + facet + "endfacet\nendsolid s\n"
        corners = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
        for data in (MESH.encode(), ply.encode(), stl.encode(), bytes(80) + b"\1\0\0\0" + corners):
            done = run("-", "--dry-run", "--json", input=data, stdin=None)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(json.loads(done.stdout)["primitives"]["triangles"], 1)
        arrays = run("--list-arrays", "-", input=MESH.encode(), stdin=None).stdout
        self.assertIn(b"heat", arrays)

    def test_what_is_no_data_is_refused(self):
        for data, said in {b"": b"standard input is empty", b"no such data": b"is none of"}.items():
            done = run("-", "--output", "p.png", input=data, stdin=None)
            self.assertEqual(done.returncode, 1)
            self.assertIn(said, done.stderr)

    def test_a_reader_that_goes_away_is_no_error(self):
        for words in (["--help"], ["--list-projections", "--json"], ["--completion", "bash"]):
            ends = os.pipe()
            os.close(ends[0])
            done = subprocess.run(
                [RENDER, *words], stdout=ends[1], stderr=subprocess.PIPE, timeout=SECONDS, check=False
            )
            os.close(ends[1])
            self.assertEqual((done.returncode, done.stderr), (0, b""))


class Shell(Base):
    def complete(self, *words):
        """What bash would offer for the last of the words."""
        script = run("--completion", "bash").stdout.decode() + (
            "\nCOMP_WORDS=(%s)\nCOMP_CWORD=%d\n_widefov_render\nprintf '%%s\\n' \"${COMPREPLY[@]}\"\n"
            % (" ".join("'%s'" % word for word in words), len(words) - 1)
        )
        done = subprocess.run(
            ["bash", "-c", script], capture_output=True, timeout=SECONDS, check=True,
            cwd=self.place.name,
        )
        return done.stdout.decode().split()

    def test_options_names_and_files(self):
        self.assertEqual(self.complete("widefov-render", "--list-pre"), ["--list-presets"])
        self.assertEqual(self.complete("widefov-render", "--preset", "vr180-"), ["vr180-mono"])
        self.assertIn("atrium", self.complete("widefov-render", "--scene", "a"))
        self.assertIn("top-bottom", self.complete("widefov-render", "--layout", "top"))
        self.assertEqual(self.complete("widefov-render", "me"), ["mesh.vtk"])
        self.assertEqual(self.complete("widefov-render", "--sky", "me"), ["mesh.vtk"])
        self.assertEqual(self.complete("widefov-render", "--hfov", ""), [])

    def test_every_option_is_offered(self):
        text = run("--help").stdout.decode()
        listed = set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", text, re.M))
        self.assertEqual(set(self.complete("widefov-render", "--")), listed)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
