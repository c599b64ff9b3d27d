#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shows that the style checks fail where they should: a tidy checkout passes, and each
seeded breach is found, by the rule it breaks and in the file that breaks it."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
LICENCE = "SPDX-License-Identifier: BSD-3-" + "Clause"
HEAD = "// " + LICENCE + "\n"


def long_function(lines):
    """A function of this many lines, braces and signature included."""
    return "int Long()\n{\n" + "  Step();\n" * (lines - 4) + "  return 0;\n}\n"


# The initializer list counts: 40 lines in all.
LONG_CONSTRUCTOR = (
    "namespace a\n{\nA::A()\n  : B{ 1 }\n{\n" + "  Step();\n" * 36 + "}\n}\n"
)

TIDY = {
    "Module/Projections/Map.h": HEAD + "#include <cmath>\n",
    "Module/Metadata/Tags.h": HEAD + "#include <string>\n",
    "Module/Stereo/Eyes.h": HEAD + '#include "Map.h"\n',
    "Module/Stereo/none.glsl": HEAD,
    "Module/Projections/map.glsl": HEAD + "// y = sin(phi)\nvec2 sc = wfvSinCos(phi);\n",
    "Module/Stereo/offaxis.glsl": HEAD,
    "Module/Camera/vtkWideFoVCamera.h": HEAD + "// offaxis is for a perspective\n",
    "Module/Shaders/Text.h": HEAD + '#include "Eyes.h"\n// Off-axis projection: none\n',
    "Module/Frame/Part.h": HEAD + '#include "Text.h"\n',
    "Module/vtkWide.h": HEAD + '#include "Map.h"\n#include "vtkObject.h"\n',
    "Module/Shaders/eye.glsl": HEAD + "bool left = wfvView.eye == WFV_EYE_LEFT;\n",
    "Module/Shaders/stage.glsl": HEAD + "void main()\n{\n  gl_Position = vec4(0.0);\n}\n",
    "Module/vtkWide.cxx": HEAD + '#include "vtkWide.h"\n\n// gl_Position: see the shader\n'
    + "const Size s{ 1 };\n"
    + long_function(39),
    "Programs/Text/Tool.h": HEAD + '#include "vtkWide.h"\n',
    "Programs/Text/CMakeLists.txt": "# " + LICENCE + "\nwidefov_add_library(Text Tool.cxx)\n",
    "Programs/Scenes/Scene.h": HEAD + '#include "Text/Tool.h"\n',
    "Programs/Scenes/Shown.h": HEAD + '#include "Scene.h"\n',
    "Programs/Scenes/CMakeLists.txt": "# " + LICENCE + "\nwidefov_add_library(Scenes Scene.cxx)\n",
    "Plugin/Compat/Parts.h": HEAD + '#include "Map.h"\n',
    "Plugin/Views/View.h": HEAD + '#include "Parts.h"\n',
    "Testing/Unit/TestTool.cxx": HEAD + '#include "Tool.h"\n#include "Map.h"\n',
    "Testing/helper.py": "# " + LICENCE + "\n\n\ndef helper():\n    return 1\n",
}

# rule, file, its text
BREACHES = [
    ("pure mathematics", "Module/Projections/Map.h", HEAD + "#include <vtkMath.h>\n"),
    ("pure mathematics", "Module/Stereo/Eyes.h", HEAD + '# include "vtkWide.h"\n'),
    ("one way", "Module/Projections/Map.h", HEAD + '#include "Eyes.h"\n'),
    ("sine", "Module/Projections/map.glsl", HEAD + "float y = sin(phi);\n"),
    ("sine", "Module/Stereo/none.glsl", HEAD + "float x = 2.0 * tan (phi);\n"),
    ("one way", "Module/vtkWide.h", HEAD + '#include "Tool.h"\n'),
    ("one way", "Module/vtkWide.h", HEAD + '#include "Tags.h"\n'),
    ("one way", "Module/Frame/Part.h", HEAD + '#include "vtkWide.h"\n'),
    ("one way", "Module/Shaders/Text.h", HEAD + '#include "Part.h"\n'),
    ("one way", "Module/Compat/Old.h", HEAD + '#include "Eyes.h"\n'),
    ("one way", "Programs/Text/Tool.h", HEAD + '#include "../Testing/Unit/Check.h"\n'),
    ("one way", "Programs/Text/Tool.cxx", HEAD + '#include "Scenes/Scene.h"\n'),
    ("one way", "Plugin/Compat/Parts.cxx", HEAD + '#include "View.h"\n'),
    ("circle", "Programs/Scenes/Scene.h", HEAD + '#include "Shown.h"\n'),
    ("target", "Programs/Scenes/CMakeLists.txt", "# " + LICENCE + "\nadd_library(a A.cxx)\nadd_library(b B.cxx)\n"),
    ("target", "Programs/Else/Else.cxx", HEAD),
    ("function length", "Module/vtkWide.cxx", HEAD + long_function(40)),
    ("function length", "Module/Shaders/stage.glsl", HEAD + long_function(40)),
    ("function length", "Module/vtkWide.cxx", HEAD + LONG_CONSTRUCTOR),
    ("function length", "Testing/helper.py", "# " + LICENCE + "\ndef f():\n" + "    g()\n" * 39),
    ("source length", "Module/vtkWide.cxx", HEAD + "int i;\n" * 900),
    ("source length", "Module/Shaders/stage.glsl", HEAD + "const int WFV_A = 1;\n" * 250),
    ("directives", "Module/Shaders/stage.glsl", HEAD + "#if WFV_A\n#endif\n" * 6 + "#define WFV_B\n"),
    ("shader text", "Module/vtkWide.cxx", HEAD + 'const char* s = "void main() {}";\n'),
    ("shader text", "Module/vtkWide.cxx", HEAD + 'const char* s = "gl_Position = p;";\n'),
    ("licence", "Module/vtkWide.cxx", "int i;\n"),
    ("licence", "CMakeLists.txt", "project(X)\n"),
    ("licence", "Testing/run.sh", "#!/bin/bash\n"),
    ("versions", "Module/vtkWide.cxx", HEAD + "#if VTK_VERSION_NUMBER > 90300\n#endif\n"),
    ("versions", "Programs/Text/Tool.h", HEAD + "#if __has_include(<vtk_glad.h>)\n#endif\n"),
    ("versions", "Testing/CMakeLists.txt", "# " + LICENCE + "\nif(VTK_VERSION LESS 9.3)\n"),
    ("versions", "Plugin/Views/V.cxx", HEAD + "#if PARAVIEW_VERSION_NUMBER > 51100\n#endif\n"),
    ("versions", "Plugin/Window/W.cxx", HEAD + "#elif QT_VERSION > 6\n#endif\n"),
    ("versions", "Testing/CMakeLists.txt", "# " + LICENCE + "\nif(NOT PARAVIEW_QT_MAJOR_VERSION)\n"),
    ("versions", "Module/vtkWide.cxx", HEAD + "auto v = glGetString(GL_RENDERER);\n"),
    ("namespace", "Module/vtkWide.h", HEAD + "class vtkActor;\n"),
    ("namespace", "Module/vtkWide.h", HEAD + "class A_EXPORT vtkWide : public vtkObject\n{\n};\n"),
    ("stereo model", "Module/Shaders/stage.glsl", HEAD + "#if WFV_OFFAXIS\n#endif\n"),
    ("stereo model", "Module/Shaders/off-axis.glsl", HEAD),
    ("stereo model", "Module/Shaders/a.glsl", HEAD + "bool left = wfvView.stereo.x < 0.0;\n"),
    ("stereo model", "Module/Shaders/a.glsl", HEAD + "bool left = wfvView.eye < 0;\n"),
    ("stereo model", "Module/Shaders/a.glsl", HEAD + "float side = float(wfvView.eye);\n"),
    ("stereo model", "Module/vtkWide.cxx", HEAD + "double r = std::abs(v.stereo.x);\n"),
    ("stereo model", "Module/vtkWide.cxx", HEAD + "bool Off(Model m) { return IsOffAxis(m); }\n"),
    ("stereo model", "Programs/Text/Tool.h", HEAD + 'bool b = name == "none";\n'),
    ("stereo model", "Plugin/View.xml.in", "<Default model=\"offaxis\" />\n"),
    ("drawable", "Module/vtkWide.cxx", HEAD + 'bool b = m->IsA("vtkGlyph3DMapper");\n'),
    ("unset", "Module/Shaders/a.glsl", HEAD + "float wfvDepth = 0.0;\nvec3 wfvTop; // up\n"),
    ("machine path", "README.md", "see /" + "home/somebody/file\n"),
    ("machine path", "CMakeLists.txt", "# " + LICENCE + '\nset(x "/' + 'work/x")\n'),
]


class Checkout:
    """A checkout of a few files in a folder of its own."""

    def __init__(self, files):
        self.root = tempfile.mkdtemp(prefix="style-")
        for path, text in files.items():
            full = os.path.join(self.root, path)
            os.makedirs(os.path.dirname(full), exist_ok=True)
            with open(full, "w", encoding="utf-8") as stream:
                stream.write(text)
        for name in (".clang-format", ".codespellrc", ".shellcheckrc"):
            shutil.copy(os.path.join(ROOT, name), self.root)

    def __enter__(self):
        return self.root

    def __exit__(self, *_):
        shutil.rmtree(self.root)


def run(check, *arguments):
    """Exit code and output of one of the checks."""
    command = [sys.executable, os.path.join(HERE, check), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


class StructureCheck(unittest.TestCase):
    def test_tidy_checkout_passes(self):
        with Checkout(TIDY) as root:
            status, output = run("check_structure.py", root)
            self.assertEqual(status, 0, output)

    def test_each_breach_is_found(self):
        for rule, path, text in BREACHES:
            files = {**TIDY, "Testing/Unit/Check.h": HEAD, path: text}
            with self.subTest(rule=rule, path=path), Checkout(files) as root:
                status, output = run("check_structure.py", root)
                self.assertEqual(status, 1, output)
                lines = output.splitlines()
                self.assertEqual(len(lines), 1, "one breach, one line: " + output)
                self.assertTrue(lines[0].startswith(path + ":"), output)
                self.assertIn(": " + rule + ": ", lines[0])

    def test_build_trees_are_not_read(self):
        with Checkout({**TIDY, "build/x.cxx": "no licence\n", "build-2/x.cxx": "\n"}) as root:
            self.assertEqual(run("check_structure.py", root)[0], 0)


class ToolChecks(unittest.TestCase):
    def test_format(self):
        for text, expected in (("int i = 0;\n", 0), ("int  i=0 ;\n", 1)):
            with Checkout({"Module/vtkWide.cxx": HEAD + text}) as root:
                self.assertEqual(run("check_tool.py", "format", root)[0], expected)

    def test_spelling(self):
        for word, expected in (("receive", 0), ("reci" + "eve", 1)):
            with Checkout({"README.md": "We " + word + " it.\n"}) as root:
                self.assertEqual(run("check_tool.py", "spelling", root)[0], expected)

    @unittest.skipUnless(shutil.which("shellcheck"), "no ShellCheck")
    def test_shell(self):
        head = "#!/usr/bin/env bash\n# " + LICENCE + "\n"
        for text, expected in (('rm -- "$1"\n', 0), ("rm -- $1\n", 1)):
            for path in ("Testing/run.sh", "Examples/render.bash", ".ci/run"):
                with Checkout({path: head + text}) as root:
                    self.assertEqual(run("check_tool.py", "shell", root)[0], expected)

    @unittest.skipUnless(shutil.which("doxygen"), "no Doxygen")
    def test_api(self):
        rules = "Documentation/Doxyfile"
        with open(os.path.join(ROOT, rules), encoding="utf-8") as stream:
            files = {rules: stream.read()}
        head = HEAD + "#ifndef A_h\n/**\n * @class vtkA\n * @brief a\n */\n"
        text = "class vtkA\n{\npublic:\n%s  vtkSetMacro(Size, int);\n\nprotected:\n  int Size;\n};\n#endif\n"
        for comment, expected in (("  /// Pixels.\n", 0), ("", 1)):
            files["Module/vtkA.h"] = head + text % comment
            with Checkout(files) as root:
                for folder in ("Camera", "Projections"):
                    os.makedirs(os.path.join(root, "Module", folder))
                status, output = run("check_api.py", root)
                self.assertEqual(status, expected, output)
                self.assertEqual("SetSize" in output, expected == 1, output)

    def test_tolerances(self):
        row = "| `Limit` | `%s` | pixels | what | [Limit.h](../Module/Limit.h) |\n"
        source = HEAD + "constexpr double Limit = 0.25; // pixels\n"
        for value, expected in (("0.25", 0), ("0.2", 1), ("0.25` broken", 1)):
            page = {"Documentation/tolerances.md": row % value, "Module/Limit.h": source}
            with Checkout(page) as root:
                self.assertEqual(run("check_tolerances.py", root)[0], expected)


if __name__ == "__main__":
    unittest.main()
