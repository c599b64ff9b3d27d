#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How Testing/elsewhere.sh, and what it installs by, fail: exit code 1, one line that says what and
the remedy, and nothing left behind.

    test_elsewhere.py ROOT

Stand-ins for the programs of the system take the place of a network, of being root and of the
right to mount, so that nothing is downloaded and nothing made.
"""

import fcntl
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

CHECKOUT = os.path.abspath(sys.argv.pop(1))
NEEDED = ["Testing/elsewhere.sh", "Utilities/install-packages.sh", "Utilities/packages.txt"]

ROOT = {"id": "echo 0", "unshare": 'shift; exec "$@"', "flock": "exit 0", "mount": "exit 0"}
NOBODY = {"id": "echo 1000"}
# makes half a root, and ends as the real one does
NO_NETWORK = 'for word; do case "$word" in */trixie.part) mkdir -p "$word/etc";; esac; done\n'
NO_NETWORK += 'echo "I: Retrieving InRelease"; echo "E: Failed getting release file $4/Release"; exit 1'
# of the programs that scripts find by their names
USUAL = "awk bash cat dirname env false grep head mkdir paste realpath rm rmdir sed tail true".split()


class Scripts:
    """A checkout with the scripts alone, and a PATH with the stand-ins and little else."""

    def __init__(self, folder, stand_ins):
        self.top = os.path.join(folder, "checkout")
        self.programs = os.path.join(folder, "bin")
        os.mkdir(self.programs)
        for name in NEEDED:
            place = os.path.join(self.top, name)
            os.makedirs(os.path.dirname(place), exist_ok=True)
            shutil.copy(os.path.join(CHECKOUT, name), place)
        for name in USUAL:
            os.symlink(shutil.which(name), os.path.join(self.programs, name))
        for name, script in stand_ins.items():
            place = os.path.join(self.programs, name)
            with open(place, "w", encoding="utf-8") as stream:
                stream.write("#!%s\n%s\n" % (shutil.which("bash"), script))
            os.chmod(place, 0o755)

    def run(self, script, *arguments, **environment):
        """The finished process; its environment has no more than what is named."""
        return subprocess.run(
            [shutil.which("bash"), os.path.join(self.top, script), *arguments],
            env={"PATH": self.programs, **environment},
            stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60, check=False)

    def files(self):
        """What lies in the checkout, folders too."""
        found = []
        for folder, children, names in os.walk(self.top):
            found += [os.path.join(folder, name) for name in children + names]
        return sorted(os.path.relpath(name, self.top) for name in found)


class Elsewhere(unittest.TestCase):
    def check(self, stand_ins, arguments, says, script="Testing/elsewhere.sh", **environment):
        with tempfile.TemporaryDirectory(prefix="elsewhere-") as folder:
            scripts = Scripts(folder, stand_ins)
            before = scripts.files()
            done = scripts.run(script, *arguments, **environment)
            lines = done.stderr.splitlines()
            self.assertEqual(done.returncode, 1, done)
            self.assertEqual(len(lines), 1, done.stderr)
            self.assertTrue(lines[0].startswith((script, os.path.basename(script))), lines[0])
            for word in says:
                self.assertIn(word, lines[0])
            self.assertEqual(scripts.files(), before)

    def test_no_suite(self):
        self.check({}, [], ["name a suite", "trixie"])

    def test_unknown_suite(self):
        self.check({}, ["jammy"], ["jammy", "trixie", "forky"])

    def test_a_path_as_suite(self):
        self.check({}, ["../trixie"], ["../trixie"])

    def test_not_root(self):
        self.check(NOBODY, ["trixie"], ["not root", "sudo"])

    def test_no_debootstrap(self):
        stand_ins = {**ROOT, "dpkg-query": "exit 1", "apt-get": "echo E: no network >&2; exit 1"}
        self.check(stand_ins, ["trixie"], ["without debootstrap", "could not install"], WIDEFOV_SUITE="bookworm")

    def test_no_right_to_mount(self):
        stand_ins = {**ROOT, "unshare": "echo no >&2; exit 1", "debootstrap": "exit 0"}
        self.check(stand_ins, ["trixie"], ["may not mount", "container"])

    def test_mounts_that_are_refused(self):
        with tempfile.TemporaryDirectory(prefix="elsewhere-") as folder:
            scripts = Scripts(folder, {**ROOT, "mount": "exit 32"})
            os.makedirs(os.path.join(scripts.top, "build-roots/trixie"))
            done = scripts.run("Testing/elsewhere.sh", "trixie")
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done)
            self.assertIn("FAILED while mounting (a container", done.stderr)

    def test_two_at_once(self):
        flock = {"flock": 'exec %s "$@"' % shutil.which("flock")}
        with tempfile.TemporaryDirectory(prefix="elsewhere-") as folder:
            scripts = Scripts(folder, {**ROOT, **flock, "mount": "exit 32"})
            root = os.path.join(scripts.top, "build-roots/trixie")
            os.makedirs(root)
            first = os.open(root, os.O_RDONLY)
            fcntl.flock(first, fcntl.LOCK_EX)
            for arguments in (["trixie"], ["--prepare", "trixie"], ["--in", "trixie", "true"]):
                done = scripts.run("Testing/elsewhere.sh", *arguments)
                self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done)
                self.assertIn("trixie: another call is at work there", done.stderr)
            os.close(first)
            self.assertIn("while mounting", scripts.run("Testing/elsewhere.sh", "trixie").stderr)

    def test_no_network(self):
        stand_ins = {**ROOT, "debootstrap": NO_NETWORK}
        self.check(stand_ins, ["trixie"], ["trixie", "Failed getting release file", "network"])
        self.check(stand_ins, ["--prepare", "trixie"], ["trixie", "WIDEFOV_MIRROR"])

    def test_debootstrap_that_says_nothing(self):
        stand_ins = {**ROOT, "debootstrap": "exit 1"}
        self.check(stand_ins, ["trixie"], ["trixie", "debootstrap failed"])

    def test_unknown_system(self):
        install = "Utilities/install-packages.sh"
        self.check({}, ["build"], ["jammy", "bookworm", "WIDEFOV_SUITE"], install, WIDEFOV_SUITE="jammy")
        self.check({}, ["nothing"], ["nothing", "packages.txt"], install, WIDEFOV_SUITE="trixie")
        self.check({}, [], ["group"], install)

    def test_not_debian(self):
        install = "Utilities/install-packages.sh"
        self.check({}, ["build"], ["Debian's package tools", "libvtk9-dev"], install, WIDEFOV_SUITE="noble")


class Packages(unittest.TestCase):
    """Each suite gets its own names and those that are the same everywhere."""

    def names(self, suite):
        with tempfile.TemporaryDirectory(prefix="elsewhere-") as folder:
            scripts = Scripts(folder, {})
            done = scripts.run("Utilities/install-packages.sh", "build", "paraview", WIDEFOV_SUITE=suite)
            return done.stderr.split(": ")[-1].split()

    def test_satisfy_installs_what_is_missing(self):
        """However much apt says, and nothing where nothing is missing."""
        says = 'case "$*" in *--simulate*) %s;; *) echo "run $*"; esac'
        many = "echo Inst first; for i in {1..20000}; do echo Conf $i; done"
        for simulated, installs in [(many, True), ("exit 100", True), ("echo Nothing", False)]:
            with tempfile.TemporaryDirectory(prefix="elsewhere-") as folder:
                apt = {"apt-get": says % simulated, "dpkg-query": "exit 0"}
                scripts = Scripts(folder, {**ROOT, **apt})
                done = scripts.run("Utilities/install-packages.sh", "--satisfy", "first (>= 1)")
                self.assertEqual((done.returncode, done.stderr), (0, ""), done)
                self.assertEqual("first (>= 1)" in done.stdout, installs, simulated)

    def test_names(self):
        for suite, own, other in [
            ("bookworm", "qtbase5-dev", "qt6-base-dev"),
            ("noble", "qtbase5-dev", "qt6-base-dev"),
            ("trixie", "qt6-base-dev", "qtbase5-dev"),
            ("forky", "qt6-base-dev", "qtbase5-dev"),
        ]:
            names = self.names(suite)
            self.assertIn("libvtk9-dev", names)
            self.assertIn(own, names)
            self.assertNotIn(other, names)


if __name__ == "__main__":
    unittest.main()
