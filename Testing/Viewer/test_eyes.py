#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the window shows of two eyes, photographed.

    test_eyes.py WIDEFOV_VIEWER WIDEFOV_RENDER GROUP...
"""

import os
import subprocess
import sys
import unittest

from desktop import wait_for
from test_viewer import PROGRAMS, ViewerTest, read_png


class Eyes(ViewerTest):
    STEREO = ("--stereo", "omnidirectional", "--ipd", "0.3", "--layout", "frame-sequential")

    def seen(self, viewer, at_least):
        """The different pictures that the window shows by turns."""
        pictures = {}

        def looked():
            picture = viewer.photograph()
            pictures[picture.tobytes()] = picture
            return len(pictures) >= at_least

        wait_for("the other eye", looked)
        for _ in range(20):
            looked()
        return list(pictures.values())

    def eye(self, side, size):
        name = os.path.join(self.folder, side + ".png")
        subprocess.run(
            [PROGRAMS["render"], os.path.join(self.folder, "marks.vtk"), "--eye", "0,0,0",
             *self.STEREO[:4], "--layout", side, "--samples", "0", "--size", size, "-o", name],
            env={**os.environ, "DISPLAY": self.desktop.name}, check=True)
        return read_png(name)

    def test_eyes_in_turn(self):
        viewer = self.start(*self.STEREO)
        for size in ("640x320", "400x200"):
            if size != "640x320":
                viewer.resize(*(int(side) for side in size.split("x")))
            seen = self.seen(viewer, 2)
            self.assertEqual(len(seen), 2)
            eyes = [self.eye(side, size) for side in ("left", "right")]
            same = [[(eye == picture).all() for picture in seen] for eye in eyes]
            self.assertEqual(sorted(map(sorted, same)), [[False, True], [False, True]])
        viewer.key("l", look=lambda s: s["layout"] == "anaglyph")
        self.assertEqual(len(self.seen(viewer, 1)), 1)
        self.check_same(viewer)
        viewer.key("l", shift=True, look=lambda s: "by software" in s["message"])
        viewer.key("F2", look=lambda s: "written" in s["message"])
        viewer.ask_to_close()
        self.assert_ends(viewer, 0, "in turn by software")


if __name__ == "__main__":
    PROGRAMS.update(viewer=sys.argv[1], render=sys.argv[2])
    unittest.main(argv=[sys.argv[0], "-v"] + sys.argv[3:])
