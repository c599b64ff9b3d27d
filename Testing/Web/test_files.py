#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What widefov-render --web writes, and how it fails: one line, an exit code, nothing half done. A stand-in
takes the place of the viewer, which comes from the network.

    test_files.py WIDEFOV-RENDER
"""

import base64
import json
import os
import re
import resource
import shutil
import subprocess

import pages
from pages import PageTest, main

SMALL = ["--size", "64x32"]
TURN = ["--film", "turn", "--seconds", "0.2", "--fps", "5"]
VIEWER = ("index.html", "viewer.js", "viewer.css", "licences.txt")


class Files(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        os.makedirs(cls.path("data/web"))
        for name in VIEWER:
            with open(cls.path("data/web/" + name), "w", encoding="utf-8") as stream:
                stream.write(name)
        cls.environment = {**os.environ, "WIDEFOV_DATA_DIR": cls.path("data")}

    def page(self, folder, *words):
        """The description in page.js."""
        done = self.render("--web", folder, *words, env=self.environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path(folder + "/page.js"), encoding="utf-8") as stream:
            return json.loads(re.fullmatch(r"widefov\.show\((.*)\);\n", stream.read(), re.S).group(1))

    def refuse(self, code, says, *words, **more):
        done = self.render(*words, **{"env": self.environment, **more})
        lines = done.stderr.splitlines()
        self.assertEqual((done.returncode, len(lines)), (code, 1), done.stderr)
        self.assertTrue(lines[0].startswith("widefov-render: "), lines)
        self.assertIn(says, lines[0])

    def test_picture(self):
        """Whole, then a page of two eyes and of a part in its place."""
        page = self.page("still", *SMALL, "-o", "beside.png", "--title", "A \"title\"")
        self.assertEqual((page["title"], page["picture"], page["bar"]), ("A \"title\"", "panorama.jpg", "bar.png"))
        self.assertTrue(os.path.isfile(self.path("beside.png")))
        with open(self.path("still/panorama.jpg"), "rb") as stream:
            picture = stream.read()
        with open(self.path("still/panorama.jpg.js"), encoding="utf-8") as stream:
            twin = re.fullmatch(r'widefov\.file\("panorama\.jpg", "data:image/jpeg;base64,(.*)"\);\n', stream.read())
        self.assertEqual(base64.b64decode(twin.group(1)), picture)
        eyes = ["--stereo", "omnidirectional", "--ipd", "0.1"]
        page = self.page("still", *SMALL, *eyes, "--hfov", "180", "--vfov", "90", "--scalar-bar-at", "0,-30,0.5")
        self.assertEqual((page["title"], page["right"]), ("balls", "panorama-right.jpg"))
        sphere = {"fullWidth": 128, "fullHeight": 64, "croppedWidth": 64, "croppedHeight": 32, "croppedX": 32,
                  "croppedY": 16, "posePitch": 0}
        self.assertEqual(page["sphere"], sphere)
        self.assertEqual(sorted(os.listdir(self.path("still"))), sorted(
            [*VIEWER, "page.js", "panorama.jpg", "panorama.jpg.js", "panorama-right.jpg", "panorama-right.jpg.js"]))

    def test_film(self):
        page = self.page("film", *SMALL, *TURN)
        self.assertEqual((page["film"], page["sphere"]["fullWidth"]), ("film.mp4", 64))
        self.assertTrue(os.path.isfile(self.path("film/film.mp4.js")))

    def test_usage(self):
        self.refuse(2, "--projection", "--web", "new", *SMALL, "--projection", "hammer")
        self.refuse(2, "--title", "-o", "a.png", *SMALL, "--title", "A")
        self.refuse(2, "--layout", "--web", "new", *SMALL, "--stereo", "omnidirectional", "--ipd", "0.1", "--layout",
                    "top-bottom")
        self.assertFalse(os.path.exists(self.path("new")))

    def test_folders(self):
        os.makedirs(self.path("other/tiles"))
        for name in ("other/notes.txt", "file"):
            with open(self.path(name), "w", encoding="utf-8") as stream:
                stream.write("mine")
        self.refuse(1, "notes.txt", "--web", "other", *SMALL)
        self.refuse(1, "file is no folder", "--web", "file", *SMALL)
        self.refuse(1, "file/page cannot be made", "--web", "file/page", *SMALL)
        self.assertEqual(sorted(os.listdir(self.path("other"))), ["notes.txt", "tiles"])
        self.page("page", *SMALL)
        self.refuse(1, "is an input file", "--web", "page", *SMALL, "--sky", self.path("page/panorama.jpg"))

    def test_without(self):
        """Without ffmpeg, and without the viewer: a copy of the program has no data beside it."""
        self.refuse(1, "ffmpeg", "--web", "new", *SMALL, *TURN, env={**self.environment, "PATH": self.folder})
        self.assertFalse(os.path.exists(self.path("new")))
        os.makedirs(self.path("bin"))
        copy = shutil.copy(pages.RENDER, self.path("bin"))
        libraries = os.path.join(os.path.dirname(os.path.dirname(pages.RENDER)), "lib")
        done = subprocess.run([copy, "--scene", "room", "--web", "new", *SMALL], cwd=self.folder, capture_output=True,
                              text=True, check=False, env={**os.environ, "LD_LIBRARY_PATH": libraries})
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertIn("fetch-viewer.sh", done.stderr)

    def test_full_disk(self):
        """As full as a limit of a file's size makes it. An earlier page stays whole."""
        self.page("full", *SMALL)
        before = {name: os.path.getmtime(self.path("full/" + name)) for name in os.listdir(self.path("full"))}
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))  # noqa: E731
        self.refuse(1, "full/panorama.jpg", "--web", "full", "--size", "512x256", preexec_fn=limit)
        after = {name: os.path.getmtime(self.path("full/" + name)) for name in os.listdir(self.path("full"))}
        self.assertEqual(before, after)


if __name__ == "__main__":
    main()
