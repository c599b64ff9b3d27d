# SPDX-License-Identifier: BSD-3-Clause
"""What is between a server's ranks and the client's window: image compression, and frames with
fewer pixels, still and while the mouse moves."""

import os
import random

from paraview import simple

import composited
import pixels
import scene
import server

# Each compressor with its coarsest setting for frames while the mouse moves: SQUIRT's level, LZ4's
# quality, Zlib's level and colours (with opacity). Still frames are compressed without loss.
COMPRESSORS = ["vtkSquirtCompressor 0 5", "vtkLZ4Compressor 0 5", "vtkZlibImageCompressor 0 1 5 0"]

# Levels of 255: what the coarsest of their masks, 0xE0, leaves out.
LOSS = 31

# Levels of 255: SQUIRT keeps four bits of opacity, so much of the background shines through.
OPACITY = 15

# Of a view whose still frames are reduced.
SELECTIONS = 40


def grab_still(options, view, name):
    view.StillRender()
    return composited.grab(view, os.path.join(options.output, name + "-still.png"))


def grab_moving(options, view, name):
    view.InteractiveRender()
    return composited.grab(view, os.path.join(options.output, name + "-moving.png"))


def check_reduced(options, view, mesh):
    """Numbered cells, at factors that divide the size of the view and one that does not."""
    for projection, factor in (("equirectangular", 2), ("azimuthal-equidistant", 7)):
        view.Projection = projection
        view.ImageReductionFactor = factor
        picture = grab_moving(options, view, projection)
        composited.check_reduced(options, view, mesh, picture, factor)
        # and whole again
        composited.check_file(options, view, mesh, grab_still(options, view, projection))


def check_still_reduced(options, view, mesh, source):
    """Still frames as well. What is asked in pixels of the window, and what is drawn in tiles, is not
    reduced."""
    view.Projection = "equirectangular"
    view.StillRenderImageReductionFactor = 4
    picture = grab_still(options, view, "few")
    composited.check_reduced(options, view, mesh, picture, 4)
    large = os.path.join(options.output, "tiles.png")
    scene.save(view, large, [2 * pixel for pixel in scene.SIZE])
    composited.check_file(options, view, mesh, large)
    whole = os.path.join(options.output, "equirectangular-still.png")
    pixels.check_selection(view, source, whole, SELECTIONS, random.Random(3))
    view.StillRenderImageReductionFactor = 1


def check_reduced_layers(options, view, display):
    """Layers that are seen through, beside a small picture that is not reduced."""
    display.Opacity = 0.5
    simple.ColorBy(display, None)
    view.MaximumNumberOfPeels = 30
    view.ImageReductionFactor = 2
    width, height = (pixel // 2 for pixel in scene.SIZE)
    moving = pixels.read_rows(grab_moving(options, view, "layers"))
    view.ImageReductionFactor = 1
    small = scene.save(view, os.path.join(options.output, "small.png"), [width, height])
    other = pixels.count_different(pixels.reduce(moving, width, height), pixels.read_rows(small))
    print(other, "translucent pixels of a reduced frame differ", flush=True)
    scene.require(other <= composited.OTHERWISE * width * height, "reduced layers")


def check_compressor(options, view, compressor, plain, opacity):
    """The pixels are those without compression in a still frame, but for what opacity may change,
    and near ones while the mouse moves, which shows that the compressor was asked."""
    view.CompressorConfig = compressor
    name = compressor.split()[0]
    kept = pixels.largest_difference(pixels.read_rows(grab_still(options, view, name)), plain)
    moving = pixels.read_rows(grab_moving(options, view, name))
    coarse = pixels.count_different(moving, plain)
    off = pixels.largest_difference(moving, plain)
    print(compressor, "is off by", kept, "levels; moving:", off, "in", coarse, "pixels", flush=True)
    scene.require(kept <= opacity, name + " loses in a still frame")
    scene.require(coarse > 0 and off <= LOSS + opacity, name + " while the mouse moves")


def check_compression(options, view, display):
    """Shaded layers, on black and on a colour."""
    display.Ambient, display.Diffuse = 0.1, 0.9
    display.DiffuseColor = [1, 0.7, 0.4]
    view.MaximumNumberOfPeels = 4  # whatever is drawn
    view.ImageReductionFactor = 1
    for background in ([0, 0, 0], [0.2, 0.4, 1]):
        view.Background = background
        view.CompressorConfig = "NULL"
        plain = pixels.read_rows(grab_still(options, view, "plain"))
        for compressor in COMPRESSORS:
            squirt = compressor.startswith("vtkSquirt") and any(background)
            check_compressor(options, view, compressor, plain, OPACITY if squirt else 0)


def check(options):
    scene.load_plugin(options, remote=True)
    # compressed frames that move lose what the numbers of cells are
    view, mesh, source, display = composited.show_parts(
        options, RemoteRenderThreshold=0, CompressorConfig="NULL")
    check_reduced(options, view, mesh)
    check_still_reduced(options, view, mesh, source)
    check_reduced_layers(options, view, display)
    check_compression(options, view, display)


def main(options):
    with server.connected(os.path.join(options.output, "server.log"), options.server_ranks):
        check(options)


scene.run(main)
