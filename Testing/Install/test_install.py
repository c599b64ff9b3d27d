#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Uses the project from outside, with the very lines of its README.

    test_install.py install BUILD PREFIX      installs the build, into an empty PREFIX
    test_install.py cxx WORK TREE CMAKE...    builds and runs the C++ lines in WORK, against
                                              TREE (a build tree or a prefix); CMAKE: the
                                              command and options to configure with
    test_install.py python WORK FOLDER        runs the Python lines, `widefov` from FOLDER
"""

import os
import re
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
README = os.path.join(HERE, "..", "..", "README.md")

# What the README promises of each block.
MOST_LINES = 15


def readme_block(language):
    """The one fenced block of that language."""
    with open(README, encoding="utf-8") as stream:
        blocks = re.findall(r"^```%s\n(.*?)^```" % language, stream.read(), re.S | re.M)
    if len(blocks) != 1:
        sys.exit("README.md has %d blocks of %s, not 1" % (len(blocks), language))
    lines = [line for line in blocks[0].splitlines() if line.strip()]
    if len(lines) > MOST_LINES:
        sys.exit("README.md: %d lines of %s, at most %d" % (len(lines), language, MOST_LINES))
    return blocks[0]


def fresh_folder(path):
    shutil.rmtree(path, ignore_errors=True)
    os.makedirs(path)


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)
    return path


def call(*command, **more):
    print("+ " + " ".join(command), flush=True)
    status = subprocess.run(command, stdin=subprocess.DEVNULL, check=False, **more).returncode
    if status:
        sys.exit("'%s' ended with %d" % (" ".join(command), status))


def install(build, prefix):
    fresh_folder(prefix)
    call("cmake", "--install", build, "--prefix", prefix)


def use_cxx(work, tree, *cmake):
    fresh_folder(work)
    build = os.path.join(work, "build")
    cxx = write(work, "readme.inc", readme_block("cpp"))
    lines = write(work, "readme.cmake", readme_block("cmake"))
    options = ["-DREADME_CXX=" + cxx, "-DREADME_CMAKE=" + lines, "-DVTKWideFoV_ROOT=" + tree]
    call(*cmake, "-S", os.path.join(HERE, "use"), "-B", build, *options)
    call("cmake", "--build", build)
    call(os.path.join(build, "program"))


def use_python(work, folder):
    fresh_folder(work)
    with open(os.path.join(HERE, "use", "check_picture.py"), encoding="utf-8") as stream:
        script = write(work, "program.py", readme_block("python") + "\n" + stream.read())
    call(sys.executable, "-B", script, env={**os.environ, "PYTHONPATH": folder})


def main():
    actions = {"install": install, "cxx": use_cxx, "python": use_python}
    if len(sys.argv) < 4 or sys.argv[1] not in actions:
        sys.exit(__doc__)
    actions[sys.argv[1]](*sys.argv[2:])


if __name__ == "__main__":
    main()
