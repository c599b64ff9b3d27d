# SPDX-License-Identifier: BSD-3-Clause
"""Two eyes: each eye's picture by both techniques against the ray caster with the same stereo model,
and ParaView's own stereo types, which show the same two pictures."""

import itertools
import os

from paraview import simple

import pixels
import scene

EYES = {"Left Eye Only": -1, "Right Eye Only": 1}

HITS = 0.1  # of the pixels

# Settings; and how many pixels of an eye's picture may be wrong, of the faded one where Exact draws it.
# Else the picture is as the technique promises.
MODELS = {
    "omnidirectional": ({"InterpupillaryDistance": 0.6}, None),
    "faded": ({"InterpupillaryDistance": 0.6, "PoleFade": [20, 60]}, 0),
    "dome": ({"Projection": "azimuthal-equidistant", "HorizontalFieldOfView": 180, "Tilt": 90,
              "InterpupillaryDistance": 0.4}, None),
    # the module's search along a curve misses a few (Documentation/stereo.md); small, for the
    # ray caster searches along them as well
    "warped": ({"ViewSize": [96, 48], "Projection": "hammer", "StereoModel": "warped", "WarpedStereo": [0.3, 5, -0.8],
                "AutomaticClipSpheres": 0, "ClipSpheres": [0.5, 30]}, 5),
    # stock VTK's perspective, whose depth buffer mistakes a few
    "offaxis": ({"Projection": "perspective", "HorizontalFieldOfView": 90,
                 "VerticalFieldOfView": 60, "StereoModel": "offaxis", "Separation": 0.05,
                 "Convergence": 4}, 8),
}


def has_no_more(options, view, mesh, picture, most, side):
    """Whether no more pixels than these are farther off than the rays of the pixels."""
    answer = scene.check_cells(options, view, mesh, picture, scene.EXACT, side)
    print(picture, answer, flush=True)
    return answer["unexplained"] <= most and answer["hits"] > HITS * answer["pixels"]


def check_eye(options, view, mesh, name, most, mode):
    side = EYES[mode]
    path = os.path.join(options.output, "%s %d.png" % (name, side))
    picture = scene.save(view, path, StereoMode=mode)
    width, height = view.ViewSize
    good = (scene.keeps_promise(options, view, mesh, picture, HITS * width * height, side)
            if most is None else has_no_more(options, view, mesh, picture, most, side))
    scene.require(good, "%s %s" % (name, mode))
    return picture


def read(path):
    with open(path, "rb") as file:
        return file.read()


def check_files(options, view, eyes):
    """Both eyes at once are the same pictures, a file each; no stereo is neither."""
    both = scene.save(view, os.path.join(options.output, "both.png"), StereoMode="Both Eyes")
    for eye, name in zip(eyes, ("both_left.png", "both_right.png")):
        scene.require(read(eye) == read(os.path.join(options.output, name)), name)
    scene.require(not os.path.exists(both), "a third picture")
    mono = scene.save(view, os.path.join(options.output, "mono.png"), StereoMode="No stereo")
    for eye in eyes:
        other = pixels.count_different(pixels.read_rows(mono), pixels.read_rows(eye))
        scene.require(other > 100, "an eye is in the middle")


def check_types(options, view, eyes):
    """Types that show each pixel of one eye or of the other."""
    left, right = (pixels.read_rows(eye) for eye in eyes)
    view.StereoRender = 1
    for kind in ("Interlaced", "Checkerboard"):
        view.StereoType = kind
        rows = pixels.read_rows(scene.save(view, os.path.join(options.output, kind + ".png")))
        neither = sum(
            pixel not in (a, b)
            for row, x, y in zip(rows, left, right) for pixel, a, b in zip(row, x, y)
        )
        of_left, of_right = (pixels.count_different(rows, eye) for eye in (left, right))
        print(kind, neither, "pixels of neither eye", of_left, of_right)
        scene.require(neither == 0 and min(of_left, of_right) > 100, kind)
    view.StereoRender = 0


def main(options):
    scene.load_plugin(options)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    view = scene.make_view()
    scene.show_cells(simple.XMLPolyDataReader(FileName=[mesh]), view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    defaults = {name: view.GetProperty(name).GetData() for settings, _ in MODELS.values()
                for name in settings}
    for technique, name in itertools.product(("Exact", "Automatic"), MODELS):
        settings, most = MODELS[name]
        for key, value in {**defaults, **settings, "Technique": technique}.items():
            setattr(view, key, value)
        few = None if technique == "Automatic" and name == "faded" else most
        eyes = [check_eye(options, view, mesh, name + " " + technique, few, mode) for mode in EYES]
        differ = pixels.count_different(*(pixels.read_rows(eye) for eye in eyes))
        scene.require(differ > 100, name + ": the eyes see the same")
        if name == "omnidirectional":
            check_files(options, view, eyes)
            check_types(options, view, eyes)


scene.run(main)
