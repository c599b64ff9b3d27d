#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the documentation site with small pictures, and shows that its checks find what is wrong.

    test_site.py OUTDIR BUILD
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RULES = os.path.join(ROOT, "Documentation", "site")
LARGEST = "64"
OUT, BUILD = (os.path.abspath(path) for path in sys.argv[1:3]) if len(sys.argv) == 3 else ("", "")


def call(*command):
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, check=False, env=dict(os.environ, WIDEFOV_LARGEST=LARGEST))


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(OUT, ignore_errors=True)
        cls.done = call("bash", os.path.join(ROOT, "Utilities", "site.sh"), OUT, BUILD)

    def test_is_built(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout)
        print(self.done.stdout)

    def test_shows_what_the_commands_drew(self):
        with open(os.path.join(OUT, "Documentation", "tasks", "dome.html"), encoding="utf-8") as stream:
            page = stream.read()
        for name in ("dome", "eyes-left", "eyes-right", "rise-0001", "rise-0050"):
            # Sphinx numbers the pictures of one name
            found = re.search(r'src="(\.\./\.\./_images/%s\d*\.png)"' % name, page)
            self.assertTrue(found, name)
            self.assertTrue(os.path.isfile(os.path.join(OUT, "Documentation", "tasks", found[1])), name)
        self.assertTrue(os.path.isfile(os.path.join(OUT, "api", "classvtkWideFoVCamera.html")))

    def test_finds_broken_links(self):
        for link in ("nowhere.html", "index.html#nowhere", "start.html"):
            with tempfile.TemporaryDirectory() as site:
                with open(os.path.join(site, "index.html"), "w", encoding="utf-8") as stream:
                    stream.write('<p id="here"><a href="#here"></a><a href="%s"></a></p>' % link)
                done = call(sys.executable, "-B", os.path.join(RULES, "check_links.py"), site)
                self.assertEqual(done.returncode, 1)
                self.assertIn(link, done.stdout)
                self.assertIn(" 1 complaints", done.stdout)

    def test_finds_commands_that_fail(self):
        for command in ("false | true", "widefov-render --scene nowhere -o x.png", "true"):
            with tempfile.TemporaryDirectory() as folder:
                page = os.path.join(folder, "page.md")
                with open(page, "w", encoding="utf-8") as stream:
                    stream.write("```sh\n%s\n```\n" % command)
                done = call(sys.executable, "-B", os.path.join(RULES, "run_pages.py"),
                    os.path.join(BUILD, "bin"), LARGEST, ROOT, page)
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertIn(command, done.stdout)

    def test_draws_the_gallery(self):
        data = os.path.join(os.path.dirname(ROOT), "shared", "data")
        with tempfile.TemporaryDirectory() as folder:
            done = call("bash", os.path.join(ROOT, "Utilities", "with-display.sh"), sys.executable, "-B",
                os.path.join(RULES, "gallery.py"), os.path.join(BUILD, "bin"), LARGEST, folder,
                *([data] if os.path.isdir(data) else []))
            self.assertEqual(done.returncode, 0, done.stdout)
            print(done.stdout)
            for name in ("winds", "sea", "relief"):
                self.assertIn("data-%s.jpg" % name, os.listdir(folder))
            pictures = os.path.join(ROOT, "Documentation", "images")
            self.assertLessEqual(set(os.listdir(folder)), set(os.listdir(pictures)))

    def test_refuses(self):
        script = os.path.join(ROOT, "Utilities", "site.sh")
        for arguments, code in (((), 2), ((ROOT, BUILD), 1), ((OUT, ROOT), 1)):
            done = call("bash", script, *arguments)
            self.assertEqual(done.returncode, code, done.stdout)
            self.assertRegex(done.stdout, r"\Asite\.sh: [^\n]+\n\Z")


if __name__ == "__main__":
    if not BUILD:
        sys.exit(__doc__)
    unittest.main(argv=sys.argv[:1])
