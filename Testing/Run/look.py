#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program of others that opens a window, and photographs the screen when it has come to rest.

    look.py OUTPUT.png SECONDS PROGRAM [ARGUMENT...]

It has an X display of its own, and SECONDS to draw. Prints one line: how many colours there are to see,
how it ended if it did, and what it said. The exit code is 1 where it crashed, showed nothing, or spoke
of an error of OpenGL.
"""

import os
import re
import subprocess
import sys
import time

import numpy
from matplotlib import image

sys.path.insert(1, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Viewer"))
from desktop import Desktop  # noqa: E402

LEAST_COLORS = 8  # of a window of a scene
GL_WORDS = re.compile(r"gl.?error|opengl|shader|GL_INVALID", re.I)
WAIT = 0.5  # seconds


SIZE = (1280, 1024)


def colors_of(picture):
    return len(numpy.unique(picture.reshape(-1, 3), axis=0))


def watch(program, desktop, seconds):
    """The last picture that showed something, when the screen rests or time is over."""
    end = time.monotonic() + seconds
    last = desktop.photograph(*SIZE)
    alike = 0
    while time.monotonic() < end and program.poll() is None and alike < 8:
        time.sleep(WAIT)
        picture = desktop.photograph(*SIZE)
        shows = colors_of(picture) >= LEAST_COLORS
        alike = alike + 1 if shows and (picture == last).all() else 0
        if shows or colors_of(last) < LEAST_COLORS:
            last = picture
    return last


def look(command, seconds, folder=None):
    """What the screen shows of a program that is started in the folder; what is wrong with it, a list
    of texts; and what it said, its lines."""
    desktop = Desktop()
    program = subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
        errors="replace", cwd=folder, env={**os.environ, "DISPLAY": desktop.name})
    picture = watch(program, desktop, seconds)
    ended = program.poll()
    program.kill()
    said = [line for line in program.communicate()[1].splitlines() if line.strip()]
    desktop.close()
    wrong = ["says %s" % line for line in said if GL_WORDS.search(line)]
    if ended:
        wrong.append("ends with %d" % ended)
    if colors_of(picture) < LEAST_COLORS:
        wrong.append("shows nothing")
    return picture, wrong, said


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    output, seconds, command = sys.argv[1], float(sys.argv[2]), sys.argv[3:]
    picture, wrong, said = look(command, seconds)
    image.imsave(output, picture)
    print("%s: %d colours, %s, said %s" % (
        command[-1].rsplit("/", 1)[-1], colors_of(picture), "; ".join(wrong) or "right", said[-3:]))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
