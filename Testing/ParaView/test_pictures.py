# SPDX-License-Identifier: BSD-3-Clause
"""Pictures as files: larger than the window, of one eye and of two, with metadata, numbered;
by ParaView's screenshots and animations, the exporter and the extractor."""

import json
import os
import re
import shutil
import subprocess

from paraview import simple

import pixels
import scene

# Larger than the window, so drawn in tiles.
PANORAMA = [480, 240]
DOME = [300, 300]

GPANO = re.compile(rb'GPano:(\w+)="([^"]*)"')

# What exiftool reads of two eyes in one file, of all the sphere and of a part.
BOTH = {"ProjectionType": "equirectangular", "Spherical": True, "FullPanoWidthPixels": 480,
        "FullPanoHeightPixels": 240, "CroppedAreaLeftPixels": 0}
PART = {"FullPanoWidthPixels": 960, "FullPanoHeightPixels": 480, "CroppedAreaImageWidthPixels": 480,
        "CroppedAreaImageHeightPixels": 240, "CroppedAreaLeftPixels": 240, "CroppedAreaTopPixels": 120}


def read(path):
    with open(path, "rb") as file:
        return file.read()


def check_eye(options, view, mesh, picture, side, name):
    scene.require(scene.keeps_promise(options, view, mesh, picture, 3000, side), name)


def read_gpano(path):
    """The fields of the packet, where readers look for it."""
    data = read(path)
    if path.endswith(".png"):
        at = data.find(b"iTXtXML:com.adobe.xmp\0\0\0\0\0")
    else:
        at = data.find(b"http://ns.adobe.com/xap/1.0/\0")
        if at >= 0:
            scene.require(data[at - 4:at - 2] == b"\xff\xe1", "the segment is no APP1")
    return {} if at < 0 else {k.decode(): v.decode() for k, v in GPANO.findall(data)}


def exif(path, group):
    """The fields as exiftool reads them, by the system's libraries instead of ParaView's."""
    words = ["exiftool", "-j", "-n", "-XMP-%s:all" % group, path]
    clean = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
    return json.loads(subprocess.run(words, stdout=subprocess.PIPE, env=clean, check=True).stdout)[0]


def check_exif(path, group, expected):
    found = exif(path, group)
    wrong = {name: found.get(name) for name in expected if found.get(name) != expected[name]}
    scene.require(not wrong, "%s, by exiftool: %s" % (path, wrong))


def check_metadata(options, view):
    """All the sphere, a part of it, and pictures that are no photo spheres."""
    for name, hfov, expected in (("whole.png", 360, (480, 0)), ("half.jpg", 180, (960, 240))):
        view.HorizontalFieldOfView = hfov
        path = os.path.join(options.output, name)
        simple.ExportView(path, view, Size=PANORAMA)
        fields = read_gpano(path)
        print(name, fields)
        scene.require(fields["ProjectionType"] == "equirectangular", name)
        found = int(fields["FullPanoWidthPixels"]), int(fields["CroppedAreaLeftPixels"])
        scene.require(found == expected, str(found))
        scene.require(fields["CroppedAreaImageWidthPixels"] == str(PANORAMA[0]), name)
    view.VerticalFieldOfView = 90
    for name in ("part.png", "part.jpg"):
        simple.ExportView(os.path.join(options.output, name), view, Size=PANORAMA)
        check_exif(os.path.join(options.output, name), "GPano", PART)
    both = os.path.join(options.output, "both.jpg")
    simple.ExportView(both, view, Size=[480, 480], Eyes="Left above right")
    check_exif(both, "GSpherical", dict(PART, StereoMode="top-bottom"))
    view.HorizontalFieldOfView = 360
    view.VerticalFieldOfView = 180
    plain = os.path.join(options.output, "plain.png")
    simple.ExportView(plain, view, Size=PANORAMA, Metadata=0)
    scene.require(not read_gpano(plain), "metadata that nobody asked for")


def check_eyes(options, view, mesh):
    """Both eyes in one file are the two files of one eye each."""
    view.InterpupillaryDistance = 0.5
    path = os.path.join(options.output, "eye.png")
    simple.ExportView(path, view, Size=PANORAMA, Eyes="A file each, in folders left and right")
    eyes = [os.path.join(options.output, side, "eye.png") for side in ("left", "right")]
    scene.require(not os.path.exists(path), "a third file")
    for eye, side in zip(eyes, (-1, 1)):
        check_eye(options, view, mesh, eye, side, eye)
        scene.require(read_gpano(eye), "an eye's panorama without metadata")
    left, right = (pixels.read_rows(eye) for eye in eyes)
    below, beside = ([os.path.join(options.output, n) for n in ("below.png", "beside.png")])
    simple.ExportView(below, view, Size=[480, 480], Eyes="Left above right")
    scene.require(pixels.read_rows(below) == right + left, "rows count from the bottom")
    scene.require(not read_gpano(below), "two eyes are no photo sphere")
    check_exif(below, "GSpherical", dict(BOTH, StereoMode="top-bottom"))
    simple.ExportView(beside, view, Size=[960, 240], Eyes="Side by side")
    scene.require(
        pixels.read_rows(beside) == [l + r for l, r in zip(left, right)], "side by side"
    )
    check_exif(beside, "GSpherical", dict(BOTH, StereoMode="left-right"))
    view.Tilt = 30
    simple.ExportView(beside, view, Size=[960, 240], Eyes="Side by side")
    scene.require(len(exif(beside, "GSpherical")) == 1, "two eyes that look up have metadata")
    simple.ExportView(path, view, Size=PANORAMA, Eyes="Left")
    check_exif(path, "GPano", {"PosePitchDegrees": 30})
    view.Tilt = 0


def check_dome(options, view, mesh):
    view.Projection = "azimuthal-equidistant"
    view.HorizontalFieldOfView = 180
    view.Tilt = 90
    dome = os.path.join(options.output, "dome.png")
    simple.ExportView(dome, view, Size=DOME)
    check_eye(options, view, mesh, dome, 0, "dome")
    scene.require(not read_gpano(dome), "a dome is no photo sphere")


def check_frames(options, view, mesh):
    """Numbered frames of each eye by the extractor; by an animation the same pictures."""
    folder = os.path.join(options.output, "extracts")
    extractor = simple.CreateExtractor("WideFoVPicture", view)
    extractor.Writer.Size = DOME
    extractor.Writer.Eyes = "A file each, in folders left and right"
    scenes = simple.GetAnimationScene()
    scenes.NumberOfFrames = 3
    scene.save_extracts(folder, 3)
    frames = ["WideFoVView1_%06d.png" % i for i in range(3)]
    for side in ("left", "right"):
        found = sorted(os.listdir(os.path.join(folder, side)))
        scene.require(found == frames, side + ": " + str(found))
    check_eye(options, view, mesh, os.path.join(folder, "right", frames[2]), 1, "frame")
    simple.SaveAnimation(os.path.join(options.output, "movie.png"), view, ImageResolution=DOME,
                         StereoMode="Both Eyes", SuffixFormat=".%04d", FrameWindow=[0, 2])
    movie = sorted(n for n in os.listdir(options.output) if n.startswith("movie"))
    print(movie)
    expected = ["movie.%04d_%s.png" % (i, s) for i in range(3) for s in ("left", "right")]
    scene.require(movie == expected, str(movie))
    rows = [pixels.read_rows(os.path.join(*p)) for p in (
        (options.output, movie[0]), (folder, "left", frames[0]))]
    scene.require(rows[0] == rows[1], "the movie shows another dome")


def check_refused(options, view):
    """What cannot be written is said, and leaves no file."""
    odd = os.path.join(options.output, "odd.png")
    simple.ExportView(odd, view, Size=[480, 241], Eyes="Left above right")
    inside = os.path.join(options.output, "dome.png", "inside.png")
    simple.ExportView(inside, view, Size=DOME)
    scene.require(not os.path.exists(odd) and not os.path.exists(inside), "a file")


def main(options):
    shutil.rmtree(options.output)
    os.makedirs(options.output)
    scene.load_plugin(options)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    view = scene.make_view(Technique="Exact")  # of which every pixel is known
    scene.show_cells(scene.spread(simple.XMLPolyDataReader(FileName=[mesh])), view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    check_metadata(options, view)
    check_eyes(options, view, mesh)
    check_dome(options, view, mesh)
    check_frames(options, view, mesh)
    check_refused(options, view)


scene.run(main)
