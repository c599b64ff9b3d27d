# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's skybox: as its own Render View shows it, looking into six directions."""

import math
import os

from paraview import simple
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData

import pixels
import places
import scene

SIZE, FACE = [720, 360], 60
FACES = {"ahead": ((0, 0, -1), (0, 1, 0)), "right": ((1, 0, 0), (0, 1, 0)),
         "behind": ((0, 0, 1), (0, 1, 0)), "left": ((-1, 0, 0), (0, 1, 0)),
         "up": ((0, 1, 0), (0, 0, 1)), "down": ((0, -1, 0), (0, 0, -1))}

# Of 255: half a degree is the size of a pixel, and the colours change by 2 in a degree.
LEVELS = 3

# Pixels round a pole that are not compared: there a Render View mixes the other pole in.
POLE = 2


def write_texture(path):
    """Colours that tell all directions apart, smoothly."""
    width, height = 512, 256
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 3)
    for y in range(height):
        for x in range(width):
            turn, rise = 2 * math.pi * (x + 0.5) / width, math.pi * ((y + 0.5) / height - 0.5)
            for i, value in enumerate((math.cos(rise) * math.sin(turn), math.sin(rise),
                                       math.cos(rise) * math.cos(turn))):
                image.SetScalarComponentFromDouble(x, y, 0, i, 128 + 100 * value)
    pixels.write(image, path)


def show_sky(view, texture):
    view.BackgroundColorMode = "Skybox"
    view.BackgroundTexture = texture
    return view


def levels_of(number):
    return number >> 16, number >> 8 & 255, number & 255


def compare(wide, face, ahead, up):
    """Levels that the pixels of a face are off those of the panorama."""
    side = [ahead[1] * up[2] - ahead[2] * up[1], ahead[2] * up[0] - ahead[0] * up[2],
            ahead[0] * up[1] - ahead[1] * up[0]]
    off = []
    for y in range(FACE):
        for x in range(FACE):
            a, b = ((2 * i + 1) / FACE - 1 for i in (x, y))
            if ahead[1] and math.hypot(a, b) * FACE / 2 < POLE:
                continue
            there = [ahead[i] + a * side[i] + b * up[i] for i in range(3)]
            i, j = (int(c) for c in places.place_of(there, (0, 0, 0), SIZE))
            seen = levels_of(wide[min(j, SIZE[1] - 1)][min(i, SIZE[0] - 1)])
            off.append(max(abs(p - q) for p, q in zip(seen, levels_of(face[y][x]))))
    return off


def check_faces(options, view, texture):
    wide = pixels.read_rows(scene.save(view, os.path.join(options.output, "sky.png")))
    flat = show_sky(scene.make_view([FACE, FACE], kind="RenderView"), texture)
    flat.CameraViewAngle = 90
    off = []
    for name, (ahead, up) in FACES.items():
        scene.place_eye(flat, (0, 0, 0), ahead, up)
        path = scene.save(flat, os.path.join(options.output, name + ".png"))
        off += compare(wide, pixels.read_rows(path), ahead, up)
    print("faces: %d pixels, at most %g levels off" % (len(off), max(off)))
    scene.require(len(off) > 0.99 * 6 * FACE ** 2, "too few pixels")
    scene.require(max(off) <= LEVELS, "the sky is another one")


def check_outside(options, view):
    """Outside an oval map is the background."""
    view.Projection = "hammer"
    rows = pixels.read_rows(scene.save(view, os.path.join(options.output, "hammer.png")))
    ndc = [[((2 * x + 1) / SIZE[0] - 1, (2 * y + 1) / SIZE[1] - 1) for x in range(SIZE[0])]
           for y in range(SIZE[1])]
    wrong = [(x, y) for y, row in enumerate(rows) for x, number in enumerate(row)
             if abs(math.hypot(*ndc[y][x]) - 1) > 0.01
             and (number > 0) != (math.hypot(*ndc[y][x]) < 1)]
    print("hammer:", len(wrong), "pixels wrong")
    scene.require(not wrong, "the map's outside: %s" % wrong[:4])


def main(options):
    scene.load_plugin(options)
    path = os.path.join(options.output, "texture.png")
    write_texture(path)
    texture = simple.CreateTexture(path)
    view = show_sky(scene.make_view(SIZE), texture)
    scene.place_eye(view, (0, 0, 0), (0, 0, -1))
    check_outside(options, view)
    view.Projection = "equirectangular"
    check_faces(options, view, texture)  # the last: a texture is that of one window


scene.run(main)
