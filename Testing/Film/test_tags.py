#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How players recognise films: metadata of every layout and container, read by ffprobe and exiftool.

    test_tags.py WIDEFOV-RENDER
"""

import struct

from films import FilmTest, exif, main, side_data

FILM = ["--film", "turn", "--seconds", "0.08"]
EYES = ["--stereo", "omnidirectional", "--ipd", "auto", "--layout"]
HALF = ["--hfov", "180", "--vfov", "180", "--size", "32x32"]

ENDINGS = ("mp4", "mov", "webm", "mkv")

# layout -> what ffprobe calls it, and version 1
STEREO = {None: None, "top-bottom": "top and bottom", "side-by-side": "side by side",
          "side-by-side-half": "side by side", "vr180": "side by side"}
VERSION_1 = {"top-bottom": "top-bottom", "side-by-side": "left-right", "side-by-side-half": "left-right",
             "vr180": "left-right"}


# What version 2 says of half a sphere: top, bottom, left, right, shares of the whole, 0.32 fixed point.
HALF_BOUNDS = struct.pack(">4I", 0, 0, 1 << 30, 1 << 30)


class Tags(FilmTest):
    def check(self, layout, *words):
        """One film in every container; what ffprobe reads, container -> name -> fields."""
        eyes = [*EYES, layout] if layout else []
        outputs = [word for ending in ENDINGS for word in ("-o", "film." + ending)]
        self.assertEqual(self.film(*FILM, *eyes, *words, *outputs), "")
        found = {ending: side_data(self.path("film." + ending)) for ending in ENDINGS}
        for ending, data in found.items():
            self.assertEqual(data.get("Stereo 3D", {}).get("type"), STEREO[layout], ending)
        return found

    def assert_version_1(self, layout, **more):
        """In MP4 as exiftool reads it; in Matroska the same text is a tag."""
        want = {"ProjectionType": "equirectangular", "Spherical": True, "Stitched": True, **more}
        if layout:
            want["StereoMode"] = VERSION_1[layout]
        for ending in ("mp4", "mov"):
            read = {name[15:]: value for name, value in exif(self.path("film." + ending)).items()
                    if name.startswith("XMP-GSpherical:") and name[15:] != "StitchingSoftware"}
            self.assertEqual({name: read.get(name) for name in want}, want)
            self.assertEqual("StereoMode" in read, bool(layout))
        for ending in ("webm", "mkv"):
            tags = [str(value) for name, value in exif(self.path("film." + ending)).items()
                    if "spherical" in name.lower()]
            self.assertIn("<GSpherical:Spherical>true", " ".join(tags))

    def test_whole_spheres(self):
        for layout in (None, "top-bottom", "side-by-side"):
            for ending, found in self.check(layout).items():
                sphere = found["Spherical Mapping"]
                self.assertEqual(sphere["projection"], "equirectangular", ending)
                self.assertEqual([sphere.get(angle) for angle in ("yaw", "pitch", "roll")], [0, 0, 0])
            self.assert_version_1(layout)

    def test_vr180(self):
        """A quarter of the whole sphere is missing on the left and on the right."""
        for ending, found in self.check("vr180", *HALF).items():
            sphere = found["Spherical Mapping"]
            self.assertEqual(sphere["projection"], "tiled equirectangular", ending)
            # ffprobe takes both eyes' width for that of one, and rounds up
            for side, pixels in (("left", 32), ("top", 0), ("right", 32), ("bottom", 0)):
                self.assertLessEqual(abs(sphere["bound_" + side] - pixels), 1, ending)
            with open(self.path("film." + ending), "rb") as stream:
                self.assertIn(HALF_BOUNDS, stream.read(), ending)
        self.assert_version_1("vr180", FullPanoWidthPixels=64, CroppedAreaImageWidthPixels=32,
                              CroppedAreaLeftPixels=16)

    def test_tilted_spheres_are_turned(self):
        """By as much as the picture's middle is above the horizon, or below it."""
        for layout, tilt in ((None, 20), ("top-bottom", -31.5)):
            for ending, found in self.check(layout, "--tilt", str(tilt)).items():
                sphere = found["Spherical Mapping"]
                self.assertEqual([sphere.get(angle) for angle in ("yaw", "roll")], [0, 0], ending)
                self.assertLess(abs(sphere["pitch"] - tilt), 1, ending)  # ffprobe takes whole degrees
                if ending in ("mp4", "mov"):
                    with open(self.path("film." + ending), "rb") as stream:
                        header = stream.read().split(b"prhd")[1]
                    self.assertEqual(struct.unpack(">4i", header[:16]), (0, 0, int(65536 * tilt), 0))
        self.film(*FILM, "--tilt", "120", "-o", "head.mp4")  # on its head
        self.assertEqual(side_data(self.path("head.mp4")), {})

    def test_borders(self):
        """Of 150 by 90 degrees, two pixels a degree, from 60 to the left on: what is left out on each side."""
        part = ["--borders", "-60,90,-45,45"]
        crop = {"FullPanoWidthPixels": 720, "FullPanoHeightPixels": 360, "CroppedAreaLeftPixels": 240,
                "CroppedAreaTopPixels": 90, "CroppedAreaImageWidthPixels": 300, "CroppedAreaImageHeightPixels": 180}
        # shares of the whole, 0.32 fixed point
        bounds = struct.pack(">4I", 1 << 30, 1 << 30, *(int(share * 2**32) for share in (240 / 720, 180 / 720)))
        # an eye that is squeezed has half the columns
        half = {**crop, "FullPanoWidthPixels": 360, "CroppedAreaLeftPixels": 120, "CroppedAreaImageWidthPixels": 150}
        for layout, want in ((None, crop), ("side-by-side-half", half)):
            for ending, found in self.check(layout, *part, "--size", "300x180").items():
                self.assertEqual(found["Spherical Mapping"]["projection"], "tiled equirectangular", ending)
                with open(self.path("film." + ending), "rb") as stream:
                    self.assertIn(bounds, stream.read(), ending)
            self.assert_version_1(layout, **want)

    def test_others_have_none(self):
        self.film(*FILM, "--projection", "azimuthal-equidistant", "--fov", "180", "--size", "32x32",
                  "-o", "dome.mp4")
        self.assertEqual(side_data(self.path("dome.mp4")), {})
        self.assertNotIn("XMP-GSpherical:Spherical", exif(self.path("dome.mp4")))


if __name__ == "__main__":
    main()
