#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Debian packages of a build: what they hold and ask for, that they are the same twice, and that
their programs and the Python module work where they are unpacked.

    test_packages.py BUILD WORK [PREFIX...]     PREFIX: a command that gives a display
"""

import glob
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "Utilities", "package.sh")
MIME = "{http://www.freedesktop.org/standards/shared-mime-info}mime-type"
# What a package has, and what it asks for beside the package of the library in the same version.
WANTED = {
    "libwidefov0.1": (r"usr/lib/(.*/)?libvtkRenderingWideFoV\.so\.", r"libvtk9\.\d.* \(>= "),
    "libwidefov-dev": (r"usr/lib/(.*/)?cmake/VTKWideFoV/VTKWideFoVConfig\.cmake$", r"libglm-dev"),
    "python3-widefov": (r"usr/lib/(.*/)?python3/dist-packages/widefov/__init__\.py$",
        r"python3-vtk9 \(>= 9\.[^,]*, python3-vtk9 \(<< 9\."),
    "widefov": (r"usr/share/applications/widefov-viewer\.desktop$", r"libopenimageio"),
}


def call(*command, expected=0, **more):
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True, check=False, **more)
    if done.returncode != expected:
        sys.exit("'%s' ended with %d, not %d: %s"
            % (" ".join(command), done.returncode, expected, done.stdout))
    return done.stdout


def need(condition, text):
    if not condition:
        sys.exit("test_packages.py: " + text)


def make_twice(build, work):
    """The packages by their names, of two runs side by side, in the same second or not."""
    # what counts is that it is passed on, whatever git says
    environment = dict(os.environ, SOURCE_DATE_EPOCH="1700000000")
    runs = [subprocess.Popen(["bash", SCRIPT, build, os.path.join(work, name)], env=environment,
        stdin=subprocess.DEVNULL, umask=umask) for name, umask in (("first", 0o022), ("second", 0o077))]
    need([run.wait() for run in runs] == [0, 0], "package.sh failed, see above")
    packages = {}
    for path in sorted(glob.glob(os.path.join(work, "first", "*.deb"))):
        name, version, _ = os.path.basename(path).split("_")
        packages[name] = path
        need(re.match(r"0\.1\.0(~git20231114\.221320)?-1~[a-z0-9.]+$", version), "version " + version)
        with open(path, "rb") as one, open(path.replace("/first/", "/second/"), "rb") as other:
            need(one.read() == other.read(), name + " is not the same twice")
    return packages


def check_contents(name, path, library):
    files, depends = WANTED[name]
    listed = [line.split(" -> ")[0].split("./", 1)[1] for line in call("dpkg-deb", "-c", path).splitlines()]
    need(any(re.match(files, file) for file in listed), "%s has no %s" % (name, files))
    need("usr/share/doc/%s/copyright" % name in listed, name + " has no licence")
    fields = call("dpkg-deb", "-f", path, "Depends", "Version", "Maintainer", "Description")
    need(re.search(depends, fields), "%s does not depend on %s: %s" % (name, depends, fields))
    version = re.search(r"^Version: (.*)$", fields, re.M).group(1)
    if name != library:
        need("%s (= %s)" % (library, version) in fields, name + " takes any library: " + fields)


def check_programs(path, root, build):
    """What films need is recommended; what the viewer holds of others is named."""
    recommended = call("dpkg-deb", "-f", path, "Recommends")
    need("ffmpeg" in re.split(r"[, ]+", recommended.strip()), "recommends " + recommended)
    with open(os.path.join(root, "usr/share/doc/widefov/copyright"), encoding="utf-8") as stream:
        said = stream.read()
    with open(os.path.join(build, "CMakeCache.txt"), encoding="utf-8") as stream:
        panel = not re.search(r"^IMGUI_LIBRARY:.*NOTFOUND$", stream.read(), re.M)
    found = all(words in said for words in ("Dear ImGui", "Omar Cornut", "Permission is hereby granted"))
    need("BSD 3-Clause" in said and found == panel, "the copyright says: " + said)


def check_desktop(root):
    """Each kind of file that the package tells of is opened by the viewer."""
    kinds = xml.etree.ElementTree.parse(os.path.join(root, "usr/share/mime/packages/widefov.xml"))
    names = [kind.get("type") for kind in kinds.getroot().iter(MIME)]
    desktop = os.path.join(root, "usr/share/applications/widefov-viewer.desktop")
    with open(desktop, encoding="utf-8") as stream:
        opened = re.search(r"^MimeType=(.*)$", stream.read(), re.M).group(1).split(";")
    need(names and set(names) <= set(opened), "the viewer does not open all of %s" % names)
    need(os.path.isfile(os.path.join(root, "usr/share/icons/hicolor/scalable/apps/widefov.svg")), "no icon")
    if shutil.which("desktop-file-validate"):
        call("desktop-file-validate", desktop)


def use(root, work, prefix):
    """In a root of its own, without what was built."""
    libraries = os.path.dirname(glob.glob(root + "/usr/lib/**/libvtkRenderingWideFoV.so.*", recursive=True)[0])
    package = glob.glob(root + "/usr/lib/**/dist-packages/widefov", recursive=True)[0]
    environment = dict(os.environ, LD_LIBRARY_PATH=libraries, PYTHONPATH=os.path.dirname(package))
    picture = os.path.join(work, "room.png")
    call(*prefix, os.path.join(root, "usr/bin/widefov-render"), "--scene", "room", "--size", "64x32",
        "-o", picture, env=environment)
    need(os.path.getsize(picture) > 200, "the picture is empty")
    said = call(sys.executable, "-B", "-c", "import widefov; print(widefov.__file__)", env=environment)
    need(said.startswith(package), "another widefov was imported: " + said)
    for program in glob.glob(root + "/usr/bin/*") + glob.glob(libraries + "/*.so.*"):
        need("RUNPATH" not in call("readelf", "--dynamic", program), program + " has a search path")


def refuse(work):
    said = call("bash", SCRIPT, work, work, expected=1)
    need(said.startswith("package.sh: ") and said.count("\n") == 1, "of no build it says: " + said)
    said = call("bash", SCRIPT, work, expected=2)
    need(said.startswith("package.sh: ") and said.count("\n") == 1, "of one folder it says: " + said)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    build, work = sys.argv[1:3]
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    refuse(work)
    packages = make_twice(build, work)
    need(sorted(packages) == sorted(WANTED), "packages: %s" % sorted(packages))
    root = os.path.join(work, "root")
    for name, path in packages.items():
        check_contents(name, path, "libwidefov0.1")
        call("dpkg-deb", "-x", path, root)
    check_programs(packages["widefov"], root, build)
    check_desktop(root)
    use(root, work, sys.argv[3:])
    print("packages: " + ", ".join(os.path.basename(path) for path in packages.values()))


if __name__ == "__main__":
    main()
