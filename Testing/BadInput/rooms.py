# SPDX-License-Identifier: BSD-3-Clause
"""Screens and poses that cannot be: the files, and the rows that name them."""

FAILED, USAGE = 1, 2


def machine(name="Front", corners=None, more=""):
    """An element Machine; corners: attribute -> text, None leaves it out."""
    standard = {"LowerLeft": "-1 -1 -1", "LowerRight": "1 -1 -1", "UpperRight": "1 1 -1"}
    standard.update(corners or {})
    given = ['%s="%s"' % item for item in standard.items() if item[1] is not None]
    return '<Machine Name="%s" %s %s/>' % (name, " ".join(given), more)


def pvx(*elements, process="server"):
    head = '<?xml version="1.0" ?>\n<pvx>\n<Process Type="client" />\n<Process Type="%s">\n'
    return head % process + "\n".join(elements) + "\n</Process>\n</pvx>\n"


def with_corner(**corners):
    return pvx(machine(corners=corners))


STILL = "0 0 0 0 0 0 0 1\n"


def room_files():
    """File name -> text."""
    return {
        "cave.pvx": pvx(machine(), '<EyeSeparation Value="0.06"/>'),
        "both.pvx": pvx(machine("Left"), machine("Right")),
        "cut.pvx": pvx(machine())[:-40],
        "other.pvx": '<?xml version="1.0" ?>\n<VTKFile type="PolyData"/>\n',
        "none.pvx": pvx(),
        "client.pvx": pvx(machine(), process="client"),
        "corner.pvx": with_corner(UpperRight=None),
        "two.pvx": pvx(machine("Left"), machine(corners={"LowerRight": "1 -1"})),
        "word.pvx": with_corner(LowerLeft="-1 -1 left"),
        "nan.pvx": with_corner(LowerLeft="-1 nan -1"),
        "huge.pvx": with_corner(LowerLeft="-1 -1e999 -1"),
        "flat.pvx": with_corner(UpperRight="1 -1 -1"),
        "line.pvx": with_corner(UpperRight="3 -1 -1"),
        "skew.pvx": with_corner(UpperRight="1.2 1 -1"),
        "behind.pvx": with_corner(LowerLeft="1 -1 -1", LowerRight="-1 -1 -1", UpperRight="-1 1 -1"),
        "window.pvx": pvx(machine(more='Geometry="0x600+0+0"')),
        "eyes.pvx": pvx(machine(), '<EyeSeparation Value="-1"/>'),
        "six.txt": STILL,
        "words.txt": "# time x y z qx qy qz qw\n" + STILL + "1 left 0 0 0 0 0 1\n",
        "nan.txt": "0 nan 0 0 0 0 0 1\n",
        "short.txt": STILL + "1 0 0 0 0 0 0\n",
        "zero.txt": "0 0 0 0 0 0 0 0\n",
        "mixed.txt": STILL + "1 0 0 0 1\n",
        "back.txt": STILL + "2 0 0 0 0 0 0 1\n" + "1 0 0 0 0 0 0 1\n",
        "still.txt": STILL + STILL,
        "outside.txt": STILL + "1 0 0 -2 0 0 0 1\n",
    }


# Behind good.vtk on the command line; the exit code; what the one line must hold.
ROOM = [
    ("--screens cave.pvx --projection hammer", USAGE, "perspective"),
    ("--screens cave.pvx --hfov 90", USAGE, "corners"),
    ("--screens cave.pvx --preset vr180", USAGE, "--preset"),
    ("--screens cave.pvx --stereo offaxis --ipd auto", USAGE, "--ipd auto"),
    ("--screens cave.pvx --tilt 10", USAGE, "corners"),
    ("--screens cave.pvx --technique cubemap", USAGE, "cubemap"),
    ("--screens cave.pvx --stereo omnidirectional", USAGE, "offaxis"),
    ("--screens cave.pvx --stereo offaxis --separation 0.1", USAGE, "--separation"),
    ("--screens cave.pvx --ipd 0.1", USAGE, "--ipd"),
    ("--screens cave.pvx --stereo offaxis --ipd nan", USAGE, "--ipd"),
    ("--screens cave.pvx --room-scale 0", USAGE, "--room-scale"),
    ("--screens cave.pvx --room-scale nan", USAGE, "--room-scale"),
    ("--room-scale 2", USAGE, "--room-scale"),
    ("--pose six.txt --aov {out}/data.exr", USAGE, "--aov is for one picture"),
    ("--screens missing.pvx", FAILED, "missing.pvx"),
    ("--screens both.pvx --stereo warped", FAILED, "stands behind one"),
    ("--screens cave.pvx --stereo warped --iod 1", USAGE, "--iod"),
    ("--screens cave.pvx --stereo warped --offset 1", FAILED, "in front of the whole cube"),
    ("--screens folder.vtk", FAILED, "folder.vtk"),
    ("--screens pipe.vtk", FAILED, "pipe.vtk"),
    ("--screens empty.vtk", FAILED, "no XML"),
    ("--screens noise.vtk", FAILED, "no XML"),
    ("--screens good.vtk", FAILED, "no XML"),
    ("--screens cut.pvx", FAILED, "no XML"),
    ("--screens other.pvx", FAILED, "VTKFile"),
    ("--screens none.pvx", FAILED, "no screen"),
    ("--screens client.pvx", FAILED, "no screen"),
    ("--screens corner.pvx", FAILED, "(Front) has no UpperRight"),
    ("--screens two.pvx", FAILED, "two.pvx, machine 2 (Front): LowerRight"),
    ("--screens word.pvx", FAILED, "three numbers"),
    ("--screens nan.pvx", FAILED, "three numbers"),
    ("--screens huge.pvx", FAILED, "three numbers"),
    ("--screens flat.pvx", FAILED, "no area"),
    ("--screens line.pvx", FAILED, "no rectangle"),
    ("--screens skew.pvx", FAILED, "no rectangle"),
    ("--screens behind.pvx", FAILED, "screen Front: an eye is behind it"),
    ("--screens window.pvx", FAILED, "Geometry"),
    ("--screens eyes.pvx", FAILED, "EyeSeparation"),
    ("--screens cave.pvx --pose missing.txt", FAILED, "missing.txt"),
    ("--screens cave.pvx --pose folder.vtk", FAILED, "folder.vtk"),
    ("--pose empty.vtk", FAILED, "no pose"),
    ("--pose noise.vtk", FAILED, "noise.vtk"),
    ("--pose words.txt", FAILED, "words.txt, line 3: 'left'"),
    ("--pose nan.txt", FAILED, "line 1: 'nan'"),
    ("--pose short.txt", FAILED, "has 7 numbers"),
    ("--pose zero.txt", FAILED, "no turn"),
    ("--pose mixed.txt", FAILED, "mixed"),
    ("--screens cave.pvx --pose outside.txt", FAILED, "pose 2 of outside.txt"),
]
