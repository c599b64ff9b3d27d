# SPDX-License-Identifier: BSD-3-Clause
"""Which files of the checkout the style checks read."""

import os

SKIPPED_FOLDERS = {".git", "output", "__pycache__"}

CPP = (".h", ".cxx")
SHADERS = (".glsl",)
SHELL = (".sh", ".bash", ".ci/run")
SCRIPTS = (".py", ".cmake") + SHELL
TEXT = (
    CPP
    + SHADERS
    + SCRIPTS
    + (".md", ".txt", ".in", ".json", ".module", ".xml", ".yml", ".yaml", ".pvx", ".qrc", ".plugin")
    + (".clang-format", ".clang-tidy", ".codespellrc", ".shellcheckrc", ".supp")
)


class Source:
    """One text file: path relative to the root (with /), text and lines."""

    def __init__(self, root, path):
        self.path = path
        with open(os.path.join(root, path), encoding="utf-8") as stream:
            self.text = stream.read()
        self.lines = self.text.split("\n")
        if self.lines[-1] == "":
            self.lines.pop()

    def is_kind(self, endings):
        return self.path.endswith(tuple(endings))

    @property
    def is_code(self):
        """True for what is written by hand in a language, as against prose and data."""
        name = self.path.rsplit("/", 1)[-1]
        return (
            self.is_kind(CPP + SHADERS + SCRIPTS)
            or name == "CMakeLists.txt"
        )


def is_skipped(root, folder):
    """True for folders that hold nothing of ours: build trees, pictures, caches."""
    name = os.path.basename(folder)
    at_top = os.path.dirname(folder) == root
    return name in SKIPPED_FOLDERS or (at_top and (name == "build" or name.startswith("build-")))


def find_sources(root):
    """Every text file below root, sorted by path."""
    root = os.path.abspath(root)
    found = []
    for folder, children, names in os.walk(root):
        children[:] = sorted(c for c in children if not is_skipped(root, os.path.join(folder, c)))
        for name in sorted(names):
            path = os.path.relpath(os.path.join(folder, name), root).replace(os.sep, "/")
            if path.endswith(TEXT):
                found.append(Source(root, path))
    return found
