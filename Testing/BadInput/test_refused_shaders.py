#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How widefov-render ends where the graphics driver refuses a shader: exit code 1, one line that
says which and why, and no picture.

    test_refused_shaders.py WIDEFOV-RENDER

Mesa writes the text of every shader into the folder MESA_SHADER_DUMP_PATH, and takes those of
MESA_SHADER_READ_PATH in their place, by the same names. Exit code 77 where the driver does neither.
"""

import os
import subprocess
import sys
import tempfile

RENDER = os.path.abspath(sys.argv[1])
PICTURE = "picture.png"
KINDS = {"VS": "vertex shader", "GS": "geometry shader", "FS": "fragment shader"}
OURS = "wfv"  # what the module's own texts have, and those of VTK have not
NOTHING = "wfvDrawsNothing"
TECHNIQUES = ["auto", "exact", "preclip", "vertex"]


def render(folder, technique, **environment):
    return subprocess.run(
        [RENDER, "--scene", "room", "--size", "64x32", "--technique", technique, "--output", PICTURE],
        cwd=folder, env={**os.environ, "MESA_SHADER_CACHE_DISABLE": "true", **environment},
        stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300, check=False)


def shaders_in(folder):
    """Names and texts of the module's own."""
    found = {}
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), encoding="utf-8", errors="replace") as stream:
            text = stream.read()
        if OURS in text and NOTHING not in text:
            found[name] = text
    return found


def complaints_about(done, folder, what):
    lines = [line for line in done.stderr.splitlines() if not line.endswith(" s)")]  # progress
    if done.returncode != 1:
        yield "exit code %d, not 1" % done.returncode
    if len(lines) != 1 or not lines[0].startswith("widefov-render: drawing failed: "):
        yield "it said: %s" % done.stderr[:2000]
    elif what not in lines[0] or "error" not in lines[0]:
        yield "not said: what is refused (%s), or why: %s" % (what, lines[0])
    if os.path.exists(os.path.join(folder, PICTURE)):
        yield "a picture was written"


def check(technique):
    """Each kind of shader of a technique refused in turn; how many, and what was wrong."""
    tried, wrong = 0, []
    with tempfile.TemporaryDirectory() as folder:
        dump = os.path.join(folder, "dump")
        os.mkdir(dump)
        first = render(folder, technique, MESA_SHADER_DUMP_PATH=dump)
        if first.returncode != 0:
            return 0, ["%s: %s" % (technique, first.stderr)]
        os.remove(os.path.join(folder, PICTURE))
        texts = shaders_in(dump)
        for kind, what in KINDS.items():
            names = [name for name in texts if name.startswith(kind)]
            if not names:
                continue
            bad = os.path.join(folder, "bad-" + kind)
            os.mkdir(bad)
            for name in names:
                with open(os.path.join(bad, name), "w", encoding="utf-8") as stream:
                    stream.write(texts[name] + "\nnowhere to be found\n")
            done = render(folder, technique, MESA_SHADER_READ_PATH=bad)
            tried += 1
            wrong += ["%s, %s: %s" % (technique, what, w) for w in complaints_about(done, folder, what)]
    return tried, wrong


def main():
    tried, wrong = 0, []
    for technique in TECHNIQUES:
        n, complaints = check(technique)
        tried += n
        wrong += complaints
    print("\n".join(wrong))
    print("refused shaders: %d tried, %d complaints" % (tried, len(wrong)))
    sys.exit(1 if wrong else 0 if tried else 77)


if __name__ == "__main__":
    main()
