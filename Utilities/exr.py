# SPDX-License-Identifier: BSD-3-Clause
"""Writes OpenEXR images: single part, scan lines, float32, uncompressed (the OpenEXR file
layout, version 2), so that scripts need nothing but numpy."""

import struct

import numpy


def _attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def exr_bytes(channels):
    """The file of a dictionary of channels: name -> array (height, width), the top row first."""
    names = sorted(channels)  # as the format asks for
    height, width = channels[names[0]].shape
    box = struct.pack("<4i", 0, 0, width - 1, height - 1)
    float_type, sampling = 2, 1
    entries = b"".join(
        name.encode() + b"\0" + struct.pack("<iB3xii", float_type, 0, sampling, sampling)
        for name in names
    )
    header = struct.pack("<ii", 20000630, 2)
    header += _attribute("channels", "chlist", entries + b"\0")
    header += _attribute("compression", "compression", b"\0")
    header += _attribute("dataWindow", "box2i", box)
    header += _attribute("displayWindow", "box2i", box)
    header += _attribute("lineOrder", "lineOrder", b"\0")
    header += _attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += _attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
    header += _attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    size = 4 * width * len(names)
    first = len(header) + 8 * height
    offsets = b"".join(struct.pack("<Q", first + row * (8 + size)) for row in range(height))
    rows = numpy.stack([numpy.asarray(channels[n], "<f4") for n in names], axis=1)
    lines = b"".join(struct.pack("<ii", row, size) + rows[row].tobytes() for row in range(height))
    return header + offsets + lines


def write_exr(path, channels):
    with open(path, "wb") as stream:
        stream.write(exr_bytes(channels))


def write_directions(path, directions):
    """A direction map: an array (height, width, 3) of unit vectors, the top row first."""
    write_exr(path, {"X": directions[..., 0], "Y": directions[..., 1], "Z": directions[..., 2]})
