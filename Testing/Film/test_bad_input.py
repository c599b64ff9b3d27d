#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How films fail: one line, an exit code, nothing half done, finished frames kept.

    test_bad_input.py WIDEFOV-RENDER
"""

import io
import os
import resource
import shutil

import numpy
from matplotlib.image import imsave

from films import SQUARE, FilmTest, main, words_of

TURN = ["--film", "turn", "--seconds", "0.2"]
MP4 = ["-o", "film.mp4"]


def sky():
    """A picture of all directions: two pixels."""
    stream = io.BytesIO()
    imsave(stream, numpy.zeros((1, 2, 3)), format="png")
    return stream.getvalue()


class BadInput(FilmTest):
    def refuse(self, code, says, *words, **more):
        before = sorted(os.listdir(self.folder))
        done = self.run_film(*words, **more)
        lines = words_of(done.stderr).splitlines()
        self.assertEqual((done.returncode, len(lines)), (code, 1), done.stderr)
        self.assertTrue(lines[0].startswith("widefov-render: "), lines)
        self.assertIn(says, lines[0])
        return sorted(set(os.listdir(self.folder)) - set(before))

    def test_usage(self):
        self.assertEqual(self.refuse(2, "--quality", *TURN, "--quality", "60", *MP4), [])
        self.assertEqual(self.refuse(2, "time", "--film", "time", *MP4), [])
        self.refuse(2, "does not go with --frames;", *TURN, "--frames", "2", *MP4)

    def test_before_anything_is_drawn(self):
        nowhere = {**os.environ, "PATH": self.folder}
        self.assertEqual(self.refuse(1, "ffmpeg", *TURN, *MP4, env=nowhere), [])
        self.write("ffmpeg", "#!/bin/sh\necho ' V....D libtheora  Theora'\n")
        os.chmod(self.path("ffmpeg"), 0o755)
        self.assertEqual(self.refuse(1, "x265", *TURN, "--codec", "x265", *MP4, env=nowhere), [])
        self.assertEqual(self.refuse(1, "nothing.wav", *TURN, "--audio", "nothing.wav", *MP4), [])
        self.write("text.wav", "no sound\n")
        self.assertEqual(self.refuse(1, "text.wav", *TURN, "--audio", "text.wav", *MP4), [])

    def test_inputs_stay(self):
        """No output overwrites what is read, whatever names it."""
        with open(self.path("sky.png"), "wb") as stream:
            stream.write(sky())
        os.mkdir(self.path("frames"))
        shutil.copy(self.path("sky.png"), self.path("frames/2.png"))
        os.link(self.path("sky.png"), self.path("hard.png"))
        os.symlink("sky.png", self.path("soft.png"))
        self.write("way.txt", "0 0 0 0 0 -1\n1 0 0 0 0 -1\n")
        self.write("square0.vtp", SQUARE.format(heat=0))
        self.write("all.vtm", '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet><DataSet index="0" '
                   'file="square0.vtp"/></vtkMultiBlockDataSet></VTKFile>')
        self.write("a.vtp.series", '{"files": [{"name": "square0.vtp"}]}')
        self.write("some.conf", "hfov = 90\n")
        for name in ("sky.png", "hard.png", "soft.png"):
            self.refuse(2, "is an input file", "--scene", "room", "--sky", "sky.png", "-o", name)
        self.refuse(1, "frames/2.png is an input file", *TURN, "--sky", "frames/2.png", "-o", "frames/%d.png")
        self.refuse(2, "way.txt is an input", "--film", "path", "--path", "way.txt", *MP4, "--stats", "way.txt")
        self.refuse(2, "film.mp4 is an input", *TURN, "--audio", "film.mp4", *MP4)
        self.refuse(2, "some.conf is an input", *TURN, "--config", "some.conf", *MP4, "--stats", "some.conf")
        for data in ("all.vtm", "a.vtp.series"):
            words = [data, "--eye", "0,0,0", "-o", "new.png", "--stats", "square0.vtp"]
            self.assertEqual(self.refuse(1, "square0.vtp is an input file", *words), [])
        self.assertEqual(self.refuse(1, "square0.vtp is an input file", "a.vtp.series", "--eye", "0,0,0", "--film",
                                     "time", *MP4, "--stats", "square0.vtp"), [])
        with open(self.path("sky.png"), "rb") as stream:
            self.assertEqual(stream.read(), sky())

    def test_paths_and_lists(self):
        self.write("way.txt", "0 0 0 0 0 -1\n0 0 0 0 0 x\n")
        self.assertEqual(self.refuse(1, "line 2", "--film", "path", "--path", "way.txt", *MP4), [])
        self.write("text.pvd", "time goes by\n")
        self.assertEqual(self.refuse(1, "text.pvd", "text.pvd", "--film", "time", *MP4), [])
        self.write("square0.vtp", SQUARE.format(heat=0))
        self.write("a.vtp.series", '{"files": [{"name": "square0.vtp"}]}')
        self.write("square1.vtp", SQUARE.format(heat=1))
        self.refuse(1, "the data have no array 'nought'; choose one of heat", "square%d.vtp", "--film", "time",
                    "--color-by", "nought", *MP4)
        # told by the ends, before what is between is read
        self.write("end0.vtp", SQUARE.format(heat=0))
        self.write("end1.vtp", "no data")
        self.write("end2.vtp", SQUARE.format(heat=2))
        self.refuse(1, "widefov-render: --color-by: the data have no array 'nought'", "end%d.vtp", "--film",
                    "time", "--color-by", "nought", *MP4)
        self.assertEqual(
            self.refuse(1, "both", "a.vtp.series", "square%d.vtp", "--film", "time", *MP4), [])

    def test_full_disk(self):
        """As full as a limit of a file's size makes it: after runs of frames, in the next one."""
        words = ["--film", "turn", "--seconds", "8", "--fps", "10", "--size", "128x64", "-o", "film.mov"]
        self.film(*words, "--part", "1/2")
        kept = os.listdir(self.path("film.mov.parts"))

        def limit(most):
            return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

        done = self.run_film(*words, "--part", "2/2", preexec_fn=limit(20000))
        self.assertEqual((done.returncode, len(words_of(done.stderr).splitlines())), (1, 1), done.stderr)
        self.assertIn("cannot be encoded", done.stderr)
        self.assertEqual(sorted(os.listdir(self.path("film.mov.parts"))), sorted(kept))
        self.assertEqual(self.film(*words, "--part", "2/2"), "")
        self.assertEqual(os.listdir(self.folder), ["film.mov"])
        frames = ["--film", "turn", "--seconds", "0.2", "-o", "frames/%05d.png"]
        self.refuse(1, "frames/00001.png", *frames, preexec_fn=limit(500))
        self.assertEqual(os.listdir(self.path("frames")), [])


if __name__ == "__main__":
    main()
