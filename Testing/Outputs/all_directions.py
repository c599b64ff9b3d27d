# SPDX-License-Identifier: BSD-3-Clause
"""A picture in which every direction has its own colour, and tests that draw it as a sky."""

import os
import subprocess
import tempfile
import unittest

import numpy

# Size of the picture, pixels. Its colours are waves of DENSITY radians a unit of the sphere: a turn
# by a degree changes them by 22 of 255 levels where they change most.
SKY = (2048, 1024)
DENSITY = 10

# Levels of 255 by which one direction may differ in two pictures: each filters the texture, and rays
# of direction maps are float32.
LEVELS = 3


def run(*words):
    return subprocess.run(words, check=True, stdout=subprocess.PIPE, timeout=120).stdout


def read_ppm(path):
    with open(path, "rb") as file:
        words = file.readline().split() + file.readline().split() + file.readline().split()
        data = file.read()
    width, height = int(words[1]), int(words[2])
    return numpy.frombuffer(data, numpy.uint8, width * height * 3).reshape(height, width, 3).astype(int)


def read_picture(path):
    run("oiiotool", path, "--ch", "R,G,B", "-d", "uint8", "-o", path + ".ppm")
    return read_ppm(path + ".ppm")


def all_directions():
    """The picture of all directions: -z in the middle, +x to the right of it, +y on top."""
    width, height = SKY
    longitude = numpy.pi * (2 * (numpy.arange(width) + 0.5) / width - 1)
    latitude = numpy.pi * (0.5 - (numpy.arange(height) + 0.5) / height)
    a, b = numpy.meshgrid(longitude, latitude)
    d = numpy.stack([numpy.cos(b) * numpy.sin(a), numpy.sin(b), -numpy.cos(b) * numpy.cos(a)], axis=-1)
    return numpy.rint(127.5 + 127.5 * numpy.sin(DENSITY * d + numpy.arange(3))).astype(numpy.uint8)


class SkyTest(unittest.TestCase):
    """A folder with the picture of all directions, and a mesh too small to be seen."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.sky = cls.path("sky.png")
        with open(cls.path("sky.ppm"), "wb") as file:
            file.write(b"P6\n%d %d\n255\n" % SKY + all_directions().tobytes())
        run("oiiotool", cls.path("sky.ppm"), "-o", cls.sky)
        cls.write("speck.obj", "v 0 0 -1\nv 1e-7 0 -1\nv 0 1e-7 -1\nf 1 2 3\n")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder.name, name)

    @classmethod
    def write(cls, name, text):
        with open(cls.path(name), "w", encoding="ascii") as file:
            file.write(text)
        return cls.path(name)
