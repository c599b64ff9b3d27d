# SPDX-License-Identifier: BSD-3-Clause
"""Calibrations of projectors and displays that cannot be: the files, and the rows that name them. What
their readers say of each format is in the unit tests."""

DONE, FAILED, USAGE = 0, 1, 2

MESH = "2\n2 2\n-1 -1 0 0 1\n1 -1 1 0 1\n-1 1 0 1 1\n1 1 1 1 1\n"


def display(more="", name="a"):
    return (
        '{ "surface": { "type": "sphere", "radius": 5 }, "projectors": [ { "name": "%s", "size": [32, 32], '
        '"lens": { "position": [0, 0, 0], "direction": [0, 0, -1], "throw-ratio": 1 } %s } ] }' % (name, more)
    )


def projector_files():
    """File name -> text."""
    return {
        "mesh.data": MESH,
        "cut.data": MESH[:-12],
        "folds.data": MESH.replace("-1 1 0 1 1", "3 1 0 1 1"),
        "outside.mpcdi.xml": '<MPCDI profile="2d" version="2.0"><display><buffer><region id="a" xResolution="2" '
        'yResolution="2"/></buffer></display><files><fileset region="a"><geometryWarpFile>'
        "<path>../secret.pfm</path></geometryWarpFile></fileset></files></MPCDI>",
        "one.json": display(),
        "word.json": display(', "gama": 2'),
        "cut.json": display()[:-5],
        "slash.json": display(name="../a"),
    }


FISHEYE = "--projection azimuthal-equidistant --fov 180 --size 32x32 "

# Behind good.vtk on the command line; the exit code; what the one line must hold.
PROJECTORS = [
    (FISHEYE + "--warp mesh.data", DONE, None),
    ("--warp mesh.data --projection equirectangular --size 32x32", DONE, None),
    (FISHEYE + "--warp cut.data", FAILED, "cut.data"),
    (FISHEYE + "--warp folds.data", FAILED, "folds"),
    (FISHEYE + "--warp missing.data", FAILED, "missing.data"),
    (FISHEYE + "--warp pipe.vtk", FAILED, "pipe.vtk"),
    (FISHEYE + "--warp mesh.data --projector b", FAILED, "leave b out"),
    ("--warp outside.mpcdi.xml", FAILED, "points outside"),
    (FISHEYE + "--warp mesh.data --projector-gamma 0", USAGE, "--projector-gamma"),
    ("--warp mesh.data --screens cave.pvx", USAGE, "rooms"),
    ("--warp mesh.data --display one.json", USAGE, "exclude each other"),
    ("--warp mesh.data --direction-map cube-3x2", USAGE, "--direction-map"),
    ("--display one.json --projection hammer", USAGE, "--projection"),
    ("--display one.json --aov {out}/data.exr", USAGE, "--aov"),
    ("--display one.json --projector b", FAILED, "no projector b"),
    ("--display word.json", FAILED, "projectors[0] has the unknown word 'gama'"),
    ("--display cut.json", FAILED, "line 1"),
    ("--display slash.json", FAILED, "slash"),
    ("--display missing.json", FAILED, "missing.json"),
    ("--projector a", USAGE, "--projector goes with"),
]
