#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Documentation/drawables.md from what the tests of this folder found.

    write_page.py BUILD > Documentation/drawables.md

BUILD is the folder of a build in which `ctest -L drawables` has run.
"""

import json
import os
import sys

HEAD = """# What of VTK is drawn how

Everything that draws in Python's vtk {version}, and what works on pictures or finds what is in them, in a
`vtkWideFoVRenderer`: made by the test that is named, and written from its results by `python3 Testing/Drawables/write_page.py build` after `ctest --test-dir build -L drawables`. `right`
is the picture of stock VTK's six faces of 90 degrees, but for 0.3 % of what is covered, of a thing ahead of, beside and
behind the eye. What is not listed, a class of a program's own say, is drawn right as long as it draws by actors, or by
mappers of VTK's with a prop that hands its keys on. Whatever draws by shaders of its own alone shows nothing, and one
warning names it.

What a prop is made of is drawn as if each part stood in the scene by itself, whether the prop names its parts or keeps
them to itself. The latter holds for those made after the library was loaded: parts that were made before, and that
the prop does not name, are left out with the same warning.

Passes over the picture (`vtkGaussianBlurPass`, `vtkSSAAPass`, `vtkToneMappingPass`, `vtkOpenGLFXAAPass`,
`vtkSobelGradientMagnitudePass`, ..) draw the wide view, where a `vtkWideFoVRenderer` has them:
round its own pass, or in its place. At the borders of a picture they know no neighbours on the other side. Left out
with one warning each: `vtkEDLShading`, `vtkDepthOfFieldPass`, `vtkSSAOPass`, `vtkShadowMapPass`, `UseSSAO`, `UseShadows`,
which take the picture's depths for those of a perspective, and `vtkPanoramicProjectionPass`. A pass of a class that VTK does not have is called as it is.
An active camera that is not wide draws a flat picture, with one warning. (Test `Drawables.passes`.)
"""

TITLES = {
    "props": "Props",
    "mappers": "Mappers",
    "representations": "Representations of widgets",
    "widgets": "Widgets",
    "renderpasses": "Render passes",
    "pickers": "Pickers",
}


def section(kind, found):
    lines = ["", "## %s" % TITLES[kind], "", "Test `Drawables.%s`." % kind, ""]
    lines += ["| %s | state |" % TITLES[kind].lower(), "| --- | --- |"]
    lines += ["| `%s` | %s |" % (name, state) for name, state in found.items()]
    return lines


def main(build):
    lines = []
    version = None
    for kind in TITLES:
        path = os.path.join(build, "Testing", "Drawables", "%s.json" % kind)
        with open(path, encoding="utf-8") as file:
            results = json.load(file)
        version = results["version"]
        lines += section(kind, results[kind])
    print(HEAD.format(version=version) + "\n".join(lines))
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("write_page.py: name the folder of a build")
    sys.exit(main(sys.argv[1]))
