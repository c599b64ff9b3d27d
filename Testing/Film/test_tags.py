#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How players recognise films: metadata of every layout and container, read by ffprobe and exiftool.

    test_tags.py WIDEFOV-RENDER
"""

from films import FilmTest, exif, main, side_data

FILM = ["--film", "turn", "--seconds", "0.08"]
EYES = ["--stereo", "omnidirectional", "--ipd", "0.3", "--layout"]
HALF = ["--hfov", "180", "--vfov", "180", "--size", "32x32"]

# layout -> what ffprobe calls it
STEREO = {"top-bottom": "top and bottom", "side-by-side": "side by side", "vr180": "side by side"}


class Tags(FilmTest):
    def check(self, name, layout, *words):
        eyes = [*EYES, layout] if layout else []
        self.assertEqual(self.film(*FILM, *eyes, *words, "-o", name), "")
        found = side_data(self.path(name))
        if layout:
            self.assertEqual(found["Stereo 3D"]["type"], STEREO[layout], name)
        else:
            self.assertNotIn("Stereo 3D", found)
        return found

    def assert_whole(self, found):
        sphere = found["Spherical Mapping"]
        self.assertEqual(sphere["projection"], "equirectangular")
        self.assertEqual([sphere.get(angle) for angle in ("yaw", "pitch", "roll")], [0, 0, 0])

    def assert_half(self, found):
        """A quarter of the whole sphere is missing on the left and on the right."""
        sphere = found["Spherical Mapping"]
        self.assertEqual(sphere["projection"], "tiled equirectangular")
        # ffprobe takes both eyes' width for that of one
        self.assertEqual([sphere["bound_" + side] for side in ("left", "top", "right", "bottom")],
                         [32, 0, 32, 0])

    def test_mp4(self):
        for layout in (None, "top-bottom", "side-by-side"):
            self.assert_whole(self.check("film.mp4", layout))
            read = exif(self.path("film.mp4"))
            self.assertEqual(read["XMP-GSpherical:ProjectionType"], "equirectangular")
            self.assertIs(read["XMP-GSpherical:Spherical"], True)
            mode = {None: None, "side-by-side": "left-right"}.get(layout, layout)
            self.assertEqual(read.get("XMP-GSpherical:StereoMode"), mode)

    def test_vr180(self):
        self.assert_half(self.check("film.mp4", "vr180", *HALF))
        read = exif(self.path("film.mp4"))
        self.assertEqual(read["XMP-GSpherical:FullPanoWidthPixels"], 64)
        self.assertEqual(read["XMP-GSpherical:CroppedAreaImageWidthPixels"], 32)
        self.assertEqual(read["XMP-GSpherical:CroppedAreaLeftPixels"], 16)

    def test_mov(self):
        self.assert_whole(self.check("film.mov", "top-bottom"))
        self.assert_whole(self.check("film.mov", None, "--codec", "x265"))
        self.assertEqual(exif(self.path("film.mov"))["XMP-GSpherical:ProjectionType"], "equirectangular")

    def test_matroska(self):
        self.assert_whole(self.check("film.webm", "top-bottom"))
        self.assert_half(self.check("film.webm", "vr180", *HALF))
        self.assert_whole(self.check("film.mkv", None))
        tag = [value for name, value in exif(self.path("film.webm")).items() if "spherical" in name.lower()]
        self.assertIn("<GSpherical:Spherical>true", str(tag))

    def test_others_have_none(self):
        self.film(*FILM, "--projection", "azimuthal-equidistant", "--fov", "180", "--size", "32x32",
                  "-o", "dome.mp4")
        self.assertEqual(side_data(self.path("dome.mp4")), {})
        self.assertNotIn("XMP-GSpherical:Spherical", exif(self.path("dome.mp4")))


if __name__ == "__main__":
    main()
