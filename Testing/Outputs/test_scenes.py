#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Built-in scenes look the same with every VTK: each beside a picture of it that is kept.

    test_scenes.py WIDEFOV-RENDER FOLDER
    test_scenes.py WIDEFOV-RENDER FOLDER --write   makes the pictures anew

FOLDER has NAME.png of each scene that --list-scenes prints.
"""

import os
import subprocess
import sys
import tempfile

import numpy

SIZE = (256, 128)
STEP = 4  # each pixel of a kept picture is the mean of four by four
MEAN = 1.0  # of 255, in the mean of a picture: edges are sampled elsewhere by another driver
WORST = 24  # of 255, in the mean of four by four pixels of a thin thing


def read(path, folder):
    """Rows of red, green, blue, of any picture."""
    plain = os.path.join(folder, "plain.ppm")
    upright = ["--attrib:type=int", "pnm:pfmflip", "0"]  # of OpenImageIO 3.1
    subprocess.run(
        ["oiiotool", path, "--ch", "R,G,B", "-d", "uint8", *upright, "-o", plain], check=True
    )
    with open(plain, "rb") as file:
        words = file.readline().split() + file.readline().split() + file.readline().split()
        pixels = numpy.frombuffer(file.read(), numpy.uint8)
    width, height = int(words[1]), int(words[2])
    return pixels.reshape(height, width, 3).astype(float)


def write(path, picture, folder):
    plain = os.path.join(folder, "plain.ppm")
    with open(plain, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (picture.shape[1], picture.shape[0]))
        file.write(numpy.round(picture).astype(numpy.uint8).tobytes())
    subprocess.run(["oiiotool", plain, "-o", path], check=True)


def draw(program, scene, folder):
    """The scene's picture, made small."""
    path = os.path.join(folder, scene + ".png")
    size = "%dx%d" % SIZE
    command = [program, "--scene", scene, "--size", size, "--samples", "0", "-o", path]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    large = read(path, folder)
    rows, columns = large.shape[0] // STEP, large.shape[1] // STEP
    return large.reshape(rows, STEP, columns, STEP, 3).mean((1, 3))


def differences(one, other):
    """In the mean and at the worst, of 255."""
    apart = numpy.abs(one - other)
    return float(apart.mean()), float(apart.max())


def main(program, folder, anew=None):
    listed = subprocess.run([program, "--list-scenes"], check=True, capture_output=True, text=True)
    scenes = [line.split()[0] for line in listed.stdout.splitlines() if line.strip()]
    wrong = []
    with tempfile.TemporaryDirectory() as drawn:
        for scene in scenes:
            picture = draw(program, scene, drawn)
            kept = os.path.join(folder, scene + ".png")
            if anew == "--write":
                write(kept, picture, drawn)
                continue
            mean, worst = differences(picture, read(kept, drawn))
            print("%-14s %.2f in the mean, %.0f at the worst, of 255" % (scene, mean, worst))
            if mean > MEAN or worst > WORST:
                wrong.append(scene)
    print("%d scenes; other than they were: %s" % (len(scenes), ", ".join(wrong) or "none"))
    return 1 if wrong or not scenes else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
