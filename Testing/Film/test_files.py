#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The files of films: encoded, drawn in parts, interrupted and gone on with.

    test_files.py WIDEFOV-RENDER
"""

import base64
import os
import signal
import subprocess
import time

from films import SQUARE, FilmTest, main, probe, words_of
from matplotlib.image import imread

TURN = ["--film", "turn"]

CONTAINERS = {"x264": ("mp4", "mov", "mkv"), "x265": ("mp4", "mov", "mkv"), "vp9": ("mp4", "webm", "mkv"),
              "av1": ("mp4", "webm", "mkv"), "prores": ("mov", "mkv")}

# One pixel, written by another program.
PNG = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")


def words_before(option, values):
    return [word for value in values for word in (option, value)]


class Files(FilmTest):
    def test_codecs(self):
        words = [*TURN, "--seconds", "0.2", "--fps", "30"]
        self.film(*words, "-o", "a.mp4", "-o", "c.webm", "-o", "d.mov", "-o", "e.mkv")
        self.film(*words, "--codec", "x265", "--quality", "30", "-o", "b.mp4")
        for name, codec in (("a.mp4", "h264"), ("b.mp4", "hevc"), ("c.webm", "vp9"),
                            ("d.mov", "prores"), ("e.mkv", "h264")):
            found = probe(self.path(name))
            self.assertEqual(found["codec_name"], codec)
            self.assertEqual(found["nb_read_packets"], "6")
            self.assertEqual(found["r_frame_rate"], "30/1")
            self.assertEqual((found["width"], found["height"]), (64, 32))
        self.assertEqual(len(os.listdir(self.folder)), 5)

    def test_colors(self):
        """Every codec in every container has colour tags, and is decoded to the colours that were drawn."""
        self.write("square.vtp", SQUARE.format(heat=0))
        outputs = {codec: ["film." + ending for ending in endings] for codec, endings in CONTAINERS.items()}
        for color in ((184, 29, 24), (24, 160, 60), (30, 40, 200)):
            for codec, films in outputs.items():
                self.film("square.vtp", "--eye", "0,0,9", *TURN, "--sweep", "1", "--seconds", "0.04", "--background",
                          ",".join(str(value / 255) for value in color), "--codec", codec, *words_before("-o", films))
                for film in films:
                    found = probe(self.path(film))
                    tags = [found.get("color_" + tag) for tag in ("range", "space", "transfer", "primaries")]
                    self.assertEqual(tags, ["tv", "bt709", "bt709", "bt709"], (codec, film))
                    decoded = subprocess.check_output(["ffmpeg", "-v", "error", "-i", self.path(film), "-frames:v", "1",
                                                       "-pix_fmt", "rgb24", "-f", "rawvideo", "-"])
                    for drawn, read in zip(color, decoded[:3]):  # the corner: background
                        self.assertLessEqual(abs(drawn - read), 4, (codec, film, color, tuple(decoded[:3])))

    def test_players_may_begin_at_once(self):
        self.film(*TURN, "--seconds", "0.2", "-o", "film.mp4")
        with open(self.path("film.mp4"), "rb") as stream:
            data = stream.read()
        self.assertLess(data.index(b"moov"), data.index(b"mdat"))
        # every frame is where the tables say
        subprocess.run(["ffmpeg", "-v", "error", "-xerror", "-i", self.path("film.mp4"), "-f", "null", "-"],
                       check=True, stderr=subprocess.PIPE)

    def test_sound(self):
        words = ["ffmpeg", "-v", "error", "-f", "lavfi", "-i", "sine=duration=3", self.path("tone.wav")]
        subprocess.run(words, check=True)
        for name, codec in (("film.mp4", "aac"), ("film.webm", "opus")):
            self.film(*TURN, "--seconds", "0.4", "--audio", "tone.wav", "-o", name)
            text = subprocess.check_output(["ffprobe", "-v", "error", "-select_streams", "a", "-show_entries",
                                            "stream=codec_name:format=duration", "-of", "csv=p=0",
                                            self.path(name)], text=True)
            self.assertIn(codec, text)
            self.assertLess(float(text.split()[-1]), 0.7)

    def test_several_outputs_and_eyes(self):
        self.film(*TURN, "--seconds", "0.08", "--stereo", "omnidirectional", "--ipd", "0.3", "--layout",
                  "separate", "-o", "film.mp4", "-o", "frames/%d.png")
        self.assertEqual(sorted(os.listdir(self.folder)), ["film-left.mp4", "film-right.mp4", "frames"])
        self.assertEqual(sorted(os.listdir(self.path("frames/right"))), ["1.png", "2.png"])

    def test_parts(self):
        words = [*TURN, "--seconds", "0.4", "-o", "film.mp4"]
        self.assertIn("5 of 10", self.film(*words, "--part", "2/2"))
        self.assertEqual(os.listdir(self.folder), ["film.mp4.parts"])
        said = self.run_film(*words, "--part", "1/2").stderr
        self.assertEqual(said.splitlines()[-1], "widefov-render: 10 frames are in film.mp4")
        self.assertEqual(os.listdir(self.folder), ["film.mp4"])
        self.assertEqual(probe(self.path("film.mp4"))["nb_read_packets"], "10")


class Resuming(FilmTest):
    def test_frames_that_are_there_stay(self):
        words = [*TURN, "--seconds", "0.16", "-o", "frames/%05d.png"]
        self.assertIn("frames 1 to 2 of 4 are in frames/%05d.png", self.run_film(*words, "--part", "1/2").stderr)
        self.assertEqual(self.run_film(*words, "--quiet").stderr, "")
        os.remove(self.path("frames/00003.png"))
        before = {name: os.stat(self.path("frames/" + name)).st_mtime_ns
                  for name in os.listdir(self.path("frames"))}
        self.film(*words, "--resume")
        after = {name: os.stat(self.path("frames/" + name)).st_mtime_ns
                 for name in os.listdir(self.path("frames"))}
        self.assertIn("00003.png", after)
        self.assertEqual({name: after[name] for name in before}, before)

    def refuse(self, says, *words):
        before = {name: os.stat(self.path("frames/" + name)).st_mtime_ns for name in os.listdir(self.path("frames"))}
        done = self.run_film(*words)
        said = words_of(done.stderr)
        self.assertEqual((done.returncode, said.count("\n")), (1, 0), said)
        self.assertIn(says, said)
        for name, time_ in before.items():
            self.assertEqual(os.stat(self.path("frames/" + name)).st_mtime_ns, time_)

    def test_frames_know_their_film(self):
        for ending in ("png", "jpg", "exr"):
            words = [*TURN, "--seconds", "0.16", "--hfov", "90", "-o", "frames/%d." + ending]
            self.film(*words)
            self.film(*words, "--resume", "--quiet")  # nothing that changes a frame
            self.refuse("frames/1.%s is not of this film: --hfov is 100, and 90 there; give" % ending, *TURN, "--seconds",
                        "0.16", "--hfov", "100", "-o", "frames/%d." + ending, "--resume")
            whole = [frame.tobytes() for frame in self.pictures(ending)] if ending == "png" else []
            path = self.path("frames/2." + ending)
            os.truncate(path, os.path.getsize(path) - 9)
            self.assertEqual(self.film(*words, "--resume"), "widefov-render: frames/2.%s is cut short, and is drawn again" % ending)
            if whole:
                self.assertEqual([frame.tobytes() for frame in self.pictures(ending)], whole)
        self.refuse("--tilt is 10, and not given there", *words, "--tilt", "10", "--part", "1/2")
        shorter = [*TURN, "--seconds", "0.08", "-o", "frames/%d.png"]
        said = self.film(*shorter)
        self.assertEqual(said, "widefov-render: 2 older frames after frames/2.png will stay; remove them if they are not of "
                         "this film")
        self.refuse("--seconds is 0.16, and 0.08 there", *TURN, "--seconds", "0.16", "-o", "frames/%d.png", "--resume")
        with open(self.path("frames/1.png"), "wb") as stream:
            stream.write(PNG)
        self.refuse("frames/1.png is not of this film: it does not say which options", *shorter, "--resume")

    def pictures(self, ending):
        place = self.path("frames")
        return [imread(os.path.join(place, name)) for name in sorted(os.listdir(place)) if name.endswith(ending)]

    def test_folders_are_made_and_said(self):
        for output in ("new/deep/film.mp4", "other/deep/%d.png"):
            said = self.run_film(*TURN, "--seconds", "0.08", "-o", output).stderr
            self.assertIn("widefov-render: the folder %s was not there, and is made\n" % os.path.dirname(output), said)
        with open(self.path("file"), "w", encoding="utf-8") as stream:
            stream.write("in the way")
        for output in ("file/film.mp4", "file/%d.png"):
            done = self.run_film(*TURN, "--seconds", "0.08", "-o", output)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)

    def runs(self):
        parts = self.path("film.mp4.parts")
        return sum(name[0] == "0" for name in os.listdir(parts)) if os.path.isdir(parts) else 0

    def interrupt(self, words, number):
        """Sends the signal as soon as one more run of frames is whole; what the program says."""
        before = self.runs()
        program = subprocess.Popen(self.command(*words), cwd=self.folder, stderr=subprocess.PIPE, text=True)
        with program:
            while program.poll() is None:
                if self.runs() > before:
                    program.send_signal(number)
                    break
                time.sleep(0.01)
            said = program.communicate(timeout=60)[1]
        self.assertEqual(program.returncode, 1, said)
        return said

    def test_interrupted(self):
        words = [*TURN, "--seconds", "400", "--fps", "2", "-o", "film.mp4"]
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            said = self.interrupt(words + ["--resume"] * (number != signal.SIGINT), number)
            lines = words_of(said).splitlines()
            self.assertEqual(len(lines), 1, said)
            self.assertIn("interrupted", lines[0])
            self.assertIn("--resume", lines[0])
            self.assertEqual(os.listdir(self.folder), ["film.mp4.parts"])
            left = os.listdir(self.path("film.mp4.parts"))
            self.assertTrue(all(name[0] == "0" or name == "film.txt" for name in left), left)
        self.assertIn("--resume", self.run_film(*words).stderr)
        self.film(*words, "--resume")
        self.assertEqual(os.listdir(self.folder), ["film.mp4"])
        self.assertEqual(probe(self.path("film.mp4"))["nb_read_packets"], "800")
        self.assertIn("whole", self.film(*words, "--resume"))

    def test_two_at_once(self):
        """The second says so, and leaves the first one's frames alone."""
        words = [*TURN, "--seconds", "400", "--fps", "2", "-o", "film.mp4"]
        with subprocess.Popen(self.command(*words), cwd=self.folder, stderr=subprocess.PIPE, text=True) as first:
            while first.poll() is None and self.runs() == 0:
                time.sleep(0.01)
            second = self.run_film(*words)
            first.send_signal(signal.SIGINT)
            first.communicate(timeout=60)
        self.assertEqual(second.returncode, 1)
        self.assertIn("another process draws this film", second.stderr)
        self.assertGreater(self.runs(), 0)

    def test_other_options_are_another_film(self):
        words = [*TURN, "--seconds", "0.4", "-o", "film.mp4"]
        self.film(*words, "--part", "1/2")
        other = self.run_film(*words, "--part", "2/2", "--tilt", "10")
        self.assertEqual(other.returncode, 1)
        self.assertIn("another film", other.stderr)


if __name__ == "__main__":
    main()
