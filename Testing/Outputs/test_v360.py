#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""FFmpeg's filter v360 as an independent witness: the same picture of all directions in the same map, drawn
here and converted there.

    test_v360.py WIDEFOV_RENDER
"""

import sys
import unittest

import numpy

from all_directions import LEVELS, SkyTest, read_picture, read_ppm, run

RENDER = sys.argv[1]

# Part of the pixels that may differ more: those on the borders of circles and faces, which belong to one side.
BESIDE_BORDERS = 0.02

# Names and options of a map: here, its size, and there.
MAPS = {
    "fisheye": ("azimuthal-equidistant --fov 180", "256x256", "fisheye:h_fov=180:v_fov=180"),
    "equisolid": ("azimuthal-equal-area --fov 180", "256x256", "equisolid:h_fov=180:v_fov=180"),
    "stereographic": ("stereographic --fov 180", "256x256", "sg:h_fov=180:v_fov=180"),
    "flat": ("gnomonic --fov 90 --circle 128,128,128", "256x256", "flat:h_fov=90:v_fov=90"),
    "dual fisheye": ("direction-map --direction-map dual-fisheye", "512x256", "dfisheye:h_fov=180:v_fov=180"),
    "faces 3x2": ("direction-map --direction-map cube-3x2", "384x256", "c3x2"),
    "faces 6x1": ("direction-map --direction-map cube-6x1", "768x128", "c6x1"),
}


class Maps(SkyTest):
    def drawn(self, words, size):
        path = self.path("drawn.png")
        run(RENDER, self.path("speck.obj"), "--sky", self.sky, "--eye", "0,0,0", "--samples", "0",
            "--background", "0,0,0", "--projection", *words.split(), "--size", size, "-o", path)
        return read_picture(path)

    def converted(self, output, size):
        width, height = size.split("x")
        path = self.path("converted.ppm")
        run("ffmpeg", "-v", "error", "-y", "-i", self.sky, "-vf",
            "format=gbrp,v360=e:%s:w=%s:h=%s:interp=linear,format=rgb24" % (output, width, height), path)
        return read_ppm(path)

    def check(self, words, size, output):
        ours = self.drawn(words, size)
        theirs = self.converted(output, size)
        self.assertEqual(ours.shape, theirs.shape)
        # v360 fills the corners beside some maps with what is nearest; here they are black
        inside = ours.any(axis=2)
        self.assertGreater(inside.mean(), 0.6)
        off = abs(ours - theirs).max(axis=2) > LEVELS
        worst = numpy.argwhere(off & inside)
        self.assertLess((off & inside).mean(), BESIDE_BORDERS,
                        "first of them at %s" % (worst[:1][:, ::-1].tolist(),))


def add(name, arguments):
    def test(self):
        self.check(*arguments)

    setattr(Maps, "test_" + name.replace(" ", "_"), test)


for title, row in MAPS.items():
    add(title, row)

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
