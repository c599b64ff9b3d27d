#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the checkout keeps its structure.

    check_structure.py ROOT

Rules: dependencies run one way, and in Programs never in a circle; a folder of Programs is a target;
the mathematics knows no VTK; functions and sources
stay short; shaders are .glsl files, with few lines of the preprocessor; every source names
its licence; nothing names a folder of somebody's machine; what differs between versions of VTK, or between drivers of
OpenGL, is guarded in Module/Compat alone, and what differs between those of ParaView in
Plugin/Compat alone; headers declare VTK's classes in VTK's namespace; every variable of a shader
begins with a value; no source outside Module/Stereo names a stereo model, or takes the eye for a
number; only Module/Drawables/Kinds, and Compat, ask for a mapper or an actor by the name of its
class. Prints `path:line: rule: what is wrong` for every breach and exits with 1 when
there is one.
"""

import os
import re
import sys

from circles import find_circle
from functions import cpp_functions, python_functions, without_comments
from sources import CPP, SHADERS, find_sources

MAX_FUNCTION_LINES = 39  # "under 40": what fits a screen
MAX_SOURCE_LINES = 900  # a class is in one file, and has one idea
MAX_SHADER_LINES = 250  # a file has one question of a stage
MAX_DIRECTIVES = 12  # of the preprocessor, in a shader; what more of them choose from are files
MANY_DIRECTIVES = ("Module/Shaders/lines/",)  # which have more of them still

# Floors, from the ground up; folders in one row do not know each other. A folder includes from itself
# and from the floors below it.
MODULE = (
    ("Module/Projections",),
    ("Module/Stereo", "Module/Compat", "Module/Presets"),
    ("Module/Drawables/Kinds",),
    ("Module/Camera", "Module/Refine"),
    ("Module/Shaders",),
    ("Module/Drawables",),
    ("Module/Frame",),
    ("Module",),  # the public classes
)
PROGRAMS = (
    ("Programs/Text",),
    ("Programs/System",),
    ("Programs/Scenes",),
    ("Programs/Options",),
    ("Programs/Pictures",),
    ("Programs/Film",),
    ("Programs/Web",),
    ("Programs/Viewing", "Programs/Run/Wishes"),
    ("Programs/Render", "Programs/Viewer", "Programs/Run", "Programs/Run/Loader", "Programs/Run/Overrides"),
)
PLUGIN = (
    ("Plugin/Compat",),
    ("Plugin/Views",),
    ("Plugin/Window",),
    ("Plugin",),
)


def stack(floors, below):
    """Folder -> folders whose headers it may include: below, the floors under it and itself."""
    allowed, below = {}, set(below)
    for floor in floors:
        for folder in floor:
            allowed[folder] = below | {folder}
        below |= set(floor)
    return allowed


def reachable():
    """Folder -> folders whose headers it may include. The longest matching folder counts."""
    allowed = stack(MODULE, ())
    # libraries of their own, which the module knows nothing of
    allowed["Module/Metadata"] = {"Module/Metadata"}
    allowed["Module/Displays"] = {"Module/Displays", "Module/Projections"}
    module = set(allowed)
    allowed.update(stack(PROGRAMS, module))
    allowed.update(stack(PLUGIN, module))
    tools = module | {"Testing/Tools"} | {folder for row in PROGRAMS for folder in row}
    allowed["Testing/Tools"] = tools  # know no test
    allowed["Testing"] = tools | {"Testing"}
    return allowed


MAY_INCLUDE = reachable()
PURE = ("Module/Displays", "Module/Metadata", "Module/Presets", "Module/Projections", "Module/Stereo")

# Text that belongs to a shader, and the files that may hold it because they rewrite
# the text of VTK's own shaders.
SHADER_TEXT = re.compile(r"\bvoid\s+main\b|\bgl_Position\b|\bEmitVertex\b|#version\s+\d")
REWRITES_SHADERS = ("Module/Shaders/ShaderBuilder.cxx", "Module/Compat/StockEdits.cxx")

# Guards, and the folders that they are looked for in and belong into.
VERSION_GUARD = re.compile(
    r"^[ \t]*#[ \t]*(?:el)?if\b.*\b(?:(?:VTK|PARAVIEW|QT)_\w*VERSION\w*|__has_include)\b"
    r"|^[ \t]*(?:else)?if *\(.*\b(?:VTK|ParaView|PARAVIEW|QT)_\w*VERSION",
    re.M,
)
DRIVER_GUARD = re.compile(r"\bGL_(?:VENDOR|RENDERER|VERSION)\b")  # elsewhere they are shown
GUARDED = ("Module/", "Programs/", "Testing/", "Plugin/")
COMPAT = {"Module/": "Module/Compat/", "Plugin/": "Plugin/Compat/"}  # elsewhere the module's
IN_NAMESPACE = ("Module/", "Programs/", "Testing/")  # ParaView's own classes are in none

# VTK's own, or written beside them: in C++ headers these stand between two words of VTK's.
VTK_CLASS = re.compile(r"^(?:class|struct)\s+(?:\w+_EXPORT\s+)?vtk\w+(?!\w|::)")
VTK_NAMESPACE = re.compile(r"^VTK_ABI_NAMESPACE_(BEGIN|END)\b")

# Of a shader, outside its functions. Arrays are left alone: loops fill them.
UNBEGUN = re.compile(r"^(?:float|double|u?int|bool|[biud]?vec[234]) (\w+);")

# A projection's forward is drawn with: its sines are as good as the rays' own.
MAPS = ("Module/Projections/", "Module/Stereo/")
BUILT_IN_SINE = re.compile(r"\b(?:sin|cos|tan)\s*\(")

# The models are the shaders of their folder. Everything else asks for traits (StereoTraits) and
# numbers (StereoNumber); people choose by name, so the camera's header says the names, and setters
# keep theirs.
MODELS = "Module/Stereo/"
ASKS_NO_MODEL = ("Module/", "Plugin/", "Programs/")
CHOOSES_MODELS = ("Module/Camera/vtkWideFoVCamera.h",)
SAME_WORDS = re.compile(
    r"\b(?:[SG]et)?Warped(?:Stereo|Viewer)\b|off-?axis.?projection", re.I  # the latter is VTK's
)

OWN_NUMBERS = re.compile(r"\.stereo\b")  # of WfvView

# The eye has names, too: nobody reckons with it, nor asks those numbers for a sign.
EYE_AS_NUMBER = re.compile(
    r"\.(?:eye|stereo\.\w)\s*(?:[<>]|\*|[!=]=\s*-?\d)"
    r"|\b(?:abs|sign)\([\w.>-]*\.(?:eye|stereo\.\w)\b"
    r"|\b(?:float|double)>?\([\w.>-]*\.eye\b"
)

# What a kind of drawable is, is asked for by its traits.
KIND = re.compile(r'(?:IsA\(|strcmp\(.*|[!=]= *)"vtk\w*(?:Mapper|Helper|Actor|Volume)\w*"')
KINDS = ("Module/Drawables/Kinds/", "Module/Compat/")

# Calls of CMake that make a target of a folder of Programs.
TARGET = re.compile(r"^(?:widefov_)?add_(?:library|executable)\(", re.M)
TARGETS = "Programs/"

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">]', re.M)

# Written in pieces, so that this file does not match itself.
MACHINE_PATH = re.compile(
    r"(?<![\w.$}>-])/(?:" + "|".join(["work", "home", "root", "Users", "mnt", "tmp"]) + r")/\w"
)

SPDX = "SPDX-License-Identifier: BSD-3-" + "Clause"


def folder_of(path):
    """The key of MAY_INCLUDE that a path belongs to, or None."""
    fitting = [folder for folder in MAY_INCLUDE if path.startswith(folder + "/")]
    return max(fitting, key=len) if fitting else None


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def check_includes(source, headers):
    """One way only; `headers` maps a file's name to the paths that bear it."""
    home = folder_of(source.path)
    if home is None or not source.is_kind(CPP + SHADERS):
        return
    for match in INCLUDE.finditer(without_comments(source.text)):
        name = os.path.basename(match.group(2))
        line = line_of(source.text, match.start())
        if home in PURE and name.startswith("vtk"):
            yield line, "pure mathematics", "%s includes %s, but knows no VTK" % (home, name)
            continue
        homes = {folder_of(path) for path in headers.get(name, [])} - {None}
        if homes and not homes & MAY_INCLUDE[home]:
            yield line, "one way", "%s includes %s of %s" % (home, name, sorted(homes)[0])


def check_circles(sources, headers):
    """A header and its source are one; within a folder no chain of includes comes back to where it began."""
    graph = {}
    for source in sources:
        if source.path.startswith(TARGETS) and source.is_kind(CPP):
            own = os.path.splitext(source.path)[0]
            names = [os.path.basename(m.group(2)) for m in INCLUDE.finditer(without_comments(source.text))]
            found = {os.path.splitext(path)[0] for name in names for path in headers.get(name, [])}
            near = {path for path in found if os.path.dirname(path) == os.path.dirname(own)}
            graph.setdefault(own, set()).update(near - {own})
    circle = find_circle(graph)
    if circle:
        path = next(s.path for s in sources if os.path.splitext(s.path)[0] == circle[0] and s.is_kind(CPP))
        chain = " includes ".join(os.path.basename(name) for name in circle + circle[:1])
        yield path, 1, "circle", chain


def check_targets(sources):
    """One folder of Programs, one target."""
    lists = {os.path.dirname(s.path): s for s in sources if s.path.endswith("/CMakeLists.txt")}
    folders = {os.path.dirname(s.path): s.path for s in sources if s.is_kind(CPP)}
    for folder, path in sorted(folders.items()):
        if not folder.startswith(TARGETS):
            continue
        if folder not in MAY_INCLUDE or folder not in lists:
            yield path, 1, "target", "a folder without a floor here or without a CMakeLists.txt"
            continue
        made = TARGET.findall(lists[folder].text)
        if len(made) != 1:
            yield lists[folder].path, 1, "target", "%d targets, not one" % len(made)


def check_length(source):
    """Short functions, short sources."""
    if not source.is_code:
        return
    most = MAX_SHADER_LINES if source.is_kind(SHADERS) else MAX_SOURCE_LINES
    if len(source.lines) > most:
        text = "%d lines, at most %d" % (len(source.lines), most)
        yield most + 1, "source length", text
    functions = []
    if source.is_kind(CPP + SHADERS):
        functions = cpp_functions(source.text)
    elif source.is_kind((".py",)):
        functions = python_functions(source.text)
    for name, first, lines in functions:
        if lines > MAX_FUNCTION_LINES:
            text = "%s has %d lines, at most %d" % (name, lines, MAX_FUNCTION_LINES)
            yield first, "function length", text


def check_directives(source):
    """Variants of a stage are files that C++ puts together."""
    if not source.is_kind(SHADERS) or source.path.startswith(MANY_DIRECTIVES):
        return
    directives = [n for n, line in enumerate(source.lines, 1) if line.lstrip().startswith("#")]
    if len(directives) > MAX_DIRECTIVES:
        text = "%d lines of the preprocessor, at most %d" % (len(directives), MAX_DIRECTIVES)
        yield directives[MAX_DIRECTIVES], "directives", text


def check_shaders(source):
    """Shaders live in .glsl files, where tools and people find them."""
    if not source.is_kind(CPP) or source.path in REWRITES_SHADERS:
        return
    if source.path.startswith("Testing/"):
        return  # tests compare shader text
    for match in SHADER_TEXT.finditer(without_comments(source.text)):
        line = line_of(source.text, match.start())
        yield line, "shader text", "'%s' belongs into a .glsl file" % match.group()


def check_licence(source):
    if source.is_code and not any(SPDX in line for line in source.lines[:3]):
        yield 1, "licence", "no line '%s' among the first three" % SPDX


def check_paths(source):
    for number, line in enumerate(source.lines, 1):
        match = MACHINE_PATH.search(line)
        if match:
            yield number, "machine path", "'%s...' exists on one machine only" % match.group()


def check_versions(source):
    """One place for what differs between versions."""
    if not source.is_code or not source.path.startswith(GUARDED) or source.is_kind((".py", ".sh")):
        return
    if source.path.startswith(tuple(COMPAT.values())):
        return
    folder = source.path[: source.path.index("/") + 1]
    guards = list(VERSION_GUARD.finditer(source.text))
    if source.path.startswith("Module/"):
        guards += DRIVER_GUARD.finditer(source.text)
    for match in guards:
        yield line_of(source.text, match.start()), "versions", (
            "guards belong into " + COMPAT.get(folder, COMPAT["Module/"])
        )


def check_namespace(source):
    """VTK may have a namespace, in which its classes are."""
    if not source.path.startswith(IN_NAMESPACE):
        return
    inside = False
    for number, line in enumerate(source.lines if source.is_kind((".h",)) else [], 1):
        word = VTK_NAMESPACE.match(line)
        inside = word.group(1) == "BEGIN" if word else inside
        if VTK_CLASS.match(line) and not inside:
            yield number, "namespace", "'%s' outside VTK_ABI_NAMESPACE_BEGIN, _END" % line


def check_begun(source):
    """Mesa 26 warns of variables of a shader that have no value in the order of its text."""
    if not source.is_kind((".glsl",)):
        return
    for number, line in enumerate(source.lines, 1):
        match = UNBEGUN.match(line)
        if match:
            yield number, "unset", "'%s' begins without a value" % match.group(1)


def check_kinds(source):
    """One registry of drawables."""
    if not source.path.startswith("Module/") or source.path.startswith(KINDS):
        return
    if not source.is_kind(CPP):
        return
    for number, line in enumerate(source.lines, 1):
        match = KIND.search(line)
        if match:
            yield number, "drawable", "%s: ask for its traits, HasTrait" % match.group()


def check_sines(source):
    """How exact GLSL's own functions of angles are is up to the driver."""
    if not source.is_kind(SHADERS) or not source.path.startswith(MAPS):
        return
    for match in BUILT_IN_SINE.finditer(without_comments(source.text)):
        line = line_of(source.text, match.start())
        yield line, "sine", "'%s': take wfvSinCos, which every driver has alike" % match.group()


def check_models(source, models):
    """Only the models know which of them is which; `models`: their names."""
    path = source.path
    if not path.startswith(ASKS_NO_MODEL) or path.startswith(MODELS) or path in CHOOSES_MODELS:
        return
    if not models or not source.is_kind(CPP + SHADERS + (".in", ".xml")):
        return
    # a short one may be a word as well: only what is quoted asks for it
    names = ['"%s"' % name if len(name) < 5 else name for name in models]
    asks = re.compile("|".join(re.escape(name) for name in names), re.I)
    for number, line in enumerate([path] + source.lines):
        match = asks.search(SAME_WORDS.sub("", line).replace("-", ""))
        if match:
            yield max(number, 1), "stereo model", "'%s': ask for its traits" % match.group()
        elif source.is_kind(SHADERS) and OWN_NUMBERS.search(line):
            yield number, "stereo model", "the numbers are its own: ask for the eye and halfEyes"
        elif EYE_AS_NUMBER.search(line):
            yield number, "stereo model", "an eye has a name: WFV_EYE_LEFT, wfvToRight"


CHECKS = (
    check_length, check_directives, check_shaders, check_licence, check_paths, check_versions, check_namespace,
    check_begun, check_kinds, check_sines,
)


def breaches(root):
    """Every breach below root, as printable lines."""
    sources = find_sources(root)
    headers = {}
    for source in sources:
        headers.setdefault(os.path.basename(source.path), []).append(source.path)
    models = [
        os.path.basename(source.path)[: -len(".glsl")]
        for source in sources
        if source.path.startswith(MODELS) and source.is_kind(SHADERS)
    ]
    for path, line, rule, text in list(check_circles(sources, headers)) + list(check_targets(sources)):
        yield "%s:%d: %s: %s" % (path, line, rule, text)
    for source in sources:
        for check in CHECKS:
            for line, rule, text in check(source):
                yield "%s:%d: %s: %s" % (source.path, line, rule, text)
        others = list(check_includes(source, headers)) + list(check_models(source, models))
        for line, rule, text in others:
            yield "%s:%d: %s: %s" % (source.path, line, rule, text)


def main():
    if len(sys.argv) != 2 or not os.path.isdir(sys.argv[1]):
        sys.exit("check_structure.py: name the root of the checkout")
    found = list(breaches(sys.argv[1]))
    print("\n".join(found) if found else "structure: nothing to complain about")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
