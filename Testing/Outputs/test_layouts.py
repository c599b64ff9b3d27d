#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws one scene in every stereo layout and reads the files with other programs.

    test_layouts.py WIDEFOV_RENDER
"""

import base64
import json
import os
import subprocess
import sys
import tempfile
import unittest

import numpy

RENDER = sys.argv[1]
SIZE = (96, 48)
VIEW = ["--scene", "room", "--stereo", "omnidirectional", "--ipd", "0.3", "--samples", "0"]
HALF = ["--hfov", "180", "--vfov", "180", "--size", "64x64"]


def run(*words):
    return subprocess.run(words, check=True, stdout=subprocess.PIPE, timeout=120).stdout


def pixels(path):
    """Rows of red, green, blue, through a PPM file; told not to, OpenImageIO 3.1 does not write it
    upside down, as one of floats is."""
    ppm = path + ".ppm"
    upright = ["--attrib:type=int", "pnm:pfmflip", "0"]
    run("oiiotool", path, "--ch", "R,G,B", "-d", "uint8", *upright, "-o", ppm)
    with open(ppm, "rb") as file:
        words = file.readline().split() + file.readline().split() + file.readline().split()
        data = file.read()
    width, height = int(words[1]), int(words[2])
    return numpy.frombuffer(data, numpy.uint8, width * height * 3).reshape(height, width, 3)


def metadata(path, group):
    found = json.loads(run("exiftool", "-j", "-n", "-XMP-%s:all" % group, path))[0]
    found.pop("SourceFile")
    return found


class Layouts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.left = pixels(cls.draw("left", "l.png"))
        cls.right = pixels(cls.draw("right", "r.png"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def draw(cls, layout, name, *words):
        path = os.path.join(cls.folder.name, name)
        size = [] if "--size" in words else ["--size", "%dx%d" % SIZE]
        run(RENDER, *VIEW, *size, "--layout", layout, *words, "-o", path)
        return path

    def test_eyes_differ(self):
        self.assertGreater((self.left != self.right).any(axis=2).mean(), 0.01)

    def test_both_in_full_size(self):
        for layout, axis in (("side-by-side", 1), ("top-bottom", 0)):
            got = pixels(self.draw(layout, layout + ".png"))
            numpy.testing.assert_array_equal(got, numpy.concatenate([self.left, self.right], axis))

    def test_both_in_half_size(self):
        for layout, axis in (("side-by-side-half", 1), ("top-bottom-half", 0)):
            got = pixels(self.draw(layout, layout + ".png"))
            self.assertEqual(got.shape, self.left.shape)
            for part, eye in zip(numpy.split(got, 2, axis), (self.left, self.right)):
                wide = eye.astype(int)
                first, second = (wide[:, ::2], wide[:, 1::2]) if axis else (wide[::2], wide[1::2])
                numpy.testing.assert_array_equal(part, (first + second + 1) // 2)

    def test_separate(self):
        self.draw("separate", "s.png")
        for side, eye in (("left", self.left), ("right", self.right)):
            got = pixels(os.path.join(self.folder.name, "s-%s.png" % side))
            numpy.testing.assert_array_equal(got, eye)

    def test_anaglyph_colours(self):
        masks = {"red": 4, "green": 2, "blue": 1, "cyan": 3, "magenta": 5, "yellow": 6}
        for names in ("red,cyan", "green,magenta", "yellow,blue"):
            got = pixels(self.draw("anaglyph", "a.png", "--anaglyph", names,
                                   "--anaglyph-saturation", "1"))
            for name, eye in zip(names.split(","), (self.left, self.right)):
                for channel in range(3):
                    if masks[name] & (4 >> channel):
                        off = abs(got[:, :, channel].astype(int) - eye[:, :, channel])
                        self.assertLessEqual(off.max(), 1, (names, channel))
        grey = pixels(self.draw("anaglyph", "g.png", "--anaglyph-saturation", "0")).astype(int)
        self.assertLessEqual(abs(grey[:, :, 1] - grey[:, :, 2]).max(), 1)

    def test_multi_view(self):
        path = self.draw("multi-view", "m.exr")
        header = run("exrheader", path).decode()
        self.assertIn('view (type string): "left"', header)
        self.assertIn('view (type string): "right"', header)
        for part, eye in enumerate((self.left, self.right)):
            one = os.path.join(self.folder.name, "part%d.exr" % part)
            run("oiiotool", path, "--subimage", str(part), "-o", one)
            numpy.testing.assert_array_equal(pixels(one), eye)

    def test_spherical_metadata(self):
        for layout, mode in (("side-by-side", "left-right"), ("top-bottom", "top-bottom")):
            for ending in (".jpg", ".png"):
                found = metadata(self.draw(layout, "p" + ending), "GSpherical")
                self.assertEqual(found["StereoMode"], mode)
                self.assertEqual(found["ProjectionType"], "equirectangular")
                self.assertEqual(found["FullPanoWidthPixels"], SIZE[0])
                self.assertEqual(found["FullPanoHeightPixels"], SIZE[1])
                self.assertEqual(metadata(self.draw(layout, "p" + ending), "GPano"), {})
        for layout in ("anaglyph", "side-by-side-half"):
            self.assertEqual(metadata(self.draw(layout, "n.jpg"), "GSpherical"), {})

    def test_partial_panoramas(self):
        """The part of the sphere that is shown, in the middle of the whole; how far up it looks."""
        part = ["--hfov", "120", "--vfov", "45", "--size", "96x36", "--tilt", "30"]
        want = {"FullPanoWidthPixels": 288, "FullPanoHeightPixels": 144, "CroppedAreaImageWidthPixels": 96,
                "CroppedAreaImageHeightPixels": 36, "CroppedAreaLeftPixels": 96, "CroppedAreaTopPixels": 54,
                "PosePitchDegrees": 30, "ProjectionType": "equirectangular"}
        for ending in (".jpg", ".png", ".tif"):
            found = metadata(self.draw("left", "part" + ending, *part), "GPano")
            self.assertEqual({name: found.get(name) for name in want}, want, ending)
        self.assertEqual(metadata(self.draw("top-bottom", "part.jpg", *part), "GSpherical"), {})
        self.assertEqual(metadata(self.draw("left", "back.jpg", "--tilt", "120"), "GPano"), {})

    def test_vr180(self):
        path = self.draw("vr180", "v.png", *HALF)
        self.assertEqual(pixels(path).shape, (64, 128, 3))
        found = metadata(path, "GSpherical")
        self.assertEqual(found["StereoMode"], "left-right")
        self.assertEqual(found["FullPanoWidthPixels"], 128)
        self.assertEqual(found["CroppedAreaImageWidthPixels"], 64)
        self.assertEqual(found["CroppedAreaLeftPixels"], 32)

    def test_vr180_photo(self):
        photo = self.draw("vr180", "v.vr.jpg", *HALF)
        both = pixels(self.draw("vr180", "v.png", *HALF)).astype(int)
        found = metadata(photo, "GPano")
        self.assertEqual(found["ProjectionType"], "equirectangular")
        self.assertEqual(found["CroppedAreaImageWidthPixels"], 64)
        self.assertEqual(found["FullPanoWidthPixels"], 128)
        self.assertEqual(found["FullPanoHeightPixels"], 64)
        self.assertEqual(metadata(photo, "GImage")["ImageMimeType"], "image/jpeg")
        inner = os.path.join(self.folder.name, "inner.jpg")
        data = run("exiftool", "-b", "-XMP-GImage:ImageData", photo)
        with open(inner, "wb") as file:
            file.write(data if data[:2] == b"\xff\xd8" else base64.b64decode(data))
        for path, eye in ((photo, both[:, :64]), (inner, both[:, 64:])):
            # as near as JPEG keeps it
            self.assertLess(abs(pixels(path) - eye).mean(), 4)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
