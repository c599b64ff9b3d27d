#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""FFmpeg's filter v360 as an independent witness: the same picture of all directions in the same map, drawn
here and converted there.

    test_v360.py WIDEFOV_RENDER
"""

import os
import subprocess
import sys
import tempfile
import unittest

import numpy

RENDER = sys.argv[1]

# Pixels of the picture of all directions. Its colours are waves of DENSITY radians a unit of the sphere:
# a turn by a degree changes them by 22 of 255 levels where they change most.
SKY = (2048, 1024)
DENSITY = 10

# Levels of 255 by which two filters of one texture may differ: both interpolate between its pixels.
LEVELS = 3

# Part of the pixels that may differ more: those on the borders of circles and faces, which belong to one side.
BESIDE_BORDERS = 0.02

# Names and options of a map: here, its size, and there.
MAPS = {
    "fisheye": ("azimuthal-equidistant --fov 180", "256x256", "fisheye:h_fov=180:v_fov=180"),
    "equisolid": ("azimuthal-equal-area --fov 180", "256x256", "equisolid:h_fov=180:v_fov=180"),
    "stereographic": ("stereographic --fov 180", "256x256", "sg:h_fov=180:v_fov=180"),
    "flat": ("gnomonic --fov 90 --circle 128,128,128", "256x256", "flat:h_fov=90:v_fov=90"),
    "dual fisheye": ("direction-map --direction-map dual-fisheye", "512x256", "dfisheye:h_fov=180:v_fov=180"),
    "faces 3x2": ("direction-map --direction-map cube-3x2", "384x256", "c3x2"),
    "faces 6x1": ("direction-map --direction-map cube-6x1", "768x128", "c6x1"),
}


def run(*words):
    return subprocess.run(words, check=True, stdout=subprocess.PIPE, timeout=120).stdout


def read_ppm(path):
    with open(path, "rb") as file:
        words = file.readline().split() + file.readline().split() + file.readline().split()
        data = file.read()
    width, height = int(words[1]), int(words[2])
    return numpy.frombuffer(data, numpy.uint8, width * height * 3).reshape(height, width, 3).astype(int)


def all_directions():
    """The picture of all directions: -z in the middle, +x to the right of it, +y on top."""
    width, height = SKY
    longitude = numpy.pi * (2 * (numpy.arange(width) + 0.5) / width - 1)
    latitude = numpy.pi * (0.5 - (numpy.arange(height) + 0.5) / height)
    a, b = numpy.meshgrid(longitude, latitude)
    d = numpy.stack([numpy.cos(b) * numpy.sin(a), numpy.sin(b), -numpy.cos(b) * numpy.cos(a)], axis=-1)
    return numpy.rint(127.5 + 127.5 * numpy.sin(DENSITY * d + numpy.arange(3))).astype(numpy.uint8)


class Maps(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.sky = cls.path("sky.png")
        with open(cls.path("sky.ppm"), "wb") as file:
            file.write(b"P6\n%d %d\n255\n" % SKY + all_directions().tobytes())
        run("oiiotool", cls.path("sky.ppm"), "-o", cls.sky)
        with open(cls.path("speck.obj"), "w", encoding="ascii") as file:
            file.write("v 0 0 -1\nv 1e-7 0 -1\nv 0 1e-7 -1\nf 1 2 3\n")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder.name, name)

    def drawn(self, words, size):
        path = self.path("drawn.png")
        run(RENDER, self.path("speck.obj"), "--sky", self.sky, "--eye", "0,0,0", "--samples", "0",
            "--background", "0,0,0", "--projection", *words.split(), "--size", size, "-o", path)
        run("oiiotool", path, "--ch", "R,G,B", "-d", "uint8", "-o", path + ".ppm")
        return read_ppm(path + ".ppm")

    def converted(self, output, size):
        width, height = size.split("x")
        path = self.path("converted.ppm")
        run("ffmpeg", "-v", "error", "-y", "-i", self.sky, "-vf",
            "format=gbrp,v360=e:%s:w=%s:h=%s:interp=linear,format=rgb24" % (output, width, height), path)
        return read_ppm(path)

    def check(self, words, size, output):
        ours = self.drawn(words, size)
        theirs = self.converted(output, size)
        self.assertEqual(ours.shape, theirs.shape)
        # v360 fills the corners beside some maps with what is nearest; here they are black
        inside = ours.any(axis=2)
        self.assertGreater(inside.mean(), 0.6)
        off = abs(ours - theirs).max(axis=2) > LEVELS
        worst = numpy.argwhere(off & inside)
        self.assertLess((off & inside).mean(), BESIDE_BORDERS,
                        "first of them at %s" % (worst[:1][:, ::-1].tolist(),))


def add(name, arguments):
    def test(self):
        self.check(*arguments)

    setattr(Maps, "test_" + name.replace(" ", "_"), test)


for title, row in MAPS.items():
    add(title, row)

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
