#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Uses the project from outside, with the very lines of its README.

    test_install.py install BUILD PREFIX      installs the build, into an empty PREFIX
    test_install.py cxx WORK TREE CMAKE...    builds and runs the C++ lines in WORK, against
                                              TREE (a build tree or a prefix); CMAKE: the
                                              command and options to configure with
    test_install.py python WORK FOLDER        runs the Python lines, `widefov` from FOLDER
    test_install.py other WORK FOLDER VERSION imports it beside another VTK than VERSION, which
                                              is that of the build
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


# What of another VTK's Python package is looked at.
OTHER_VTK = '''class vtkVersion:
    @staticmethod
    def GetVTKVersion():
        return "%s"
'''


def import_beside(work, folder, version):
    """What `import widefov` says where vtkmodules is of that version, and nothing but a version."""
    fresh_folder(os.path.join(work, "vtkmodules"))
    write(work, "vtkmodules/__init__.py", "")
    write(work, "vtkmodules/vtkCommonCore.py", OTHER_VTK % version)
    paths = os.pathsep.join([work, folder])
    done = subprocess.run([sys.executable, "-B", "-c", "import widefov"], capture_output=True,
        text=True, check=False, env={**os.environ, "PYTHONPATH": paths})
    return (done.stderr.splitlines() or ["(nothing)"])[-1]


def refuse_other_vtk(work, folder, version):
    refused = "ImportError: widefov was built for VTK %s, but this Python's vtkmodules is VTK 8.9.7"
    said = import_beside(work, folder, "8.9.7")
    if not said.startswith(refused % version):
        sys.exit("beside VTK 8.9.7 it says: " + said)
    said = import_beside(work, folder, version)  # the next modules are not there
    if not said.startswith("ModuleNotFoundError: No module named 'vtkmodules.vtk"):
        sys.exit("beside VTK %s it says: %s" % (version, said))


def main():
    actions = {
        "install": install, "cxx": use_cxx, "python": use_python, "other": refuse_other_vtk,
    }
    if len(sys.argv) < 4 or sys.argv[1] not in actions:
        sys.exit(__doc__)
    actions[sys.argv[1]](*sys.argv[2:])


if __name__ == "__main__":
    main()
