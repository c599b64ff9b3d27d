# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView does to a whole picture: tone mapping is done to the wide one; ambient occlusion is left
out with one warning."""

import os

from paraview import simple

import messages
import pixels
import scene

# Balls ahead, on the right, behind and on the left.
PLACES = ((0, 0, -3), (3, 0, 0), (0.5, 0, 3), (-3, 0, 0))


def draw(options, view, name):
    return pixels.read_rows(scene.save(view, os.path.join(options.output, name + ".png")))


def lit(rows):
    return [[number > 0 for number in row] for row in rows]


def share(mask, other):
    """The part of the pixels that differs."""
    pairs = [(a, b) for row, other_row in zip(mask, other) for a, b in zip(row, other_row)]
    return sum(a != b for a, b in pairs) / len(pairs)


def main(options):
    scene.load_plugin(options)
    view = scene.make_view()
    for place in PLACES:
        simple.Show(simple.Sphere(Center=place, Radius=1), view)
    scene.place_eye(view, (0, 0, 0), (0, 0, -1))
    plain = draw(options, view, "plain")
    with messages.Log(options, "tone") as log:
        view.UseToneMapping = 1
        mapped = draw(options, view, "tone")
        scene.require(log.count("Warn") == 0, "tone mapping: a warning")
    view.UseToneMapping = 0
    scene.require(share(plain, mapped) > 0.01, "tone mapping changes nothing")
    scene.require(share(lit(plain), lit(mapped)) == 0, "tone mapping: another view")
    with messages.Log(options, "occlusion") as log:
        view.UseAmbientOcclusion = 1
        occluded = draw(options, view, "occlusion")
        draw(options, view, "again")
        said = log.count("left out in a wide view")
        scene.require(said == 1, "ambient occlusion: %d warnings" % said)
    scene.require(share(plain, occluded) == 0, "ambient occlusion: another picture")


scene.run(main)
