# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of films share: a folder each, small films, readers of others."""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy
from matplotlib.image import imread

RENDER = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else ""
SIZE = (64, 32)
PROGRESS = re.compile(r": (frame|the first frame of) ")
LAST = re.compile(r"frame( is|s are|s \d+ to \d+ of \d+ are) in ")

# A square before the eye, with one scalar at all of its points.
SQUARE = """<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="4" NumberOfPolys="1" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0">
<PointData Scalars="heat"><DataArray type="Float32" Name="heat" format="ascii">
{heat} {heat} {heat} {heat}</DataArray></PointData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">
-1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1</DataArray></Points>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray></Polys>
</Piece></PolyData></VTKFile>
"""


# As VTK writes a surface without points.
EMPTY = '<VTKFile type="PolyData"><PolyData><Piece NumberOfPoints="0"><Points/></Piece></PolyData></VTKFile>'


class FilmTest(unittest.TestCase):
    """Each test in a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="film-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as stream:
            stream.write(text)

    def command(self, *options):
        size = [] if "--size" in options else ["--size", "%dx%d" % SIZE]
        data = ["--scene", "room"] if "--film" in options and not has_data(options) else []
        return [RENDER, *data, "--samples", "0", *size, *options]

    def run_film(self, *options, **more):
        done = subprocess.run(
            self.command(*options), cwd=self.folder, capture_output=True, text=True, timeout=120,
            check=False, **more
        )
        self.assertNotRegex(done.stderr, "frame 0 of|, 0 MB")  # of progress, where it is slow
        return done

    def film(self, *options):
        """What a run that goes well says, but for how far it is."""
        done = self.run_film(*options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return words_of(done.stderr)

    def frames(self, folder="frames"):
        """The pictures of a folder as floats, in the order of their names."""
        place = self.path(folder)
        return [imread(os.path.join(place, name))[:, :, :3] for name in sorted(os.listdir(place))]

    def assert_same(self, one, other, tolerance=0.02):
        """Pictures; what is drawn at other angles may differ at edges."""
        self.assertLess(numpy.abs(one - other).mean(), tolerance)


def words_of(text):
    """Without the lines of progress, which a slow machine has, of new folders, and of where all is at the end."""
    lines = [line for line in text.splitlines()
             if not line.endswith(" s)") and not PROGRESS.search(line) and not LAST.search(line)
             and not line.endswith(" was not there, and is made")]
    return "\n".join(lines)


def has_data(options):
    return any(word.endswith((".vtp", ".pvd", ".series", ".ex2", ".vti")) for word in options)


def probe(path):
    """The stream of pictures, as ffprobe reads it, with the number of its frames."""
    words = ["ffprobe", "-v", "error", "-select_streams", "v", "-count_packets"]
    text = subprocess.check_output([*words, "-show_streams", "-of", "json", path], timeout=60)
    return json.loads(text)["streams"][0]


def side_data(path):
    """Name -> what ffprobe reads of it."""
    return {part["side_data_type"]: part for part in probe(path).get("side_data_list", [])}


def exif(path):
    text = subprocess.check_output(["exiftool", "-j", "-n", "-G1", "-U", path], timeout=60)
    return json.loads(text)[0]


def main():
    unittest.main(argv=sys.argv[:1])
