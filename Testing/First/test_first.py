#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What widefov-render shows of files where the command line says nothing but their names.

    test_first.py WIDEFOV-RENDER [GROUP]
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest

import files
import numpy
from matplotlib.image import imread

RENDER = sys.argv.pop(1)
SIZE = "128x64"

ROOM = files.joined(
    files.box((0, 0, 0), (8, 3, 6), inward=True), files.box((2, -1, 1), (1, 1, 1)),
    files.box((0.1, 0, -1), (0.3, 3, 0.3)))


class Case(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="first-")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def path(self, name, text=None):
        path = os.path.join(self.folder.name, name)
        if text is not None:
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(text)
        return path

    def run_it(self, *words):
        done = subprocess.run(
            [RENDER, *words], capture_output=True, text=True, check=False, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def draw(self, name, text, *words, size=SIZE):
        """The picture, rows of red, green, blue, and what was said of the eye."""
        picture = self.path("picture.png")
        done = self.run_it(
            self.path(name, text), *words, "--size", size, "--samples", "0", "--output", picture)
        said = [line for line in done.stderr.splitlines() if "the eye is" in line]
        self.assertLessEqual(len(said), 1)
        return imread(picture)[:, :, :3], said[0] if said else ""


def lit(picture):
    return picture.max(axis=2) > 0.05


def extent(mask):
    """Shares of the width and of the height."""
    rows, columns = numpy.nonzero(mask)
    return numpy.ptp(columns) / mask.shape[1], numpy.ptp(rows) / mask.shape[0]


def steps(picture):
    """The steepest from pixel to pixel, away from outlines."""
    inner = lit(picture)
    for shift in (-3, 3):
        inner = inner & numpy.roll(inner, shift, axis=0) & numpy.roll(inner, shift, axis=1)
    change = numpy.abs(numpy.diff(picture[:, :, 0], axis=1))
    return numpy.percentile(change[inner[:, 1:]], 99)


class Eye(Case):
    def check_outside(self, name, text, *words):
        picture, said = self.draw(name, text, *words)
        self.assertIn("is outside", said)
        self.assertGreater(max(extent(lit(picture))), 0.75)
        self.assertLess(max(extent(lit(picture))), 0.97)
        return picture

    def test_things_are_seen_from_outside(self):
        self.check_outside("box.vtk", files.legacy(files.box((7, 8, 9), (1, 1, 1))))
        for inward in (False, True):  # models come wound either way
            self.check_outside("eight.vtk", files.legacy(files.octahedron(inward)))

    def test_round_pictures_cut_no_corner(self):
        text = files.legacy(files.box((0, 0, 0), (1, 1, 1)))
        words = ["--projection", "azimuthal-equidistant", "--outside"]
        picture = self.draw("box.vtk", text, *words, size="128x128")[0]
        rows, columns = numpy.nonzero(lit(picture))
        self.assertLess(numpy.hypot(rows - 63.5, columns - 63.5).max(), 62)
        self.assertGreater(max(extent(lit(picture))), 0.6)

    def test_domes_show_a_thing_before_the_audience(self):
        for mesh in (files.box((7, 8, 9), (1, 1, 1)), files.sheet()):
            for tilt, more in ((90, []), (75, []), (90, ["--direction", "0,-0.2,-1"])):
                dome = ["--projection", "azimuthal-equidistant", "--fov", "180", "--tilt", str(tilt)]
                picture, said = self.draw("thing.vtk", files.legacy(mesh), *dome, *more, size="128x128")
                self.assertIn("is outside", said)
                rows, columns = numpy.nonzero(lit(picture))
                self.assertLess(numpy.hypot(rows - 63.5, columns - 63.5).max(), 62)
                self.assertGreater(rows.mean(), 70)  # below the middle is ahead
                self.assertGreater(max(extent(lit(picture))), 0.15)
                self.assertLess(abs(columns.mean() - 63.5), 6)

    def test_what_is_flat_is_seen_as_a_face(self):
        text = files.legacy(files.sheet())
        face = self.check_outside("sheet.vtk", text)
        self.assertGreater(lit(face).mean(), 0.35)  # a square in a picture twice as wide as high
        self.assertGreater(lit(self.check_outside("sheet.vtk", text, "--up", "0,0,1")).mean(), 0.15)

    def test_rooms_are_seen_from_inside(self):
        picture, said = self.draw("room.vtk", files.legacy(ROOM))
        self.assertIn("is inside", said)
        self.assertEqual(lit(picture).mean(), 1)

    def test_grids_are_seen_from_inside(self):
        text = files.grid(kind="STRUCTURED_GRID")
        self.assertIn("is inside, at 0,0,0", self.draw("grid.vtk", text)[1])
        self.assertIn("is inside", self.draw("flow.vtk", text, "--streamlines", "swirl")[1])

    def test_who_says_where_is_obeyed(self):
        text = files.legacy(ROOM)
        picture, said = self.draw("room.vtk", text, "--outside")
        self.assertEqual(said, "")
        self.assertLess(lit(picture).mean(), 0.9)
        text = files.legacy(files.box((0, 0, 0), (1, 1, 1)))
        for words in (["--inside"], ["--eye", "0.1,0,0"]):
            picture, said = self.draw("box.vtk", text, *words)
            self.assertEqual(said, "")
            self.assertEqual(lit(picture).mean(), 1)

    def test_the_field_of_view_that_is_given_stays(self):
        text = files.legacy(files.box((0, 0, 0), (1, 1, 1)))
        for words in (["--hfov", "360", "--vfov", "180"],
                      ["--projection", "azimuthal-equidistant", "--fov", "180"]):
            picture, said = self.draw("box.vtk", text, *words)
            self.assertIn("is outside", said)
            self.assertLess(max(extent(lit(picture))), 0.7)
            self.assertGreater(lit(picture).mean(), 0.02)


class Look(Case):
    def test_the_first_array_that_varies_gives_the_colours(self):
        points, faces = files.box((0, 0, 0), (1, 1, 1))
        height = [p[1] for p in points]
        text = files.legacy((points, faces), same=[3] * 8, height=height, depth=[p[2] for p in points])
        colored = self.draw("box.vtk", text, "--no-scalar-bar")[0]
        same = self.draw("box.vtk", text, "--no-scalar-bar", "--color-by", "height")[0]
        self.assertTrue(numpy.array_equal(colored, same))
        self.assertGreater(numpy.ptp(colored, axis=2).max(), 0.3)
        grey = self.draw("box.vtk", text, "--no-colors")[0]
        self.assertLess(numpy.ptp(grey, axis=2).max(), 0.01)

    def test_a_bar_says_what_the_colours_mean(self):
        points, faces = files.box((0, 0, 0), (1, 1, 1))
        text = files.legacy((points, faces), height=[p[1] for p in points])
        view = ["--hfov", "90", "--vfov", "45"]
        with_bar = self.draw("box.vtk", text, *view, size="256x128")[0]
        without = self.draw("box.vtk", text, *view, "--no-scalar-bar", size="256x128")[0]
        rows = numpy.nonzero((with_bar != without).any(axis=(1, 2)))[0]
        self.assertGreater(len(rows), 2)
        self.assertGreater(rows.min(), 0.7 * len(without))  # it is below

    def test_parts_without_the_array_are_grey(self):
        arrays = [{"stress": [p[1] for p in files.box((0, 0, 0), (1, 1, 1))[0]]}, {}]
        for order in (arrays, arrays[::-1]):
            for i, more in enumerate(order):
                self.path("block%d.vtp" % i, files.xml_surface(files.box((3 * i, 0, 0), (1, 1, 1)), **more))
            text = files.blocks("block0.vtp", "block1.vtp")
            usual = self.draw("blocks.vtm", text, "--no-scalar-bar", "--direction", "0,0,-1")[0]
            named = self.draw("blocks.vtm", text, "--no-scalar-bar", "--direction", "0,0,-1", "--color-by", "stress")[0]
            self.assertTrue(numpy.array_equal(usual, named))
            seen = numpy.nonzero(lit(usual).any(axis=0))[0]
            middle = (seen[0] + seen[-1]) // 2
            tint = [numpy.ptp(half, axis=2).max() for half in (usual[:, :middle], usual[:, middle:])]
            tint = tint if order is arrays else tint[::-1]
            self.assertGreater(tint[0], 0.3)
            self.assertLess(tint[1], 0.01)

    def test_bytes_named_as_colours_are_colours(self):
        mesh = files.box((0, 0, 0), (1, 1, 1))
        for name, color, place, count in (("RGB", (255, 0, 0), "PointData", 8), ("Colors", (255, 0, 0), "CellData", 6),
                                          ("RGBA", (255, 0, 0, 255), "PointData", 8)):
            text = files.xml_surface(mesh, place, **{"heat": range(count), name: count * [color]})
            picture = self.draw("box.vtp", text)[0]
            self.assertGreater(picture[:, :, 0].max(), 0.5)
            self.assertLess(picture[:, :, 1:].max(), 0.01)
        text = files.xml_surface(mesh, **{"other": 8 * [(255, 0, 0)], "heat": range(8)})
        self.assertGreater(self.draw("box.vtp", text, "--no-scalar-bar")[0][:, :, 2].max(), 0.3)

    def test_normals_are_smooth_but_at_edges(self):
        text = files.legacy(files.sphere())
        smooth, facets = (
            steps(self.draw("ball.vtk", text, *words)[0]) for words in ([], ["--no-smooth"]))
        self.assertLess(smooth, 0.7 * facets)
        text = files.legacy(files.box((0, 0, 0), (1, 1, 1)))
        both = [self.draw("box.vtk", text, *words)[0] for words in ([], ["--no-smooth"])]
        self.assertLess(numpy.abs(both[0] - both[1]).max(), 0.02)

    def test_surfaces_stay_under_arrows(self):
        text = files.grid(kind="STRUCTURED_GRID")
        for option in ("--vectors", "--streamlines"):
            words = [option, "swirl", "--no-scalar-bar"]
            inside, alone = (self.draw("flow.vtk", text, *words, *more)[0] for more in ([], ["--no-surface"]))
            self.assertEqual(lit(inside).mean(), 1)
            self.assertLess(lit(alone).mean(), 0.9)
            # what is before the surface hides nothing of it from outside
            outside = self.draw("flow.vtk", text, *words, "--outside")[0]
            self.assertGreater((numpy.ptp(outside, axis=2) > 0.2).mean(), 0.01)


class Materials(Case):
    def test_gltf_has_its_colours_and_textures(self):
        picture = self.draw("squares.gltf", files.gltf(), "--direction", "0,0,-1")[0]
        names = {"red": 0, "green": 1, "blue": 2}
        where = {}
        for name, channel in names.items():
            others = [i for i in range(3) if i != channel]
            rows, columns = numpy.nonzero(
                picture[:, :, channel] > 0.2 + picture[:, :, others].max(axis=2))
            self.assertGreater(len(rows), 100, name)
            where[name] = (rows.mean(), columns.mean())
        self.assertLess(where["red"][0] + 5, where["blue"][0])
        self.assertLess(where["red"][1] + 20, where["green"][1])
        self.assertLess(abs(where["red"][1] - where["blue"][1]), 3)


class Volumes(Case):
    def test_images_are_volumes(self):
        text = files.grid()
        volume, said = self.draw("image.vtk", text, "--no-scalar-bar")
        self.assertIn("is outside", said)
        # the values grow upwards: above it is dense, below clear but for the outline
        rows = numpy.nonzero(lit(volume).any(axis=1))[0]
        quarter = len(rows) // 4
        above, below = volume[rows[:quarter]].mean(), volume[rows[-quarter:]].mean()
        self.assertGreater(above, 4 * below)
        faces = self.draw("image.vtk", text, "--no-scalar-bar", "--no-volume")[0]
        self.assertGreater(faces[rows[-quarter:]].mean(), 1.5 * below)
        around = self.draw("image.vtk", text, "--inside", "--no-scalar-bar")[0]
        self.assertEqual(lit(around[:32]).mean(), 1)

    def test_cells_of_images_and_empty_borders(self):
        """What is inside is seen, though the surface has one value alone."""
        for cells in (True, False):
            picture = self.draw("ball.vtk", files.image_of_ball(cells), "--no-scalar-bar")[0]
            self.assertGreater(numpy.ptp(picture[28:36, 60:68], axis=2).max(), 0.1)
            self.assertLess(lit(picture).mean(), 0.5)

    def test_a_dry_run_names_them(self):
        words = [self.path("image.vtk", files.grid(count=5)), "--dry-run"]
        self.assertEqual(json.loads(self.run_it(*words, "--json").stdout)["volumes"], [[5, 5, 5]])
        self.assertIn("volumes: 5 5 5\n", self.run_it(*words).stdout)

    def test_what_is_thin_is_made_dense(self):
        text = files.grid(count=24, layer=True)
        picture = self.draw("image.vtk", text, "--no-scalar-bar", "--direction", "0,-1,0", "--up", "0,0,1")[0]
        self.assertGreater(picture[28:36, 60:68].max(axis=2).mean(), 0.5)

    def test_other_data_are_sampled(self):
        image = self.draw("image.vtk", files.grid(), "--no-scalar-bar")[0]
        grid = self.draw("grid.vtk", files.grid(kind="STRUCTURED_GRID"), "--no-scalar-bar", "--volume")[0]
        self.assertLess(numpy.abs(image - grid).mean(), 0.02)
        done = self.run_it(self.path("grid.vtk"), "--volume", "--dry-run")
        self.assertIn("is resampled on a grid of 128x128x128 points", done.stderr)

    def test_channels_show_surfaces(self):
        done = self.run_it(
            self.path("image.vtk", files.grid()), "--size", SIZE, "--aov", self.path("data.exr"))
        self.assertNotIn("warning", done.stderr)
        statistics = subprocess.run(
            ["oiiotool", "--stats", self.path("data.exr")], capture_output=True, text=True, check=True)
        line = [words for words in statistics.stdout.splitlines() if "Stats Max" in words][0]
        self.assertGreater(float(line.split()[2 + 5]), 1)  # cells of six faces


class Formats(Case):
    def test_the_page_lists_what_is_read(self):
        rows = json.loads(self.run_it("--list-formats", "--json").stdout)
        page = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Documentation", "formats.md")
        with open(page, encoding="utf-8") as stream:
            listed = [line for line in stream.read().splitlines() if line.startswith("| `")]
        self.assertEqual(listed, ["| `%s` | %s |" % (row["ending"], row["name"]) for row in rows])
        self.assertIn(".pvtu    VTK, parts of an unstructured grid\n", self.run_it("--list-formats").stdout)

    def tell(self, path):
        told = json.loads(self.run_it("--info", path, "--json").stdout)["files"][0]
        return told["points"], {array["name"]: (array["type"], array["components"]) for array in told["arrays"]}

    def test_clouds(self):
        colors = {"RGB": ("unsigned char", 3)}
        for name, text, count, arrays in (
                ("a.xyz", "# a cloud\n0 0 0\n1 2 3\n", 2, {}),
                ("b.xyz", "0 0 0 255 0 0\n1 2 3 0 1 2\n", 2, colors),
                ("c.pts", "2\n0 0 0 -5 255 0 0\n1 2 3 8 0 1 2\n", 2, {"column 4": ("double", 1), **colors}),
                ("d.csv", '"heat","x","y","z"\r\n7,0,0,0\r\n,1,2,3\r\n', 2, {"heat": ("double", 1)}),
                ("e.csv", "X;Y;Z;Red;Green;Blue\n0;0;0;1;2;3\n", 1, colors)):
            self.assertEqual(self.tell(self.path(name, text)), (count, arrays), name)

    def test_parts(self):
        for i in range(2):
            self.path("part%d.vtp" % i, files.xml_surface(files.box((3 * i, 0, 0), (1, 1, 1)), heat=range(8)))
        whole = self.path("whole.pvtp", '<VTKFile type="PPolyData"><PPolyData><PPointData><PDataArray type="Float32" '
                          'Name="heat"/></PPointData><PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>'
                          '<Piece Source="part0.vtp"/><Piece Source="part1.vtp"/></PPolyData></VTKFile>')
        self.assertEqual(self.tell(whole), (16, {"heat": ("float", 1)}))

    def test_images_of_medicine(self):
        header = "ObjectType = Image\nNDims = 3\nDimSize = 3 3 3\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
        self.assertEqual(self.tell(self.path("a.mha", header + 27 * "a"))[0], 27)


class Info(Case):
    def test_every_array_of_a_legacy_file_is_there(self):
        arrays = {"s%d" % i: [i] * 8 for i in range(10)}
        arrays.update({"v%d" % i: [[3 * i, 4 * i, 0]] * 8 for i in range(10)})
        path = self.path("many.vtk", files.legacy(files.box((0, 0, 0), (2, 4, 6)), **arrays))
        told = json.loads(self.run_it("--info", path, "--json").stdout)["files"][0]
        self.assertEqual(told["bounds"], [-1, 1, -2, 2, -3, 3])
        self.assertEqual((told["points"], told["cells"], told["surface_triangles"]), (8, 6, 12))
        self.assertEqual(told["times"], [])
        found = {array["name"]: array for array in told["arrays"]}
        self.assertEqual(set(found), set(arrays))
        self.assertEqual(found["s7"]["range"], [7, 7])
        self.assertEqual(found["v2"], {
            "name": "v2", "of": "points", "type": "float", "components": 3, "range": [10, 10]})
        text = self.run_it(path, "--info").stdout
        self.assertIn("bounds: x -1 to 1, y -2 to 2, z -3 to 3", text)
        self.assertIn("    v2 (points): float, 3 components, magnitude, 10 to 10\n", text)

    def test_nothing_has_no_bounds(self):
        path = self.path("empty.vtp", files.xml_surface(([], [])))
        self.assertIn("points: 0, cells: 0, triangles of the surface: 0\n  bounds: none\n",
                      self.run_it("--info", path).stdout)
        told = json.loads(self.run_it("--info", path, "--json").stdout)["files"][0]
        self.assertEqual((told["points"], told["bounds"]), (0, None))

    def test_a_series_tells_its_times_and_its_first_step(self):
        for step in range(3):  # the first is the largest, and named last
            box = files.box((0, 0, 0), (6 - step,) * 3)
            self.path("step%d.vtk" % step, files.legacy(box, heat=[step + 5] * 8, more=[step] * 8))
        other = files.legacy(files.box((9, 0, 0), (2, 2, 2)), heat=[8] * 8)
        self.path("other.vtk", other)
        entry = '<DataSet timestep="%g" file="%s"/>'
        steps = [entry % (0.5 * step, "step%d.vtk" % step) for step in (2, 1, 0)]
        pvd = self.path("all.pvd", '<VTKFile type="Collection"><Collection>%s</Collection></VTKFile>'
                        % "".join([*steps, entry % (0, "other.vtk")]))
        series = self.path("all.vtk.series", json.dumps({"files": [
            {"name": "step%d.vtk" % step, "time": 0.5 * step} for step in (2, 1, 0)]}))
        numbered = os.path.join(self.folder.name, "step%d.vtk")
        for path, end, cells, heat in (
                (pvd, 10, 12, [5, 8]), (series, 3, 6, [5, 5]), (numbered, 3, 6, [5, 5])):
            told = json.loads(self.run_it("--info", path, "--json").stdout)["files"][0]
            self.assertEqual(told["times"], [0, 1, 2] if path == numbered else [0, 0.5, 1])
            self.assertEqual(told["bounds"], [-3, end, -3, 3, -3, 3])
            self.assertEqual((told["cells"], told["surface_triangles"]), (cells, 2 * cells))
            self.assertEqual({a["name"]: a["range"] for a in told["arrays"]},
                             {"heat": heat, "more": [0, 0]})
            listed = json.loads(self.run_it("--list-arrays", path, "--json").stdout)
            self.assertEqual({a["name"]: a["range"] for a in listed}, {"heat": heat, "more": [0, 0]})
        self.assertIn("time steps: 3, 0 to 1; all else is of the first\n", self.run_it("--info", pvd).stdout)


if __name__ == "__main__":
    unittest.main()
