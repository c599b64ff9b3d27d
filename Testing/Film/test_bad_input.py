#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How films fail: one line, an exit code, nothing half done, finished frames kept.

    test_bad_input.py WIDEFOV-RENDER
"""

import os
import resource

from films import SQUARE, FilmTest, main

TURN = ["--film", "turn", "--seconds", "0.2"]
MP4 = ["-o", "film.mp4"]


class BadInput(FilmTest):
    def refuse(self, code, says, *words, **more):
        before = sorted(os.listdir(self.folder))
        done = self.run_film(*words, **more)
        lines = [line for line in done.stderr.splitlines() if " s)" not in line]
        self.assertEqual((done.returncode, len(lines)), (code, 1), done.stderr)
        self.assertTrue(lines[0].startswith("widefov-render: "), lines)
        self.assertIn(says, lines[0])
        return sorted(set(os.listdir(self.folder)) - set(before))

    def usage(self, says, *words):
        self.assertEqual(self.refuse(2, says, *words), [], words)

    def test_options(self):
        self.usage("--seconds", "--scene", "room", "--seconds", "3", "-o", "a.png")
        self.usage("--resume", "--scene", "room", "--resume", "-o", "a.png")
        self.usage("--film", "--film", "spiral", *MP4)
        self.usage("--path", "--film", "path", *MP4)
        self.usage("--path", *TURN, "--path", "way.txt", *MP4)
        self.usage("--vectors", "--film", "fly", *MP4)
        self.usage("time", "--film", "time", *MP4)
        self.usage("nothing to write", *TURN)
        self.usage("numbered frames", *TURN, "-o", "picture.png")
        self.usage("numbered frames", *TURN, "-o", "film.avi")
        self.usage(".png", *TURN, "-o", "frames/%05d.bmp")
        self.usage(".webm", *TURN, "--codec", "x264", "-o", "film.webm")
        self.usage("--quality", *TURN, "--quality", "60", *MP4)
        self.usage("--quality", *TURN, "--quality", "10", "-o", "film.mov")
        self.usage("even", *TURN, "--size", "63x32", *MP4)
        self.usage("--aov", *TURN, "--aov", "a.exr", *MP4)
        self.usage("--audio", *TURN, "--audio", "a.wav", "-o", "frames/%05d.png")
        for option, value in (("--seconds", "0"), ("--seconds", "nan"), ("--fps", "0"), ("--fps", "1/0"),
                              ("--fps", "fast"), ("--part", "3/2"), ("--part", "2"), ("--sweep", "inf"),
                              ("--quality", "-1")):
            self.usage(option, *TURN, option, value, *MP4)

    def test_before_anything_is_drawn(self):
        nowhere = {**os.environ, "PATH": self.folder}
        self.assertEqual(self.refuse(1, "ffmpeg", *TURN, *MP4, env=nowhere), [])
        self.write("ffmpeg", "#!/bin/sh\necho ' V....D libtheora  Theora'\n")
        os.chmod(self.path("ffmpeg"), 0o755)
        self.assertEqual(self.refuse(1, "x265", *TURN, "--codec", "x265", *MP4, env=nowhere), [])
        self.assertEqual(self.refuse(1, "nowhere", *TURN, "-o", "nowhere/film.mp4"), [])
        self.assertEqual(self.refuse(1, "nothing.wav", *TURN, "--audio", "nothing.wav", *MP4), [])
        self.write("text.wav", "no sound\n")
        self.assertEqual(self.refuse(1, "text.wav", *TURN, "--audio", "text.wav", *MP4), [])

    def test_paths(self):
        for text, says in (("", "no pose"), ("1 2 3\n", "line 1"), ("0 0 0 0 0 -1\n0 0 0 0 0 x\n", "line 2"),
                           ("0 0 0 0 0 0\n", "direction"), ("0 0 0 0 1 0 0 1 0\n", "up")):
            self.write("way.txt", text)
            self.assertEqual(self.refuse(1, says, "--film", "path", "--path", "way.txt", *MP4), [])
        self.assertEqual(self.refuse(1, "way.csv", "--film", "path", "--path", "way.csv", *MP4), [])

    def test_lists_of_steps(self):
        self.write("empty.pvd", "<VTKFile><Collection/></VTKFile>")
        self.write("text.pvd", "time goes by\n")
        self.write("none.vtp.series", '{"files": []}')
        self.write("text.vtp.series", "time goes by\n")
        for name in ("empty.pvd", "text.pvd", "none.vtp.series", "text.vtp.series", "gone.pvd"):
            self.assertEqual(self.refuse(1, name, name, "--film", "time", *MP4), [], name)
        self.assertEqual(self.refuse(1, "numbered", "flow_%04d.vtp", "--film", "time", *MP4), [])
        self.write("square0.vtp", SQUARE.format(heat=0))
        self.write("a.vtp.series", '{"files": [{"name": "square0.vtp"}]}')
        self.assertEqual(
            self.refuse(1, "both", "a.vtp.series", "square%d.vtp", "--film", "time", *MP4), [])

    def test_full_disk(self):
        """As full as a limit of a file's size makes it: after a run of frames, in the next one."""
        words = ["--film", "turn", "--seconds", "120", "--fps", "2", *MP4]
        self.film(*words, "--part", "1/2")
        kept = os.listdir(self.path("film.mp4.parts"))

        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))

        done = self.run_film(*words, "--part", "2/2", preexec_fn=limit)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertIn("--resume", done.stderr)
        self.assertEqual(sorted(os.listdir(self.path("film.mp4.parts"))), sorted(kept))
        frames = ["--film", "turn", "--seconds", "0.2", "-o", "frames/%05d.png"]
        self.refuse(1, "frames/00001.png", *frames, preexec_fn=limit)
        self.assertEqual(os.listdir(self.path("frames")), [])


if __name__ == "__main__":
    main()
