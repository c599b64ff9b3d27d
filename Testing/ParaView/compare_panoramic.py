# SPDX-License-Identifier: BSD-3-Clause
"""The view beside ParaView's Panoramic Projection View: the same pipelines, one run.

Writes comparison.json into the output folder and prints the table of
Documentation/paraview.md. Pixels that show the wrong cell by the double-precision ray
caster, and the times of frames drawn in turns. The panoramic view draws cubes of W / pi
pixels, as dense as the picture, and of 500, its default.
"""

import glob
import json
import math
import os
import statistics
import time

from paraview import simple

import scene

SIZE = [1024, 512]
ROUND = [512, 512]
FRAMES = 41  # after two that compile and upload
# below the prefix, of whatever version and machine
PANORAMIC = "lib/*/paraview-*/plugins/PanoramicProjectionView/PanoramicProjectionView.so"


def make_views(size, wide_settings, panoramic_settings):
    """The wide view, and the panoramic one with both cubes."""
    dense = max(100, round(SIZE[0] / math.pi))
    views = {"wide": scene.make_view(size, **wide_settings)}
    for resolution in (dense, 500):
        views["cube of %d" % resolution] = scene.make_view(
            size,
            kind="PanoramicProjectionView",
            CubeResolution=resolution,
            CubemapInterpolation=0,
            **panoramic_settings
        )
    for view in views.values():
        view.UseFXAA = 0  # a setting of the application, which each new view brings back
    return views


def time_frames(views):
    """Median of a frame of each over one of the wide view: drawn in turns, so that whatever else the
    machine does befalls all of them alike."""
    times = {name: [] for name in views}
    for frame in range(FRAMES + 2):
        for name, view in views.items():
            # a new frame needs something new
            view.CameraPosition = [0.5 + 1e-4 * frame, 0.3, 1]
            begin = time.perf_counter()
            simple.Render(view)
            view.GetRenderWindow().WaitForCompletion()
            if frame > 1:
                times[name].append(1000 * (time.perf_counter() - begin))
    return {
        name: statistics.median(ours / wide for ours, wide in zip(t, times["wide"]))
        for name, t in times.items()
    }


def show_lit(source, view):
    """One colour and ParaView's own light, as data are shown at first."""
    display = simple.Show(source, view)
    display.ColorArrayName = [None, ""]
    display.MapScalars = 1
    display.Interpolation = "Gouraud"
    display.Ambient = 0
    display.Diffuse = 1
    display.Specular = 0


def compare(options, case, mesh_path, projection, views):
    """The records of one scene in one projection."""
    source = simple.XMLPolyDataReader(FileName=[mesh_path])
    records = []
    request = {"projection": projection, "hfov": 360, "vfov": 180, "clip": scene.EVERYTHING}
    if projection == "azimuthal-equidistant":
        request["hfov"] = request["vfov"] = 180
    for name, view in views.items():
        scene.show_cells(source, view)
        scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
        picture = os.path.join(options.output, "%s %s %s.png" % (case, projection, name))
        scene.save(view, picture)
        answer = scene.check(options, dict(request, **scene.pose_of(view)), mesh_path, picture, 0.25)
        records.append({"scene": case, "projection": projection, "view": name, **answer})
    times = time_frames(views)
    for view in views.values():
        show_lit(source, view)
    lit = time_frames(views)
    for record in records:
        record["time"] = times[record["view"]]
        record["time_lit"] = lit[record["view"]]
        record.pop("worst")
    for view in views.values():
        simple.Hide(source, view)
    return records


def print_table(records):
    print("| scene | projection | view | unexplained pixels | worst, pixels | time, wide = 1 | lit |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for r in records:
        worst = "over 64" if r["max_px"] is None else "%.4f" % r["max_px"]
        print("| %s | %s | %s | %d | %s | %.2f | %.2f |" % (
            r["scene"], r["projection"], r["view"], round(r["unexplained"]), worst,
            r["time"], r["time_lit"]))


def main(options):
    scene.load_plugin(options)
    prefix = os.environ["WIDEFOV_PARAVIEW_PREFIX"]
    (peer,) = glob.glob(os.path.join(prefix, PANORAMIC))
    simple.LoadPlugin(peer, False, vars(simple))
    meshes = {}
    for case, parts in (
        ("contours", [scene.make_sphere(), scene.make_contours()]),
        ("sphere", [scene.make_sphere()]),
    ):
        mesh = scene.triangles_of(*parts)
        scene.number_cells(mesh)
        meshes[case] = os.path.join(options.output, case + ".vtp")
        scene.write_polydata(mesh, meshes[case])
    records = []
    views = make_views(SIZE, {}, {"ProjectionType": "Equirectangular", "ProjectionAngle": 360})
    for case, path in meshes.items():
        records += compare(options, case, path, "equirectangular", views)
    fisheye = {"Projection": "azimuthal-equidistant", "HorizontalFieldOfView": 180}
    views = make_views(
        ROUND, fisheye, {"ProjectionType": "Azimuthal (fish eye)", "ProjectionAngle": 180}
    )
    for case, path in meshes.items():
        records += compare(options, case, path, "azimuthal-equidistant", views)
    with open(os.path.join(options.output, "comparison.json"), "w") as out:
        json.dump(records, out, indent=1)
    print_table(records)


scene.run(main)
