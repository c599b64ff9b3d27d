# SPDX-License-Identifier: BSD-3-Clause
"""Writes the input files of the bad-input test: good ones, and every kind of broken."""

import os
import random
import struct
import sys

import numpy
from lenses import lens_files
from projectors import projector_files
from rooms import room_files

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "Utilities"))
from exr import exr_bytes  # pylint: disable=wrong-import-position

NAN = float("nan")
INFINITY = float("inf")

# Endings that widefov-render reads.
ENDINGS = (
    "vtk vtp vtu vti vts vtr vtm pvtp pvtu pvti pvts pvtr vtkhdf stl ply obj g pdb ex2 case nc cdf mha mhd nii "
    "xyz pts csv glb gltf"
).split()

# Four triangles in front of and behind the eye at the origin.
POINTS = [
    (-1, -1, -2), (1, -1, -2), (0, 1, -2),
    (-1, -1, 2), (1, -1, 2), (0, 1, 2),
    (-2, -1, 1), (-2, -1, -1), (-2, 1, 0),
    (2, -1, 1), (2, -1, -1), (2, 1, 0),
]
TRIANGLES = [(0, 1, 2), (3, 4, 5), (6, 7, 8), (9, 10, 11)]


def legacy(points=None, triangles=None, count=None):
    """A legacy .vtk text with the point arrays `heat` (scalars) and `wind` (vectors)."""
    points = POINTS if points is None else points
    triangles = TRIANGLES if triangles is None else triangles
    lines = ["# vtk DataFile Version 3.0", "bad-input test", "ASCII", "DATASET POLYDATA"]
    lines.append("POINTS %s float" % (len(points) if count is None else count))
    lines += ["%s %s %s" % point for point in points]
    lines.append("POLYGONS %d %d" % (len(triangles), 4 * len(triangles)))
    lines += ["3 %d %d %d" % triangle for triangle in triangles]
    lines += ["POINT_DATA %d" % len(points), "SCALARS heat float", "LOOKUP_TABLE default"]
    lines += ["%d" % i for i in range(len(points))]
    lines += ["VECTORS wind float"] + ["1 0 %d" % (i % 3) for i in range(len(points))]
    return "\n".join(lines) + "\n"


def binary(points):
    """A legacy .vtk file in binary, which, unlike the text, can hold NaN and infinity."""
    head = "# vtk DataFile Version 3.0\nbad-input test\nBINARY\nDATASET POLYDATA\n"
    flat = [coordinate for point in points for coordinate in point]
    ids = [number for triangle in TRIANGLES for number in (3,) + triangle]
    body = b"POINTS %d float\n" % len(points) + struct.pack(">%df" % len(flat), *flat)
    body += b"\nPOLYGONS %d %d\n" % (len(TRIANGLES), len(ids))
    return head.encode() + body + struct.pack(">%di" % len(ids), *ids) + b"\n"


def replaced(index, point):
    """POINTS with one of them replaced."""
    points = list(POINTS)
    points[index] = point
    return points


XML = (
    '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">\n'
    '<PolyData><Piece NumberOfPoints="3" NumberOfPolys="1"><Points>\n'
    '<DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 -1 1 0 -1 '
)

def ply(order=None):
    """A PLY file, in binary if there is an order of bytes ("<", ">")."""
    kind = {"<": "binary_little_endian", ">": "binary_big_endian"}.get(order, "ascii")
    head = (
        "ply\nformat %s 1.0\ncomment bad-input test\nelement vertex %d\n"
        "property float x\nproperty float y\nproperty float z\nelement face %d\n"
        "property list uchar int vertex_indices\nend_header\n"
    ) % (kind, len(POINTS), len(TRIANGLES))
    if not order:
        lines = ["%d %d %d" % point for point in POINTS]
        lines += ["3 %d %d %d" % triangle for triangle in TRIANGLES]
        return (head + "\n".join(lines) + "\n").encode()
    body = b"".join(struct.pack(order + "3f", *point) for point in POINTS)
    return head.encode() + body + b"".join(
        struct.pack(order + "B3i", 3, *triangle) for triangle in TRIANGLES)


def ply_files():
    """File name -> PLY file: good ones, and what a broken copy leaves of them."""
    text = ply()
    negative = text.replace(b"3 9 10 11", b"-3 9 10 11")
    return {
        "good.ply": text,
        "little.ply": ply("<"),
        "big.ply": ply(">"),
        "truncated.ply": text[: text.index(b"0 1 -2")],
        "truncated-header.ply": text[: text.index(b"property list")],
        "truncated-face.ply": text[: text.rindex(b" ")],
        "truncated-little.ply": ply("<")[:-1],
        "truncated-big.ply": ply(">")[:-14],  # a face of 13 bytes, and one byte
        "negative-list.ply": negative,
    }


# A point, of which the values follow.
PLY = "ply\nformat ascii 1.0\nelement vertex 1\nproperty %s x\nproperty float y\nproperty float z\nend_header\n"


def texts():
    """File name -> text of every file that is text."""
    files = {
        "good.vtk": legacy(),
        "truncated.vtk": legacy()[: len(legacy()) // 3],
        "truncated.vtp": XML,
        "no-points.vtk": legacy([], []),
        "no-cells.vtk": legacy(triangles=[]),
        "negative-count.vtk": legacy(count=-3),
        "huge-count.vtk": legacy(count=10**15),
        "wrong-index.vtk": legacy(triangles=TRIANGLES + [(0, 1, 40000000)]),
        "negative-index.vtk": legacy(triangles=TRIANGLES + [(0, 1, -7)]),
        "zero-area.vtk": legacy(triangles=TRIANGLES + [(0, 0, 1), (5, 5, 5)]),
        "only-zero-area.vtk": legacy(triangles=[(0, 0, 1), (5, 5, 5)]),
        "unknown.abc": "1 2 3\n",
        "some.nrrd": "NRRD0004\n",
        "some.xdmf": "<Xdmf/>\n",
        "short.xyz": "1 2 3\n4 5\n",
        "no-places.csv": "a,b,c\n1,2,3\n",
        "words.ply": PLY % "float" + "a b c\n",
        "type.ply": PLY % "foo" + "1 2 3\n",
        "no-place.ply": "ply\nformat ascii 1.0\nelement face 0\nend_header\n",
        "empty-data.vtp": '<VTKFile type="PolyData"><PolyData/></VTKFile>',
        "unknown.conf": "# options\nhfvo = 90\n",
        "wrong.conf": "hfov = 900\n",
        "words.conf": "a line of words\n",
        "no-ending": legacy(),
    }
    files.update(("empty." + ending, "") for ending in ENDINGS)
    return files


def direction_maps():
    """File name -> OpenEXR image: direction maps, a good one of 64 x 32 pixels, the size that
    the runner asks for, and bad ones."""
    x, y = numpy.meshgrid((numpy.arange(64) - 31.5) / 32, (15.5 - numpy.arange(32)) / 32)
    length = numpy.sqrt(x * x + y * y + 1)
    good = {"X": x / length, "Y": y / length, "Z": -1 / length}

    def with_pixel(**values):
        channels = {name: values_.copy() for name, values_ in good.items()}
        for name, value in values.items():
            channels[name][3, 5] = value
        return exr_bytes(channels)

    zero = {name: 0 * values for name, values in good.items()}
    return {
        "map.exr": exr_bytes(good),
        "map-nan.exr": with_pixel(X=NAN),
        "map-infinite.exr": with_pixel(Y=INFINITY),
        "map-long.exr": with_pixel(Z=-2),
        "map-empty.exr": exr_bytes(zero),
        "map-channels.exr": exr_bytes({"U": x, "V": y}),
        "map-line.exr": exr_bytes({name: values[:1] for name, values in good.items()}),
        "map-cut.exr": exr_bytes(good)[:2000],
    }


def write_inputs(folder):
    """Writes all of them below folder, with a folder, a pipe and a link that loops."""
    files = {name: text.encode() for name, text in texts().items()}
    files["nan.vtk"] = binary(replaced(2, (NAN, 1, -2)))
    files["infinite.vtk"] = binary(replaced(2, (0, INFINITY, -2)))
    files["only-nan.vtk"] = binary([(NAN, NAN, NAN)] * len(POINTS))
    files.update(ply_files())
    files.update(direction_maps())
    for written in (room_files(), lens_files(), projector_files()):
        files.update((name, text.encode()) for name, text in written.items())
    noise = random.Random(1).randbytes(4096)
    files.update(("noise." + ending, noise) for ending in ENDINGS)
    for name, content in files.items():
        with open(os.path.join(folder, name), "wb") as stream:
            stream.write(content)
    os.mkdir(os.path.join(folder, "folder.vtk"))
    os.mkfifo(os.path.join(folder, "pipe.vtk"))
    os.symlink("loop.vtk", os.path.join(folder, "loop.vtk"))
