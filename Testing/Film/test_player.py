#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Films and stills in a player of panoramas: what it shows is what a plain perspective of VTK shows of
the same scene. The player knows the layout and the part of the sphere from the file's metadata.

    test_player.py WIDEFOV-RENDER [FOLDER]      FOLDER: keeps the pictures
"""

import math
import os
import shutil
import sys

import numpy
from matplotlib.image import imread
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingFreeType import vtkVectorText

import player
from films import FilmTest, exif, main, probe

KEPT = sys.argv[2] if len(sys.argv) > 2 else None
SKIPPED = 77  # what CTest takes for that
SIZE = 200  # pixels of a side of what the player shows
ANGLE = 90  # degrees across it
WORDS = {"AHEAD": 0, "RIGHT": 90, "BEHIND": 180, "LEFT": 270}  # degrees to the right
IPD = 0.2
POST = 1.5  # how far ahead it stands
SKY = 0.7  # it has more blue than all else
YELLOW = 0.3  # so much more red than blue have the post and the words alone
WRONG = 0.02  # of pixels, at edges: the film has half as many of them, and fewer for its colours
SHOT = {"angle": ANGLE, "azimuth": 0, "left": 0, "top": 0, "layout": "", "eye": "left"}


def coloured(data, value):
    heat = vtkFloatArray()
    heat.SetName("heat")
    for _ in range(data.GetNumberOfPoints()):
        heat.InsertNextValue(value)
    data.GetPointData().SetScalars(heat)
    return data


def moved(source, *steps):
    transform = vtkTransform()
    transform.PostMultiply()
    for name, values in steps:
        getattr(transform, name)(*values)
    change = vtkTransformPolyDataFilter()
    change.SetInputConnection(source.GetOutputPort())
    change.SetTransform(transform)
    change.Update()
    return change.GetOutput()


def word(text, azimuth):
    """Before the eye, which is at the origin, and facing it."""
    source = vtkVectorText()
    source.SetText(text)
    source.Update()
    bounds = source.GetOutput().GetBounds()
    middle = [-0.5 * (bounds[0] + bounds[1]), 0.2, 0]
    return coloured(moved(source, ("Translate", middle), ("Scale", (0.5, 0.5, 1)),
                          ("Translate", (0, 0, -2)), ("RotateY", [-azimuth])), 1)


def rectangle(width, height, *steps):
    source = vtkPlaneSource()
    source.SetOrigin(-width / 2, -height / 2, 0)
    source.SetPoint1(width / 2, -height / 2, 0)
    source.SetPoint2(-width / 2, height / 2, 0)
    return coloured(moved(source, *steps), 0)


def write_scene(path):
    """Words on all sides above a floor, and a post ahead, nearer than they."""
    scene = vtkAppendPolyData()
    for text, azimuth in WORDS.items():
        scene.AddInputData(word(text, azimuth))
    scene.AddInputData(rectangle(2000, 2000, ("RotateX", [-90]), ("Translate", (0, -1, 0))))
    scene.AddInputData(coloured(rectangle(0.1, 0.5, ("Translate", (0, -0.35, -POST))), 1))
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(scene.GetOutputPort())
    writer.Write()


def still_part(path):
    """What a still's metadata say of its layout and of the part of the sphere that it shows."""
    fields = exif(path)
    mode = fields.get("XMP-GSpherical:StereoMode", "")
    group = "XMP-GSpherical:" if mode else "XMP-GPano:"
    left, width, top, height = (fields[group + name] for name in (
        "CroppedAreaLeftPixels", "FullPanoWidthPixels", "CroppedAreaTopPixels", "FullPanoHeightPixels"))
    layouts = {"": "", "top-bottom": "top and bottom", "left-right": "side by side"}
    return {"layout": layouts[mode], "left": left / width, "top": top / height}


def film_part(path):
    """The same of a film."""
    stream = probe(path)
    data = {part["side_data_type"]: part for part in stream["side_data_list"]}
    bounds = {side: data["Spherical Mapping"].get("bound_" + side, 0)
              for side in ("left", "right", "top", "bottom")}
    return {"layout": data.get("Stereo 3D", {}).get("type", ""),
            "left": bounds["left"] / (stream["width"] + bounds["left"] + bounds["right"]),
            "top": bounds["top"] / (stream["height"] + bounds["top"] + bounds["bottom"])}


def shapes(picture):
    """Sky, and what is yellow; VTK's light comes from ahead, that of a panorama along each ray."""
    yellow = picture[:, :, 0] - picture[:, :, 2] > YELLOW
    return numpy.stack([picture[:, :, 2] > SKY, yellow])


class Player(FilmTest):
    def draw(self, *words):
        write_scene(self.path("words.vtp"))
        done = self.run_film("words.vtp", "--eye", "0,0,0", "--range", "0,1", "--colormap", "viridis",
                             "--no-scalar-bar", "--background", "0.6,0.8,1", *words)
        self.assertEqual(done.returncode, 0, done.stderr)

    def perspective(self, azimuth):
        """As VTK draws it, without a panorama."""
        name = "perspective-%d.png" % (azimuth % 360)
        if os.path.exists(self.path(name)):
            return imread(self.path(name))[:, :, :3]
        turn = math.radians(azimuth)
        size = "%dx%d" % (SIZE, SIZE)
        self.draw("--projection", "perspective", "--hfov", str(ANGLE), "--vfov", str(ANGLE), "--size", size,
                  "--direction", "%g,0,%g" % (math.sin(turn), -math.cos(turn)), "-o", name)
        return imread(self.path(name))[:, :, :3]

    def play(self, views):
        """Name -> picture of what the player shows."""
        wrong = player.play(self.folder, SIZE, views)
        self.assertIsNone(wrong)
        if KEPT:
            os.makedirs(KEPT, exist_ok=True)
            for name in views:
                shutil.copy(self.path(name + ".png"), KEPT)
        return {name: imread(self.path(name + ".png"))[:, :, :3] for name in views}

    def assert_shows(self, picture, azimuth, name):
        """What is there in that direction, upright and not mirrored, with a level horizon."""
        found = shapes(picture)
        wanted = shapes(self.perspective(azimuth))
        others = {"mirrored": wanted[:, :, ::-1], "upside down": wanted[:, ::-1],
                  "of another side": shapes(self.perspective(azimuth + 90))}
        off = (found != wanted).mean()
        self.assertLess(off, WRONG, name)
        for kind, other in others.items():
            self.assertLess(2 * off, (found != other).mean(), "%s is %s" % (name, kind))
        lowest = SIZE - 1 - found[0, ::-1].argmax(axis=0)
        self.assertLessEqual(abs(lowest - (SIZE / 2 - 1)).max(), 1.5, name + ": the horizon is not level")

    def assert_eye(self, picture, eye, name):
        """Rays of an eye touch a circle, so the left one sees the post ahead farther right."""
        off = math.asin(0.5 * IPD / POST)
        wanted = 0.5 * SIZE * math.tan(off if eye == "left" else -off)
        post = shapes(picture)[1, SIZE // 2 + 8:]
        columns = numpy.nonzero(post)[1] + 0.5 - 0.5 * SIZE
        self.assertGreater(len(columns), 50, name)
        self.assertLess(abs(columns.mean() - wanted), 1, name)

    def test_one_eye(self):
        """A film that turns to the right by a quarter, in two containers, and a still of a part."""
        turn = ["--film", "turn", "--sweep", "90", "--seconds", "0.5", "--fps", "4"]
        self.draw(*turn, "--size", "720x360", "-o", "film.mp4", "-o", "film.webm")
        self.draw("--size", "600x240", "--hfov", "300", "--vfov", "120", "-o", "part.jpg")
        views = {}
        for name, azimuth in WORDS.items():
            views[name.lower()] = dict(SHOT, file="film.mp4", azimuth=azimuth, time=0)
        views["webm"] = dict(SHOT, file="film.webm", time=0)
        views["turned"] = dict(SHOT, file="film.mp4", time=0.4)
        views["part"] = {**SHOT, "file": "part.jpg", "azimuth": 90, **still_part(self.path("part.jpg"))}
        pictures = self.play(views)
        self.assertEqual(film_part(self.path("film.mp4")), {"layout": "", "left": 0, "top": 0})
        for name, picture in pictures.items():
            self.assert_shows(picture, 90 if name == "turned" else views[name]["azimuth"], name)

    def test_two_eyes(self):
        """Films and a still in every layout; each eye sees what is its own."""
        eyes = ["--stereo", "omnidirectional", "--ipd", str(IPD), "--layout"]
        film = ["--film", "turn", "--sweep", "1", "--seconds", "0.1", "--fps", "10"]
        half = ["--size", "360x360", "--hfov", "180", "--vfov", "180"]
        whole = ["--size", "720x360"]
        self.draw(*film, *eyes, "top-bottom", *whole, "-o", "top-bottom.mp4")
        self.draw(*film, *eyes, "side-by-side", *whole, "-o", "side-by-side.webm")
        self.draw(*film, *eyes, "vr180", *half, "-o", "vr180.mp4")
        self.draw(*eyes, "top-bottom", *whole, "-o", "still.jpg")
        views = {}
        for file in ("top-bottom.mp4", "side-by-side.webm", "vr180.mp4", "still.jpg"):
            still = file == "still.jpg"
            part = still_part(self.path(file)) if still else {**film_part(self.path(file)), "time": 0}
            for eye in ("left", "right"):
                views[file.split(".")[0] + "-" + eye] = {**SHOT, "file": file, "eye": eye, **part}
        self.assertAlmostEqual(views["vr180-left"]["left"], 0.25, 2)
        for name, picture in self.play(views).items():
            self.assert_eye(picture, views[name]["eye"], name)


if __name__ == "__main__":
    if player.missing():
        print("skipped: the player needs the package " + player.missing())
        sys.exit(SKIPPED)
    main()
