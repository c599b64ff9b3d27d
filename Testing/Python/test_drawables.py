#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the gallery of drawables, and looks for what is to be seen all round.

    PYTHONPATH=FOLDER test_drawables.py PROGRAM
"""

import os
import subprocess
import sys
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

# Equal parts of the picture's width, in each of which there is something.
PARTS = 5

# Of the pixels of a part, those of other colours than the picture's corner.
LEAST = 0.002


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)


def main():
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [sys.executable, "-B", sys.argv[1], folder], stderr=subprocess.PIPE, text=True, check=False)
        print(done.stderr, end="")
        wrong += done.returncode != 0 or done.stderr != ""
        for name in ("volume", "sky", "labels", "widgets"):
            picture = read(os.path.join(folder, name + ".png")).astype(int)
            other = numpy.abs(picture - picture[0, 0]).max(axis=2) > 20
            shares = [part.mean() for part in numpy.array_split(other, PARTS, axis=1)]
            print(name, " ".join("%.3f" % share for share in shares))
            wrong += min(shares) < LEAST
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
