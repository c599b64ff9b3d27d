# SPDX-License-Identifier: BSD-3-Clause
"""Small files of data: boxes, sheets, grids as legacy .vtk, glTF with materials."""

import base64
import json
import math
import struct
import zlib

import numpy

# Corners of a box by their bits (x, y, z), and its sides wound to be seen from outside.
SIDES = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]


def box(center, size, inward=False):
    """Points and quadrilaterals."""
    points = [
        [c + s * ((i >> axis & 1) - 0.5) for axis, (c, s) in enumerate(zip(center, size))]
        for i in range(8)
    ]
    return points, [side[::-1] if inward else side for side in SIDES]


def joined(*meshes):
    points, faces = [], []
    for more, sides in meshes:
        faces += [[len(points) + i for i in side] for side in sides]
        points += more
    return points, faces


def octahedron(inward):
    points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    return points, [face[::-1] if inward else face for face in faces]


def sphere(rows=8):
    """Of few faces, without normals."""
    points, faces = [[0, 0, 1], [0, 0, -1]], []
    for i in range(1, rows):
        for j in range(2 * rows):
            a, b = math.pi * i / rows, math.pi * j / rows
            points.append([math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), math.cos(a)])
    for i in range(rows - 2):
        for j in range(2 * rows):
            k = 2 + 2 * rows * i
            n = (j + 1) % (2 * rows)
            faces.append([k + j, k + 2 * rows + j, k + 2 * rows + n, k + n])
    return points, faces


def sheet(count=8):
    """A square in the plane of x and y, hilly."""
    points = [
        [x, y, 0.2 * math.sin(3 * x + y)]
        for y in numpy.linspace(-2, 2, count) for x in numpy.linspace(-2, 2, count)
    ]
    faces = [
        [i + j * count, i + 1 + j * count, i + 1 + (j + 1) * count, i + (j + 1) * count]
        for j in range(count - 1) for i in range(count - 1)
    ]
    return points, faces


def _numbers(values):
    return " ".join("%.9g" % value for value in numpy.ravel(values)) + "\n"


def _array(name, values):
    values = numpy.asarray(values, float)
    if values.ndim == 2:
        return "VECTORS %s float\n%s" % (name, _numbers(values))
    return "SCALARS %s float\nLOOKUP_TABLE default\n%s" % (name, _numbers(values))


def legacy(mesh, **arrays):
    points, faces = mesh
    text = "# vtk DataFile Version 3.0\nfirst\nASCII\nDATASET POLYDATA\nPOINTS %d float\n" % len(points)
    text += _numbers(points) + "POLYGONS %d %d\n" % (len(faces), sum(1 + len(f) for f in faces))
    text += "".join("%d %s" % (len(face), _numbers(face)) for face in faces)
    if arrays:
        text += "POINT_DATA %d\n" % len(points)
    return text + "".join(_array(name, values) for name, values in arrays.items())


def _xml_array(name, values):
    values = numpy.asarray(list(values))
    kind = "UInt8" if values.ndim == 2 else "Float32"
    return '<DataArray type="%s" Name="%s" NumberOfComponents="%d" format="ascii">%s</DataArray>' % (
        kind, name, values.shape[1] if values.ndim == 2 else 1, _numbers(values))


def xml_surface(mesh, place="PointData", **arrays):
    """A .vtp file; rows of numbers are bytes."""
    points, faces = mesh
    if not points:
        return '<VTKFile type="PolyData"><PolyData><Piece NumberOfPoints="0"><Points/></Piece></PolyData></VTKFile>'
    whole = '<DataArray type="Int32" Name="%s" format="ascii">%s</DataArray>'
    return ('<VTKFile type="PolyData"><PolyData><Piece NumberOfPoints="%d" NumberOfPolys="%d"><%s>%s</%s><Points>'
            '<DataArray type="Float32" NumberOfComponents="3" format="ascii">%s</DataArray></Points><Polys>%s%s'
            "</Polys></Piece></PolyData></VTKFile>") % (
                len(points), len(faces), place, "".join(_xml_array(*item) for item in arrays.items()), place,
                _numbers(points), whole % ("connectivity", _numbers([i for face in faces for i in face])),
                whole % ("offsets", _numbers(numpy.cumsum([len(face) for face in faces]))))


def blocks(*names):
    sets = "".join('<DataSet index="%d" file="%s"/>' % item for item in enumerate(names))
    return ('<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>%s'
            "</vtkMultiBlockDataSet></VTKFile>" % sets)


def image_of_ball(cells, count=13):
    """1 inside of a ball, 0 elsewhere, at the points or in the cells of an image."""
    line = numpy.linspace(-1, 1, count)
    z, y, x = numpy.meshgrid(line, line, line, indexing="ij")
    return "# vtk DataFile Version 3.0\nfirst\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS %d %d %d\n" % (
        3 * (count + cells,)) + "ORIGIN -1 -1 -1\nSPACING 0.2 0.2 0.2\n%s_DATA %d\n" % (
            "CELL" if cells else "POINT", x.size) + _array("density", (x * x + y * y + z * z < 0.5).ravel())


def grid(count=7, kind="STRUCTURED_POINTS", layer=False):
    """A cube of points from -1 to 1: `height`, its y or 1 in a layer in the middle, and `swirl`,
    vectors round that axis."""
    line = numpy.linspace(-1, 1, count)
    z, y, x = numpy.meshgrid(line, line, line, indexing="ij")
    text = "# vtk DataFile Version 3.0\nfirst\nASCII\nDATASET %s\nDIMENSIONS %d %d %d\n" % (
        kind, count, count, count)
    if kind == "STRUCTURED_POINTS":
        text += "ORIGIN -1 -1 -1\nSPACING %g %g %g\n" % (3 * (2 / (count - 1),))
    else:
        text += "POINTS %d float\n" % x.size
        text += _numbers(numpy.stack([x, y, z], axis=-1))
    height = y == line[count // 2] if layer else y
    vectors = numpy.stack([z, 0 * y, -x], axis=-1).reshape(-1, 3)
    return text + "POINT_DATA %d\n" % x.size + _array("height", height.ravel()) + _array("swirl", vectors)


def _png(rows):
    """A picture of 8-bit RGB."""
    height, width = len(rows), len(rows[0])
    raw = b"".join(b"\0" + bytes(value for pixel in row for value in pixel) for row in rows)
    parts = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)),
             (b"IDAT", zlib.compress(raw)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        for name, data in parts)


def _uri(kind, data):
    return "data:%s;base64,%s" % (kind, base64.b64encode(data).decode())


def gltf():
    """Two squares that look to +z: the left one has a texture, red above and blue below, the right
    one, moved there by its node, is green."""
    corners = numpy.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], "<f4")
    normals = numpy.array(4 * [[0, 0, 1]], "<f4")
    places = numpy.array([[0, 1], [1, 1], [1, 0], [0, 0]], "<f4")  # from the upper left corner
    triangles = numpy.array([0, 1, 2, 0, 2, 3], "<u2")
    parts = [array.tobytes() for array in (corners, normals, places, triangles)]
    starts = numpy.cumsum([0] + [len(part) for part in parts])
    views = [
        {"buffer": 0, "byteOffset": int(start), "byteLength": len(part)}
        for start, part in zip(starts, parts)
    ]
    kinds = [(5126, 4, "VEC3"), (5126, 4, "VEC3"), (5126, 4, "VEC2"), (5123, 6, "SCALAR")]
    accessors = [
        {"bufferView": i, "componentType": kind, "count": count, "type": name}
        for i, (kind, count, name) in enumerate(kinds)
    ]
    accessors[0].update(min=[-1, -1, 0], max=[1, 1, 0])
    picture = _png(4 * [4 * [(255, 0, 0)]] + 4 * [4 * [(0, 0, 255)]])
    plain = {"metallicFactor": 0, "roughnessFactor": 1}
    part = {"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3}
    return json.dumps({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0}, {"mesh": 1, "translation": [2.5, 0, 0]}],
        "meshes": [{"primitives": [{**part, "material": i}]} for i in (0, 1)],
        "materials": [
            {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, **plain}},
            {"pbrMetallicRoughness": {"baseColorFactor": [0, 1, 0, 1], **plain}},
        ],
        "textures": [{"source": 0}],
        "images": [{"uri": _uri("image/png", picture)}],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": int(starts[-1]),
                     "uri": _uri("application/octet-stream", b"".join(parts))}],
    })
