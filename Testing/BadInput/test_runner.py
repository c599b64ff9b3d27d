#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shows that the bad-input runner fails where it should: stand-ins for widefov-render
that misbehave in one way each are found out, and one that behaves is not."""

import os
import tempfile
import unittest

import run_bad_input
from cases import Case, FAILED

ROW = Case("missing.vtk --output {out}/old.png", FAILED, "missing.vtk")
MESSAGE = "echo 'widefov-render: missing.vtk is not there' >&2; "

# what the stand-in does; what must be complained about; $3 is the output
MISBEHAVIOURS = [
    ("exit 1", "0 lines on standard error"),
    (MESSAGE + "exit 0", "exit code 0, not 1"),
    (MESSAGE + "exit 2", "exit code 2, not 1"),
    (MESSAGE + "kill -SEGV $$", "crashed"),
    (MESSAGE + "sleep 10", "still running"),
    (MESSAGE + "echo more >&2; exit 1", "2 lines on standard error"),
    ("echo 'missing.vtk is not there' >&2; exit 1", "does not begin with"),
    ("echo 'widefov-render: no' >&2; exit 1", "does not name"),
    (MESSAGE + 'echo x > "$3.tmp"; exit 1', "files left behind"),
    (MESSAGE + 'echo x > "$3"; exit 1', "earlier output file was changed"),
]


def complaints(script):
    """What the runner says of a program that is this shell script."""
    with tempfile.TemporaryDirectory(prefix="bad-input-selftest-") as folder:
        program = os.path.join(folder, "program")
        with open(program, "w", encoding="utf-8") as stream:
            stream.write("#!/bin/sh\n" + script + "\n")
        os.chmod(program, 0o755)
        return run_bad_input.try_case(program, ROW, folder)


class Runner(unittest.TestCase):
    def setUp(self):
        self.usual = run_bad_input.TIMEOUT
        run_bad_input.TIMEOUT = 1

    def tearDown(self):
        run_bad_input.TIMEOUT = self.usual

    def test_good_manners_pass(self):
        self.assertEqual(complaints(MESSAGE + "exit 1"), [])

    def test_each_misbehaviour_is_found(self):
        for script, complaint in MISBEHAVIOURS:
            with self.subTest(script=script):
                found = complaints(script)
                self.assertTrue(any(complaint in text for text in found), found)


if __name__ == "__main__":
    unittest.main()
