# SPDX-License-Identifier: BSD-3-Clause
"""The table of bad input: one row a case."""

import os
from collections import namedtuple

from inputs import ENDINGS
from lenses import LENSES
from projectors import PROJECTORS
from rooms import ROOM

DONE, FAILED, USAGE = 0, 1, 2

# arguments: the command line, blanks between; {out} is the folder for outputs. A row
#            that does not name --output gets two: a file that exists and one that does not.
# code:      the exit code of the contract.
# says:      what the one line on standard error must hold, besides the program's name.
# place:     "plain", or how the outputs' folder or the process is hampered (runner.py).
# env:       changes to the environment; None removes a variable.
Case = namedtuple("Case", "arguments code says place env", defaults=("plain", {}))


# Both eyes of a small scene.
EYES = "good.vtk --stereo omnidirectional "


def usage(arguments, says):
    return Case(arguments, USAGE, says)


def failed(arguments, says, **more):
    return Case(arguments, FAILED, says, **more)


COMMAND_LINE = [
    usage("", "FILE"),
    usage("good.vtk --frobnicate", "--frobnicate"),
    usage("good.vtk -z", "-z"),
    usage("good.vtk --hfov", "--hfov"),
    usage("good.vtk --zenith 0,0,2", "--zenith"),
    usage("good.vtk --zenith 0,0,1 --projection perspective --hfov 90 --vfov 60", "--zenith"),
    usage("--scene nowhere", "nowhere"),
    usage("good.vtk --projection bent", "bent"),
    usage("good.vtk --technique magic", "magic"),
    usage("good.vtk --depth cubic", "cubic"),
    usage("good.vtk --depth log --technique cubemap", "cubemap"),
    usage("good.vtk --debug-view --projection perspective --vfov 60", "perspective"),
    usage("good.vtk --debug-view --exact-perspective --projection perspective --hfov 170", "stock VTK"),
    usage("good.vtk --dump-shaders {out} --projection perspective --vfov 60", "--dump-shaders"),
    usage("good.vtk --dump-shaders {out} --technique cubemap", "--dump-shaders"),
    usage("good.vtk --size 64", "--size"),
    usage("good.vtk --size 0x32", "--size"),
    usage("good.vtk --size -64x32", "--size"),
    usage("good.vtk --size 64x32x2", "--size"),
    usage("good.vtk --size 1e3x32", "--size"),
    usage("good.vtk --size 99999999999x32", "--size"),
    usage("good.vtk --hfov 0", "hfov"),
    usage("good.vtk --hfov -90", "-90"),
    usage("good.vtk --hfov 360.5", "360.5"),
    usage("good.vtk --hfov nan", "nan"),
    usage("good.vtk --hfov inf", "inf"),
    usage("good.vtk --hfov 90deg", "90deg"),
    usage("good.vtk --vfov 181", "181"),
    usage("good.vtk --projection hammer --vfov 200", "200"),
    usage("good.vtk --projection perspective --hfov 180 --vfov 90", "180"),
    usage("good.vtk --projection azimuthal-equidistant --fov 361", "361"),
    usage("good.vtk --projection mercator --vfov 180", "infinitely far"),
    usage("good.vtk --projection orthographic --fov 181", "181"),
    usage("good.vtk --projection equi-angular-cubemap --hfov 90", "whole sphere"),
    usage("good.vtk --projection direction-map", "--direction-map"),
    usage("good.vtk --direction-map map.exr", "direction-map alone"),
    usage("good.vtk --projection direction-map --direction-map map.exr --hfov 90", "its file"),
    usage("good.vtk --tilt nan", "nan"),
    usage("good.vtk --clip 2,1", "near"),
    usage("good.vtk --clip 1,1", "near"),
    usage("good.vtk --clip 0,1", "near"),
    usage("good.vtk --clip -1,1", "near"),
    usage("good.vtk --clip 1,inf", "1,inf"),
    usage("good.vtk --clip 1", "--clip"),
    usage("good.vtk --projection azimuthal-equidistant --lens 1,-1", "lens"),
    usage("good.vtk --projection azimuthal-equidistant --lens -0.3", "lens"),
    usage("good.vtk --projection azimuthal-equidistant --lens nan", "--lens"),
    usage("good.vtk --projection azimuthal-equidistant --lens 1,0,0,0,0,0,0,0,0,0", "--lens"),
    usage("good.vtk --lens 0.3", "lens"),
    usage("good.vtk --eye 1,2", "1,2"),
    usage("good.vtk --eye 1,2,nan", "1,2,nan"),
    usage("good.vtk --direction 0,0,0", "--direction"),
    usage("good.vtk --up 0,0,0", "--up"),
    usage("good.vtk --up 0,0,1 --direction 0,0,-1", "--up"),
    usage("good.vtk --eye 1,2,3 --look-at 1,2,3", "--look-at"),
    usage("good.vtk --inside --outside", "--outside"),
    usage("good.vtk --outside --eye 1,2,3", "--eye"),
    usage("good.vtk --volume --no-volume", "--no-volume"),
    usage("--info", "--info"),
    usage("--info --scene room", "--info"),
    usage("good.vtk --tolerance 0", "--tolerance"),
    usage("good.vtk --tolerance nan", "--tolerance"),
    usage("good.vtk --samples -1", "--samples"),
    usage("good.vtk --samples many", "--samples"),
    usage("good.vtk --frames -1", "--frames"),
    usage("good.vtk --range 2,1", "--range"),
    usage("good.vtk --range 0,nan", "--range"),
    usage("good.vtk --stereo cross-eyed", "cross-eyed"),
    usage("good.vtk --stereo omni", "did you mean omnidirectional"),
    usage("good.vtk --time nan", "--time: 'nan' is not a finite number"),
    usage("good.vtk --sky map.exr --output map.exr", "map.exr is an input file"),
    usage("good.vtk --lens-file lens.yml --stats lens.yml", "lens.yml is an input file"),
    usage("good.vtk --screens cave.pvx --stats cave.pvx", "cave.pvx is an input file"),
    usage("good.vtk --pose six.txt --stats six.txt", "six.txt is an input file"),
    usage("good.vtk --stereo omnidirectional --layout cardboard", "cardboard"),
    usage(EYES + "--layout multi-view", ".exr"),
    usage(EYES + "--layout vr180", "--hfov 180"),
    usage(EYES + "--layout vr180 --hfov 180 --vfov 90", "--vfov 180"),
    usage(EYES + "--layout vr180 --projection hammer --hfov 180 --vfov 180", "equirectangular"),
    usage(EYES + "--layout frame-sequential", "widefov-viewer"),
    usage(EYES + "--letterbox 0.5", "--letterbox"),
    usage(EYES + "--floating-window 0.1", "--floating-window"),
    usage("good.vtk --stereo warped --floating-window nan", "--floating-window"),
    usage("good.vtk --stereo warped --offset automatic", "--offset"),
    usage("good.vtk --stereo warped --convergence auto", "--convergence"),
    usage(EYES + "--output {out}/eyes.vr.jpg", "VR180"),
    usage(EYES + "--anaglyph red", "LEFT,RIGHT"),
    usage(EYES + "--anaglyph red,pink", "pink"),
    usage(EYES + "--anaglyph red,magenta", "both eyes"),
    usage(EYES + "--anaglyph-saturation 2", "--anaglyph-saturation"),
    usage(EYES + "--anaglyph-saturation nan", "--anaglyph-saturation"),
    usage(EYES + "--layout left --anaglyph red,cyan", "--layout anaglyph"),
    usage("good.vtk --anaglyph red,cyan", "--anaglyph does not go with --stereo mono"),
    usage("good.vtk --layout left", "--layout does not go with --stereo mono"),
    usage("good.vtk --ipd 0.1", "--ipd"),
    usage("good.vtk --stereo omnidirectional --separation 0.1", "--separation"),
    usage("good.vtk --stereo omnidirectional --ipd -1", "--ipd"),
    usage("good.vtk --stereo omnidirectional --convergence auto", "give a distance"),
    usage("good.vtk --stereo omnidirectional --ipd 2 --convergence 1", "inside the circle"),
    usage("good.vtk --stereo omnidirectional --ipd nan", "--ipd"),
    usage("good.vtk --stereo omnidirectional --ipd inf", "--ipd"),
    usage("good.vtk --stereo omnidirectional --pole-fade 60", "--pole-fade"),
    usage("good.vtk --stereo omnidirectional --pole-fade 60,40", "pole fade"),
    usage("good.vtk --stereo omnidirectional --pole-fade 0,100", "pole fade"),
    usage("good.vtk --stereo omnidirectional --projection perspective", "offaxis"),
    usage("good.vtk --stereo warped --projection perspective", "offaxis"),
    usage("good.vtk --stereo warped --iod nan", "--iod"),
    usage("good.vtk --stereo warped --offset -2", "--offset"),
    usage("good.vtk --stereo warped --distance 0.1", "in front of the whole cube"),
    usage("good.vtk --stereo warped --ipd 1", "--ipd does not go with --stereo warped"),
    usage("good.vtk --stereo offaxis", "perspective"),
    usage("good.vtk --stereo offaxis --projection perspective --separation 2", "--separation"),
    usage("good.vtk --stereo offaxis --projection perspective --convergence 0", "--convergence"),
    usage("good.vtk --stereo offaxis --projection perspective --convergence nan", "nan"),
    usage("good.vtk --stereo omnidirectional --technique cubemap", "cubemap"),
    usage("good.vtk --stereo omnidirectional --aov {out}/data.exr", "--aov is for one eye"),
    usage("good.vtk --representation cloudy", "cloudy"),
    usage("good.vtk --colormap mud", "mud"),
    usage("good.vtk --line-width 0", "--line-width"),
    usage("good.vtk --point-size -2", "--point-size"),
    usage("good.vtk --output {out}/picture.xyz", "picture.xyz"),
    usage("good.vtk --output {out}/picture", "picture"),
    usage("good.vtk --aov {out}/data.png", "data.png"),
    usage("good.vtk --tile 64", "--tile"),
    usage("good.vtk --tile 0x16", "--tile"),
    usage("good.vtk --tile 32x32 --technique cubemap", "--tile"),
    usage("good.vtk --tile 32x32 --stereo omnidirectional --layout split", "--tile"),
]

COMMAND_LINE += [
    usage("good.vtk --preset dome", "dome"),
    usage("good.vtk --preset domemaster-4", "did you mean domemaster-"),
    usage("good.vtk --preset vr180 --hfov 90", "--hfov 180"),
    failed("good.vtk --config missing.conf", "missing.conf"),
    failed("good.vtk --config folder.vtk", "folder.vtk"),
    usage("good.vtk --config unknown.conf", "unknown.conf, line 2: there is no option --hfvo"),
    usage("good.vtk --config wrong.conf", "wrong.conf, line 1: --hfov"),
    usage("good.vtk --config words.conf", "words.conf, line 1"),
    usage("good.vtk --config noise.vtk", "is not of the form NAME = VALUE"),
    usage("good.vtk --quiet --verbose", "--verbose"),
    usage("good.vtk --background slategry", "did you mean slategray"),
    usage("good.vtk --background '#12345'", "#12345"),
    usage("good.vtk --ipd auto", "--ipd does not go with --stereo mono"),
    usage("good.vtk --stereo warped --ipd auto", "--ipd does not go with --stereo warped"),
    usage(EYES + "--layout separate --output -", "takes one picture"),
    usage("good.vtk --output - --stats -", "named twice"),
    usage("- - --output new.png", "named twice"),
    failed("-", "standard input is empty"),
    usage("good.vtk --completion fish", "fish"),
    failed("--list-arrays missing.vtk", "missing.vtk"),
    failed("--list-arrays truncated.vtk", "truncated.vtk"),
]

DATA = [
    failed("missing.vtk", "missing.vtk"),
    failed("good.vtk missing.vtk", "missing.vtk"),
    failed("folder.vtk", "folder.vtk"),
    failed("loop.vtk", "loop.vtk"),
    failed("pipe.vtk", "pipe.vtk"),
    failed("unknown.abc", "unknown.abc: there is no reader for '.abc'; convert it to one of .vtk .vtp"),
    failed("some.xdmf", "there is no reader for '.xdmf'; ParaView or meshio saves it as .vtu"),
    failed("some.nrrd", "there is no reader for '.nrrd'; 3D Slicer or SimpleITK saves it as .mha"),
    failed("short.xyz", "line 2 is not 3 numbers"),
    failed("no-places.csv", "it has no columns x, y and z"),
    failed("words.ply", "1 of vertex, but only the first 0 are whole"),
    failed("type.ply", "its header has the unknown type 'foo'"),
    failed("no-place.ply", "its vertices have no x, y and z"),
    failed("no-ending", "no-ending"),
    failed("truncated.vtk", "truncated.vtk"),
    failed("truncated.vtp", "truncated.vtp"),
    failed("truncated.ply", "12 of vertex, but only the first 2 are whole"),
    failed("truncated-header.ply", "truncated-header.ply"),
    failed("truncated-face.ply", "4 of face, but only the first 3 are whole"),
    failed("truncated-little.ply", "4 of face, but only the first 3 are whole"),
    failed("truncated-big.ply", "4 of face, but only the first 2 are whole"),
    failed("negative-list.ply", "4 of face, but only the first 3 are whole"),
    failed("no-points.vtk", "no-points.vtk"),
    failed("negative-count.vtk", "negative-count.vtk"),
    failed("huge-count.vtk", "huge-count.vtk"),
    failed("wrong-index.vtk", "wrong-index.vtk"),
    failed("negative-index.vtk", "negative-index.vtk"),
    failed("only-nan.vtk", "only-nan.vtk"),
    failed("empty-data.vtp", "empty-data.vtp: no points or cells; there is nothing to draw"),
    failed("good.vtk --color-by cold", "cold"),
    failed("good.vtk --color-by wind:7", "wind"),
    failed("good.vtk --vectors cold", "cold"),
    failed("good.vtk --vectors heat", "heat"),
    failed("good.vtk --streamlines cold", "cold"),
    failed("good.vtk --streamlines heat", "heat"),
    failed("good.vtk --volume", "--volume"),
    failed("missing.vtk --info", "missing.vtk"),
    failed("truncated.ply --info", "truncated.ply"),
]
MAP = "good.vtk --projection direction-map --direction-map "
DATA += [
    failed(MAP + "missing.exr", "missing.exr"),
    failed(MAP + "good.vtk", "OpenEXR"),
    failed(MAP + "map.exr --size 64x16", "64x32"),
    failed(MAP + "map-nan.exr", "column 5 of row 3"),
    failed(MAP + "map-infinite.exr", "not a number"),
    failed(MAP + "map-long.exr", "length"),
    failed(MAP + "map-empty.exr", "no pixel"),
    failed(MAP + "map-channels.exr", "channels U, V"),
    failed(MAP + "map-line.exr --size 64x1", "2 x 2"),
    failed(MAP + "map-cut.exr", "map-cut.exr"),
]
SKY = "good.vtk --sky "
DATA += [
    failed(SKY + "missing.hdr", "missing.hdr is not there"),
    failed(SKY + "good.vtk", "no picture"),
    failed(SKY + "map-cut.exr", "map-cut.exr"),
]
DATA += [failed("empty." + ending, "empty." + ending) for ending in ENDINGS]
DATA += [failed("noise." + ending, "noise." + ending) for ending in ENDINGS]

# What can be drawn is drawn; what cannot is named in one line each.
TOLERATED = [
    Case("nan.vtk", DONE, "nan.vtk"),
    Case("infinite.vtk", DONE, "infinite.vtk"),
    Case("zero-area.vtk", DONE, None),
    Case("only-zero-area.vtk", DONE, None),
    Case("no-cells.vtk", DONE, None),
    Case("good.vtk", DONE, None),
    Case(SKY + "map-nan.exr", DONE, None),
    Case(SKY + "map-infinite.exr", DONE, None),
    Case("good.ply", DONE, None),
    Case("good.ply --scalar-bar", DONE, "nothing here is coloured by numbers; there is no bar for --scalar-bar"),
    Case("empty-data.vtp good.vtk", DONE, "empty-data.vtp has no points or cells, and is left out"),
    Case("little.ply", DONE, None),
    Case("big.ply", DONE, None),
    Case("good.vtk --stereo omnidirectional --ipd 100", DONE, "--ipd 100 is larger"),
    Case("good.vtk --stereo omnidirectional --ipd 1e-6", DONE, "nobody sees depth"),
    Case("good.vtk --stereo omnidirectional --ipd 0.5", DONE, "uncomfortable"),
    Case("good.vtk --stereo omnidirectional --ipd 0.5 --quiet", DONE, None),
    Case("good.vtk --stereo omnidirectional --ipd auto", DONE, None),
    Case(MAP + "map.exr", DONE, None),
]

# No display that can be opened: where VTK opens windows without one, that is no fault.
NO_DISPLAY = (DONE, None) if os.environ.get("WIDEFOV_NEEDS_DISPLAY") == "OFF" else (FAILED, "xvfb-run")

DISPLAY = [
    Case("good.vtk", *NO_DISPLAY, env={"DISPLAY": name, "VTK_DEFAULT_OPENGL_WINDOW": None})
    for name in (None, ":54321", "no such display")
]
DISPLAY += [
    failed("good.vtk", "OpenGL", env={"MESA_GL_VERSION_OVERRIDE": "3.1"}),
    failed("good.vtk", "OpenGL", env={"MESA_GL_VERSION_OVERRIDE": "2.1"}),
    failed("good.vtk --size 40000x16 --technique cubemap", "40000"),
]

OUTPUT = [
    failed("good.vtk --output {out}/nowhere/picture.png", "nowhere"),
    failed("good.vtk --output good.vtk/picture.png", "good.vtk"),
    failed("good.vtk --output {out}/folder.png", "folder.png", place="folder in the way"),
    failed("good.vtk --output /proc/picture.png", "/proc"),
    failed("good.vtk --aov {out}/nowhere/data.exr", "nowhere"),
    failed("good.vtk --stats {out}/nowhere/stats.json", "nowhere"),
    failed("good.vtk --dump-shaders {out}/nowhere", "nowhere"),
    failed("good.vtk --dump-shaders {out}/old.png", "old.png"),
    failed("good.vtk --output new.png --dump-shaders {out}", "read-only", place="read-only"),
    failed("good.vtk --output new.png --dump-shaders {out}", "programs.txt", place="full disk"),
    failed("good.vtk", "old.png", place="read-only"),
    failed("good.vtk --size 512x256", "old.png", place="full disk"),
    failed("good.vtk --size 512x256", "old.png", place="file size limit"),
    failed("good.vtk --size 512x256 --output {out}/new.exr", "new.exr", place="full disk"),
    failed("good.vtk --size 512x256 --output {out}/new.jpg", "new.jpg", place="full disk"),
    failed("good.vtk --size 512x256 --output {out}/new.tif", "new.tif", place="full disk"),
    failed("good.vtk --size 512x256 --aov {out}/new.exr", "new.exr", place="full disk"),
    failed("good.vtk --size 70000x2 --output {out}/new.jpg", "65500"),
    failed("--list-projections", "", place="full standard output"),
    failed("--list-scenes", "", place="full standard output"),
    failed("--help", "", place="full standard output"),
    failed("good.vtk --output -", "standard output", place="full standard output"),
    failed("--info good.vtk", "", place="full standard output"),
]

TILED = "good.vtk --size 512x256 --tile 128x96 "
OUTPUT += [
    failed(TILED, "old.png", place="full disk"),
    failed(TILED, "old.png", place="file size limit"),
    failed(TILED + "--output {out}/new.exr", "new.exr", place="full disk"),
    failed(TILED + "--output {out}/new.jpg", "new.jpg", place="full disk"),
    failed(TILED + "--output {out}/new.tif", "new.tif", place="full disk"),
    failed(TILED + "--output {out}/new.tif", "new.tif", place="file size limit"),
    failed(TILED + "--aov {out}/new.exr", "new.exr", place="full disk"),
]

# Of widefov-viewer: what it does not share with widefov-render.
VIEWER = [
    usage("", "FILE"),
    usage("good.vtk --preset dome", "dome"),
    usage("good.vtk --config unknown.conf", "line 2"),
    usage("good.vtk --frobnicate", "--frobnicate"),
    usage("good.vtk --output {out}/picture.png", "--output"),
    usage("good.vtk --projection bent", "bent"),
    usage("good.vtk --hfov nan", "nan"),
    usage("good.vtk --up 0,0,1 --direction 0,0,-1", "--up"),
    usage("good.vtk --monitor -1", "--monitor"),
    usage("good.vtk --monitor one", "--monitor"),
    usage("good.vtk --wall 2", "--wall"),
    usage("good.vtk --wall 0x1", "--wall"),
    usage("good.vtk --wall 2x2x2", "--wall"),
    usage("good.vtk --wall x", "--wall"),
    usage("good.vtk --wall 2x1 --projection perspective --vfov 60", "--wall"),
    usage("good.vtk --wall 2x1 --technique cubemap", "--wall"),
    usage("good.vtk --wall 2x1 --monitor 1", "--wall"),
    usage("good.vtk --screens cave.pvx --wall 2x1", "--wall"),
    usage("good.vtk --screens cave.pvx --monitor 1", "--monitor"),
    usage("good.vtk --screens cave.pvx --projection hammer", "perspective"),
    usage("good.vtk --pose-rate 10", "--pose FILE"),
    usage("good.vtk --pose-once", "--pose FILE"),
    usage("good.vtk --pose six.txt --pose-rate nan", "--pose-rate"),
    usage("good.vtk --pose six.txt --pose-rate -1", "--pose-rate"),
    failed("good.vtk --screens both.pvx --full-screen", "no monitor 2"),
    failed("good.vtk --pose back.txt", "back.txt, pose 3 is earlier"),
    failed("good.vtk --pose still.txt", "give --pose-rate"),
    Case("good.vtk --pose back.txt --pose-rate 100", DONE, None),
    Case("good.vtk --screens both.pvx --pose six.txt --pose-once", DONE, None),
    Case("good.vtk --screens cave.pvx --stereo offaxis", DONE, None),
    Case("good.vtk --screens cave.pvx --stereo warped --offset -0.5", DONE, None),
    usage("good.vtk --frames -1", "--frames"),
    usage("good.vtk --frames many", "--frames"),
    usage("good.vtk --log ''", "--log"),
    failed("missing.vtk", "missing.vtk"),
    failed("truncated.vtk", "truncated.vtk"),
    failed("good.vtk --color-by cold", "cold"),
    failed("good.vtk --log {out}/nowhere/viewer.log", "nowhere"),
    failed("good.vtk --log {out}", "--log"),
    failed("good.vtk --log /dev/full", "/dev/full"),
    failed("good.vtk --monitor 9 --full-screen", "no monitor 9"),
    Case(EYES + "--ipd auto --layout frame-sequential", DONE, "in turn by software"),
    usage(EYES + "--layout vr180 --hfov 180 --vfov 180", "--layout vr180 is for files"),
    usage(EYES + "--layout multi-view", "--layout multi-view is for files"),
    failed("good.vtk --wall 9x1 --full-screen", "no monitor"),
    failed("good.vtk --size 40000x16 --technique cubemap", "40000"),
    failed("good.vtk", "display", env={"DISPLAY": None}),
    failed("good.vtk", "display", env={"DISPLAY": ":54321"}),
    failed("good.vtk", "OpenGL", env={"MESA_GL_VERSION_OVERRIDE": "3.1"}),
    failed("good.vtk", "OpenGL", env={"MESA_GL_VERSION_OVERRIDE": "2.1"}),
    failed("--help", "", place="full standard output"),
    failed("--list-scenes", "", place="full standard output"),
    Case("good.vtk --samples 64", DONE, "--samples"),
    Case("good.vtk", DONE, None),
    Case("nan.vtk", DONE, "nan.vtk"),
    Case("good.vtk --size 1x1", DONE, None),
    Case("good.vtk --wall 2x2", DONE, None),
    Case("good.vtk --full-screen --monitor 1", DONE, None),
    Case(MAP + "map.exr", DONE, None),
    Case("--help", DONE, None),
    Case("--version", DONE, None),
]

# Broken files of screens and poses: the same lines as of widefov-render.
VIEWER += [failed("good.vtk " + words, says) for words, code, says in ROOM if code == FAILED]

GROUPS = {
    "CommandLine": COMMAND_LINE,
    "Lenses": [Case("good.vtk " + arguments, code, says) for arguments, code, says in LENSES],
    "Projectors": [Case("good.vtk " + arguments, code, says) for arguments, code, says in PROJECTORS],
    "Room": [Case("good.vtk " + arguments, code, says) for arguments, code, says in ROOM],
    "Data": DATA,
    "Tolerated": TOLERATED,
    "Display": DISPLAY,
    "Output": OUTPUT,
    "Viewer": VIEWER,
}
