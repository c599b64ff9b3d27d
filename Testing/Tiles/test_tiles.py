#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws pictures at once and in tiles, and compares them pixel by pixel.

    test_tiles.py WIDEFOV_RENDER IDIFF [GROUP...]      groups: Colors, Channels, Stereo, Files

What covers pixels by their rays is the same to the bit. A rasterizer rounds the ends of lines,
of points and of plain triangles in the coordinates of its window, so where these have a part in
a picture few pixels, named below, may differ by as little as an edge moves.
"""

import json
import os
import re
import subprocess
import sys
import tempfile

# Seconds until a run counts as hanging.
TIMEOUT = 240

# Neither divides the size, so that the last tiles are smaller.
SIZE = "212x107"
TILE = "64x48"

EXACT = 0

# Pixels of the 22,684 that the rasterizer's rounding may change.
ROUNDED = 120

# Pixels of 54,000 that a rounded direction of view may change.
TURNED = 60

# The same where lines lie along borders between pixels, as meridians do: either side may draw.
BORDERS = 4000

# The command line, and how many pixels may differ.
COLORS = [
    ("--scene globe --technique exact", EXACT),
    ("--scene globe --technique exact --projection hammer", EXACT),
    ("--scene globe --technique exact --projection azimuthal-equidistant --fov 360", EXACT),
    ("--scene globe --technique exact --projection panini --hfov 200 --vfov 120", EXACT),
    ("--scene globe --technique exact --projection equi-angular-cubemap", EXACT),
    ("--scene globe --technique exact --tilt 40 --samples 0", EXACT),
    ("--scene room --technique exact --projection stereographic --fov 250", EXACT),
    ("--scene globe", ROUNDED),
    ("--scene globe --technique preclip --projection hammer", ROUNDED),
    ("--scene globe --representation wireframe", BORDERS),
    ("--scene globe --representation surface-with-edges", BORDERS),
    ("--scene cornell --representation points --point-size 7", ROUNDED),
    ("--scene sphere --points-as-spheres --representation points --point-size 9", ROUNDED),
    ("--scene globe --projection perspective --hfov 100 --vfov 60", ROUNDED),
    ("--scene flow --projection perspective --hfov 60 --vfov 100 --tilt 20", ROUNDED),
    ("--scene flow --technique exact --projection perspective --hfov 60 --vfov 100 --tilt 20", EXACT),
]

CHANNELS = [
    ("--scene globe --technique exact", EXACT),
    ("--scene cornell --technique exact --projection azimuthal-equidistant", EXACT),
    ("--scene cornell --projection perspective --hfov 100 --vfov 60", ROUNDED),
    ("--scene cornell --tolerance 0.02 --projection perspective --hfov 100 --vfov 60", EXACT),
]

# A part of 100x60 pixels, and the whole that has it: its fields of view, its size, and where the part
# begins from the upper left.
BORDERS_OF = [
    (("--borders -60,90,-45,45", ("--hfov 180 --vfov 90", "120x60", "+20+0")), EXACT),
    (("--borders 0,90,-30,60", ("--hfov 180 --vfov 120", "200x80", "+100+0")), EXACT),
    (("--projection mercator --borders -90,0,-50,50", ("--projection mercator --hfov 180 --vfov 100",
        "200x60", "+0+0")), EXACT),
    # the lens is shifted by half a picture to the right, and by a quarter up
    (("--projection perspective --exact-perspective --borders 0,45,-18.43494882,45",
        ("--projection perspective --exact-perspective --hfov 90 --vfov 90", "200x90", "+100+0")), EXACT),
    (("--projection perspective --exact-perspective --borders -45,45,-45,45",
        ("--projection perspective --exact-perspective --hfov 90 --vfov 90", "100x60", "+0+0")), EXACT),
]

STEREO = [
    "--stereo omnidirectional --ipd 0.1 --layout side-by-side",
    "--stereo omnidirectional --ipd 0.1 --layout top-bottom",
    "--stereo omnidirectional --ipd 0.1 --layout side-by-side-half",
    "--stereo omnidirectional --ipd 0.1 --layout top-bottom-half",
    "--stereo omnidirectional --ipd 0.1 --layout anaglyph",
    "--stereo warped --layout left",
]
STEREO_SIZE = "212x108"


class Failures:
    def __init__(self):
        self.count = 0

    def check(self, right, what):
        if not right:
            self.count += 1
            print("FAILED: " + what)


class Tester:
    """Runs the programs in a folder of its own."""

    def __init__(self, render, idiff, folder):
        self.render, self.idiff, self.folder = render, idiff, folder
        self.failures = Failures()

    def path(self, name):
        return os.path.join(self.folder, name)

    def draw(self, arguments, outputs, tile=None, size=SIZE):
        command = [self.render] + arguments.split() + ["--size", size] + outputs
        command += ["--tile", tile] if tile else []
        done = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT, check=False)
        self.failures.check(
            done.returncode == 0, "%s: exit code %d: %s" % (command, done.returncode, done.stderr)
        )

    def differing(self, first, second):
        """The number of pixels that differ at all; -1 where they cannot be compared."""
        command = [self.idiff, "-fail", "0", "-warn", "0", self.path(first), self.path(second)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT, check=False)
        text = done.stdout + done.stderr
        if "PASS" in text:
            return 0
        found = re.search(r"(\d+) pixels \([^)]*\) over 0", text)
        return int(found.group(1)) if found else -1

    def compare(self, arguments, first, second, most):
        n = self.differing(first, second)
        print("%s: %s: %d pixels differ, %d may" % (arguments, second, n, most))
        self.failures.check(0 <= n <= most, arguments + ": " + second)


def colors(tester):
    for arguments, most in COLORS:
        tester.draw(arguments, ["-o", tester.path("once.tif")])
        tester.draw(arguments, ["-o", tester.path("tiles.tif")], TILE)
        tester.compare(arguments, "once.tif", "tiles.tif", most)


def channels(tester):
    for arguments, most in CHANNELS:
        for samples in ("", " --samples 0"):
            tester.draw(arguments + samples, ["--aov", tester.path("once.exr")])
            tester.draw(arguments + samples, ["--aov", tester.path("tiles.exr")], TILE)
            if most == EXACT:
                tester.compare(arguments + samples, "once.exr", "tiles.exr", EXACT)
            else:
                cells(tester, arguments + samples, most)


def cells(tester, arguments, most):
    """Where distances are rounded, the cells alone."""
    for name in ("once", "tiles"):
        command = ["oiiotool", tester.path(name + ".exr"), "--ch", "cell", "-o"]
        subprocess.run(command + [tester.path(name + "-cell.exr")], timeout=TIMEOUT, check=True)
    tester.compare(arguments, "once-cell.exr", "tiles-cell.exr", most)


def stereo(tester):
    for arguments in STEREO:
        arguments = "--scene cornell --technique exact " + arguments
        tester.draw(arguments, ["-o", tester.path("once.tif")], size=STEREO_SIZE)
        tester.draw(arguments, ["-o", tester.path("tiles.tif")], TILE, STEREO_SIZE)
        tester.compare(arguments, "once.tif", "tiles.tif", EXACT)
    arguments = "--scene cornell --technique exact --stereo omnidirectional --layout separate"
    tester.draw(arguments, ["-o", tester.path("once.tif"), "-o", tester.path("once.exr")])
    tester.draw(arguments, ["-o", tester.path("tiles.tif"), "-o", tester.path("tiles.exr")], TILE)
    for ending in ("-left.tif", "-right.tif", "-left.exr", "-right.exr"):
        tester.compare(arguments, "once" + ending, "tiles" + ending, EXACT)


def borders(tester):
    """A part of a picture: the same pixels as in the whole, and those of a head that is turned."""
    sphere = "--scene globe --technique exact --samples 0"
    for view, most in BORDERS_OF:
        part, (whole, size, offset) = view
        arguments = sphere + " " + part
        tester.draw(arguments, ["-o", tester.path("part.png")], size="100x60")
        tester.draw(arguments, ["-o", tester.path("tiles.png")], TILE, "100x60")
        tester.draw(sphere + " " + whole, ["-o", tester.path("whole.png")], size=size)
        command = ["oiiotool", tester.path("whole.png"), "--cut", "100x60" + offset, "-o"]
        subprocess.run(command + [tester.path("cut.png")], timeout=TIMEOUT, check=True)
        tester.compare(arguments, "part.png", "cut.png", most)
        tester.compare(arguments, "part.png", "tiles.png", most)
    panorama = "--scene room --samples 0"
    for technique, most in (("exact", TURNED), ("auto", 2 * ROUNDED)):
        drawn = panorama + " --technique " + technique
        tester.draw(drawn + " --borders -60,90,-45,45", ["-o", tester.path("part.jpg")], size="300x180")
        tester.draw(drawn + " --borders -60,90,-45,45", ["-o", tester.path("part.png")], size="300x180")
        tester.draw(drawn + " --hfov 150 --vfov 90 --direction 0.2588190451,0,-0.9659258263",
            ["-o", tester.path("turned.png")], size="300x180")
        tester.compare(drawn, "part.png", "turned.png", most)
    check_crop(tester)


def check_crop(tester):
    """What viewers of panoramas are told of 150 by 90 degrees, two pixels a degree."""
    command = ["exiftool", "-s3", "-FullPanoWidthPixels", "-FullPanoHeightPixels", "-CroppedAreaLeftPixels",
        "-CroppedAreaTopPixels", "-CroppedAreaImageWidthPixels", "-CroppedAreaImageHeightPixels"]
    for name in ("part.jpg", "part.png"):
        done = subprocess.run(command + [tester.path(name)], capture_output=True, text=True,
            timeout=TIMEOUT, check=True)
        told = done.stdout.split()
        tester.failures.check(told == ["720", "360", "240", "90", "300", "180"], "%s: %s" % (name, told))


def check_parts(tester, stats):
    """What each part of a run took: known, and the frames and programs are among it."""
    parts = stats["parts_ms"]
    names = ("reading", "clusters", "shaders", "drawing", "writing")
    tester.failures.check(set(parts) == set(names), "parts: %s" % parts)
    tester.failures.check(all(parts[name] >= 0 for name in names), "parts: %s" % parts)
    tester.failures.check(parts["shaders"] == stats["shaders"]["ms"] > 0, "shaders: %s" % parts)
    frame = stats["ms"]["max"] + (stats["shaders"]["first_frame_ms"] or 0)
    drawn = parts["clusters"] + parts["shaders"] + parts["drawing"]
    tester.failures.check(drawn > frame, "drawing: %s of frames of %s ms" % (parts, frame))
    tester.failures.check(parts["writing"] > 0, "writing: %s" % parts)


def files(tester):
    """Every format, its metadata, and what the statistics say."""
    arguments = "--scene room --technique exact"
    for ending in (".tif", ".exr", ".png", ".jpg"):
        once, tiles = "once" + ending, "tiles" + ending
        tester.draw(arguments, ["-o", tester.path(once)])
        tester.draw(
            arguments, ["-o", tester.path(tiles), "--stats", tester.path("stats.json")], TILE
        )
        tester.compare(arguments, once, tiles, EXACT)
        with open(tester.path(once), "rb") as a, open(tester.path(tiles), "rb") as b:
            panorama = [b"equirectangular" in stream.read() for stream in (a, b)]
        tester.failures.check(panorama[0] == panorama[1], tiles + ": panorama metadata")
    with open(tester.path("stats.json"), encoding="utf-8") as stream:
        stats = json.load(stream)
    tester.failures.check(stats["tiles"] == [4, 3], "tiles: %s" % stats["tiles"])
    tester.failures.check(stats["ms"]["median"] > 0, "no time is given")
    check_parts(tester, stats)
    # one tile is the whole picture
    tester.draw(
        arguments, ["-o", tester.path("one.png"), "--stats", tester.path("one.json")], "1000x1000"
    )
    with open(tester.path("one.json"), encoding="utf-8") as stream:
        check_parts(tester, json.load(stream))
    tester.compare(arguments, "once.png", "one.png", EXACT)


GROUPS = {"Colors": colors, "Channels": channels, "Stereo": stereo, "Borders": borders, "Files": files}


def main():
    render, idiff = sys.argv[1:3]
    failed = 0
    for name in sys.argv[3:] or GROUPS:
        with tempfile.TemporaryDirectory() as folder:
            tester = Tester(render, idiff, folder)
            GROUPS[name](tester)
            failed += tester.failures.count
    print("%d failed" % failed)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
