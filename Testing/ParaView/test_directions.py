# SPDX-License-Identifier: BSD-3-Clause
"""The projection direction-map: the directions of a panorama's pixels show that panorama, and
what is no such file is refused."""

import os
import sys

import numpy
from paraview import simple

import pixels
import scene

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Utilities"))
from exr import write_directions  # pylint: disable=wrong-import-position

# Pixels whose directions, in single precision, are beside an edge.
ROUNDED = 3

# Pixels: as near to the truth as auto and exact are.
NEAR = 0.02


def directions():
    """Those of an equirectangular picture of everything, the top row first."""
    width, height = scene.SIZE
    longitude = 2 * numpy.pi * ((numpy.arange(width) + 0.5) / width - 0.5)
    latitude = numpy.pi * (0.5 - (numpy.arange(height) + 0.5) / height)
    a, b = numpy.meshgrid(longitude, latitude)
    return numpy.stack(
        [numpy.sin(a) * numpy.cos(b), numpy.sin(b), -numpy.cos(a) * numpy.cos(b)], axis=-1
    )


def check_map(options, view, mesh):
    # chords of fine triangles may be so far beside their edges; a map has none
    technique = view.Technique
    view.Technique = "Exact"
    panorama = scene.save(view, os.path.join(options.output, "panorama.png"))
    view.Technique = technique
    view.Projection = "direction-map"
    nothing = scene.save(view, os.path.join(options.output, "nothing.png"))
    scene.require(pixels.count_lit(nothing) == 0, "without a file something is shown")
    path = os.path.join(options.output, "directions.exr")
    write_directions(path, directions())
    view.DirectionMapFile = path
    picture = scene.save(view, os.path.join(options.output, "directions.png"))
    other = pixels.count_different(pixels.read_rows(panorama), pixels.read_rows(picture))
    request = {"projection": "equirectangular", "hfov": 360, "vfov": 180,
               "clip": scene.EVERYTHING, **scene.pose_of(view)}
    answer = scene.check(options, request, mesh, picture, NEAR)
    print(other, "pixels differ from the panorama's;", answer)
    scene.require(other <= ROUNDED and answer["unexplained"] == 0, "directions")
    return picture


def check_refused(options, view, picture):
    """The old map stays."""
    broken = os.path.join(options.output, "broken.exr")
    with open(os.path.join(options.output, "directions.exr"), "rb") as file:
        begin = file.read(3000)
    with open(broken, "wb") as file:
        file.write(begin)
    long = os.path.join(options.output, "long.exr")
    write_directions(long, 2 * directions())
    for path in (broken, long, os.path.join(options.output, "none.exr"), picture):
        view.DirectionMapFile = path
        again = scene.save(view, os.path.join(options.output, "again.png"))
        scene.require(pixels.read_rows(again) == pixels.read_rows(picture), path)


def main(options):
    scene.load_plugin(options)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    view = scene.make_view()
    scene.show_cells(simple.XMLPolyDataReader(FileName=[mesh]), view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    check_refused(options, view, check_map(options, view, mesh))


scene.run(main)
