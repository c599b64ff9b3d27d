#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a frame should take on more ranks than were measured: a table from time_ranks.py's files.

    model_ranks.py FOLDER        with ranks1.json and ranks2.json in it

With D the time of drawing all data on one rank, E that of an empty frame and O what two ranks
take beyond E + D / 2 (compositing, and shares that are not equal), p ranks with a core each
take E + D / p + 2 O (1 - 1 / p): each rank of a binary swap sends and blends half the picture,
then a quarter, and so on.
"""

import json
import os
import sys

RANKS = [1, 2, 4, 8, 16, 32, 64]


def read(folder, ranks):
    with open(os.path.join(folder, "ranks%d.json" % ranks)) as file:
        return json.load(file)


def main(folder):
    one, two = read(folder, 1), read(folder, 2)
    drawing = one["data"] - one["empty"]
    overhead = two["data"] - one["empty"] - drawing / 2
    print("| ranks | drawing, ms | compositing, ms | frame, ms | speed-up |")
    print("| --- | --- | --- | --- | --- |")
    for p in RANKS:
        composite = 2 * overhead * (1 - 1 / p)
        frame = one["empty"] + drawing / p + composite
        print("| %d | %.0f | %.0f | %.0f | %.1f |" % (
            p, drawing / p, composite, frame, one["data"] / frame))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("model_ranks.py: name the folder with ranks1.json and ranks2.json")
    try:
        main(sys.argv[1])
    except (OSError, KeyError, ValueError) as error:
        sys.exit("model_ranks.py: cannot use the measurements: %s; run time_ranks.py first" % error)
