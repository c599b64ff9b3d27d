#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The cubemap that times are compared with draws what the scene has: as many pixels as we do.

    check_peer.py WIDEFOV_RENDER

Props all round the eye: the cullers of a stock renderer leave out those of five faces.
"""

import os
import subprocess
import sys
import tempfile

SIZE = "256x128"
DARK = 8  # of 255: the background is black
NEAR = 0.05  # of the pixels covered: the cubemap blurs silhouettes


def covered(render, technique, folder):
    path = os.path.join(folder, technique + ".png")
    drawn = [render, "--scene", "balls", "--technique", technique, "--size", SIZE, "--samples", "0"]
    subprocess.run(drawn + ["-o", path], check=True)
    ppm = path + ".ppm"
    subprocess.run(["oiiotool", path, "--ch", "R,G,B", "-d", "uint8", "-o", ppm], check=True)
    with open(ppm, "rb") as file:
        for _ in range(3):
            file.readline()
        data = file.read()
    return sum(max(data[i : i + 3]) > DARK for i in range(0, len(data), 3))


def main(render):
    with tempfile.TemporaryDirectory() as folder:
        ours, theirs = (covered(render, t, folder) for t in ("auto", "cubemap"))
    print("covered: %d pixels by auto, %d by the cubemap" % (ours, theirs))
    return 0 if ours > 0 and abs(theirs - ours) <= NEAR * ours else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
