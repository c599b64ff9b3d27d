#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that Documentation/debug-view.md shows the colours that the debug view has.

    check_debug_colors.py ROOT

Every WFV_COLOR_ constant of the shader has its row, with its value, and no other has one.
"""

import os
import re
import sys

PAGE = "Documentation/debug-view.md"
SHADER = "Module/Shaders/common/debug_kinds.glsl"
CONSTANT = re.compile(r"const vec3 (WFV_COLOR_\w+) = vec3\(([^)]*)\);")
ROW = re.compile(r"\| `(WFV_COLOR_\w+)` \| ([0-9., ]+) \|")


def read(root, path, pattern):
    with open(os.path.join(root, path), encoding="utf-8") as stream:
        return dict(pattern.findall(stream.read()))


def main():
    if len(sys.argv) != 2 or not os.path.isfile(os.path.join(sys.argv[1], PAGE)):
        sys.exit("check_debug_colors.py: name the root of the checkout")
    shader = read(sys.argv[1], SHADER, CONSTANT)
    page = read(sys.argv[1], PAGE, ROW)
    wrong = 0 if shader else 1
    for name in sorted(set(shader) | set(page)):
        if shader.get(name) != page.get(name):
            print("%s: %s is %s, not %s" % (PAGE, name, shader.get(name), page.get(name)))
            wrong += 1
    print("debug colours: %d in the shader, %d wrong" % (len(shader), wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
