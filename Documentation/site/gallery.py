#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the page of public data sets by the commands that stand there.

    gallery.py PROGRAMS LARGEST OUTDIR [DATA...]

Runs each block of "sh" of gallery.md with the programs of the folder PROGRAMS; pictures are LARGEST
pixels along their longer side and go into OUTDIR. Data are looked for in the folders DATA and in
those of Debian's package ferret-datasets; a picture whose data are not there is left out, in a line.
"""

import os
import shutil
import sys
import tempfile

import run_pages

PAGE = os.path.join(os.path.dirname(run_pages.HERE), "gallery.md")
FERRET = "/usr/share/ferret-vis/data"


def data_of(block):
    """The file that the program reads; None of a built-in scene."""
    first = block.split()[1]
    return None if first.startswith("-") else first


def link_data(folder, places):
    for place in places:
        for name in os.listdir(place):
            if not os.path.lexists(os.path.join(folder, name)):
                os.symlink(os.path.join(os.path.abspath(place), name), os.path.join(folder, name))


def main():
    if len(sys.argv) < 4 or not sys.argv[2].isdigit():
        sys.exit(__doc__)
    environment = run_pages.environment_of(os.path.abspath(sys.argv[1]), sys.argv[2])
    with open(PAGE, encoding="utf-8") as stream:
        blocks = run_pages.BLOCK.findall(stream.read())
    drawn = 0
    with tempfile.TemporaryDirectory() as folder:
        link_data(folder, sys.argv[4:] + [FERRET])
        for block in blocks:
            data = data_of(block)
            if data and not os.path.exists(os.path.join(folder, data)):
                print("gallery.py: left out, for there is no " + data)
                continue
            for name in run_pages.run(block, folder, environment):
                shutil.copy(os.path.join(folder, name), sys.argv[3])
                drawn += 1
    print("gallery.py: %d of %d pictures" % (drawn, len(blocks)))


if __name__ == "__main__":
    main()
