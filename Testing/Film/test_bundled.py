#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The ffmpeg of a bundle (Utilities/bundle-ffmpeg.sh) alone makes the films of widefov-render.

    test_bundled.py WIDEFOV-RENDER CHECKOUT
"""

import json
import os
import subprocess
import sys

from films import FilmTest, main

CHECKOUT = sys.argv[2]

# The machine's own: the C library, and what the kernel brings.
C_LIBRARY = ("libc.so", "libm.so", "libdl.so", "libpthread.so", "librt.so", "ld-linux", "linux-vdso")

FILM = ["--film", "turn", "--seconds", "0.08", "--stereo", "omnidirectional", "--ipd", "auto", "--layout", "top-bottom"]


class Bundled(FilmTest):
    def test_films(self):
        script = os.path.join(CHECKOUT, "Utilities", "bundle-ffmpeg.sh")
        made = subprocess.run(["bash", script, self.path("programs")], capture_output=True, text=True, check=False)
        self.assertEqual(made.returncode, 0, made.stderr)
        alone = {**os.environ, "PATH": self.path("programs")}
        with self.subTest("every library is its own"):
            loaded = subprocess.run([self.path("programs/ffmpeg")], env={"LD_TRACE_LOADED_OBJECTS": "1"},
                                    capture_output=True, text=True, check=True).stdout
            for line in loaded.splitlines():
                self.assertTrue(self.path("programs/lib") in line or os.path.basename(line.split()[0])
                                .startswith(C_LIBRARY), line)
        subprocess.run(["ffmpeg", "-loglevel", "error", "-f", "lavfi", "-i", "sine=duration=0.1", self.path("a.wav")],
                       env=alone, check=True)
        for ending, codecs in {"mp4": ("x264", "x265"), "mov": ("prores",), "webm": ("vp9",)}.items():
            for codec in codecs:
                film = f"{codec}.{ending}"
                done = self.run_film(*FILM, "--codec", codec, "--audio", "a.wav", "-o", film, env=alone)
                self.assertEqual(done.returncode, 0, done.stderr)
                words = ["ffprobe", "-v", "error", "-show_streams", "-of", "json", self.path(film)]
                streams = json.loads(subprocess.check_output(words, env=alone))["streams"]
                tags = {part["side_data_type"] for part in streams[0]["side_data_list"]}
                self.assertLessEqual({"Stereo 3D", "Spherical Mapping"}, tags, film)
                self.assertEqual(streams[1]["codec_type"], "audio", film)


if __name__ == "__main__":
    main()
