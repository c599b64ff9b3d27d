# SPDX-License-Identifier: BSD-3-Clause
"""The view beside ParaView's Panoramic Projection View: the same pipelines, one run.

Writes comparison.json into the output folder and prints the tables of
Documentation/paraview.md. Pixels that show the wrong cell by the double-precision ray
caster, and the times of frames drawn in turns. The panoramic view draws cubes of W / pi
pixels, as dense as the picture, and of 500, its default. What turning about an eye amid usual
pipelines costs is timed beside the first of them alone, and first; with WIDEFOV_TURNING=1 nothing
else is, and WIDEFOV_FRAMES=N takes so many frames.
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
FRAMES = int(os.environ.get("WIDEFOV_FRAMES", "41"))  # after two that compile and upload
TURNING_SIZE = [800, 400]
TURN = 1  # degrees a frame
# below the prefix, of whatever version and machine
PANORAMIC = "lib/*/paraview-*/plugins/PanoramicProjectionView/PanoramicProjectionView.so"


def make_views(size, wide_settings, panoramic_settings, further=(500,)):
    """The wide view, and the panoramic one with a cube as dense as the picture, and further ones."""
    dense = max(100, round(max(size) / math.pi))
    views = {"wide": scene.make_view(size, **wide_settings)}
    for resolution in (dense, *further):
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


def step(view, frame):
    """A new frame needs something new."""
    view.CameraPosition = [0.5 + 1e-4 * frame, 0.3, 1]


def turn(view, frame):
    """About the eye."""
    angle = math.radians(20 + TURN * frame)
    view.CameraFocalPoint = [
        view.CameraPosition[0] + math.sin(angle), view.CameraPosition[1],
        view.CameraPosition[2] - math.cos(angle)]


def measure_frames(views, move):
    """Milliseconds of frames of each: drawn in turns, so that whatever else the machine does befalls
    all of them alike."""
    times = {name: [] for name in views}
    for frame in range(FRAMES + 2):
        for name, view in views.items():
            move(view, frame)
            begin = time.perf_counter()
            simple.Render(view)
            view.GetRenderWindow().WaitForCompletion()
            if frame > 1:
                times[name].append(1000 * (time.perf_counter() - begin))
    return times


def time_frames(views):
    """Median of a frame of each over one of the wide view."""
    times = measure_frames(views, step)
    return {
        name: statistics.median(ours / wide for ours, wide in zip(t, times["wide"]))
        for name, t in times.items()
    }


def make_pipelines():
    """What users show of a field, each round the origin: stream tubes, contours, glyphs, an outline."""
    wavelet = simple.Wavelet()
    gradient = simple.PythonCalculator(
        Input=wavelet, Expression="gradient(RTData)", ArrayName="slope")
    gradient.UpdatePipeline()  # a tracer of vectors that are not known yet has no lines
    lines = simple.StreamTracer(Input=gradient, Vectors=["POINTS", "slope"], SeedType="Point Cloud")
    lines.SeedType.Radius = 9
    lines.SeedType.NumberOfPoints = 200
    glyphs = simple.Glyph(
        Input=gradient, GlyphType="Arrow", OrientationArray=["POINTS", "slope"], ScaleFactor=0.8)
    glyphs.GlyphMode = "Every Nth Point"
    glyphs.Stride = 7
    return {
        "tubes": simple.Tube(Input=lines, Radius=0.1),
        "contours": simple.Contour(
            Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[120, 160, 180]),
        "glyphs": glyphs,
        "outline": simple.Outline(Input=wavelet),
    }


def count_cells(source):
    """The cells of a pipeline. A pipeline without cells is an error: there is nothing to measure."""
    source.UpdatePipeline()
    cells = source.GetDataInformation().GetNumberOfCells()
    if cells == 0:
        raise RuntimeError("%s has no cells" % source.GetXMLName())
    return cells


def time_turning():
    """The median frame of both views, their ratio and the number of cells, of each pipeline and of
    all at once."""
    views = make_views(
        TURNING_SIZE, {}, {"ProjectionType": "Equirectangular", "ProjectionAngle": 360}, ())
    wide, dense = views
    pipelines = make_pipelines()
    cells = {name: count_cells(pipeline) for name, pipeline in pipelines.items()}
    records = []
    for shown in [[name] for name in pipelines] + [list(pipelines)]:
        for view in views.values():
            for name in shown:
                show_lit(pipelines[name], view)
            scene.place_eye(view, [0.5, 0.3, 1], [0.5, 0.3, 0])
        times = measure_frames(views, turn)
        ms = {name: statistics.median(t) for name, t in times.items()}
        records.append({
            "pipeline": shown[0] if len(shown) == 1 else "all", "ms": ms, "cube": dense,
            "cells": sum(cells[name] for name in shown), "ratio": ms[wide] / ms[dense]})
        for view in views.values():
            for name in shown:
                simple.Hide(pipelines[name], view)
    for view in views.values():
        simple.Delete(view)
    return records


def print_turning(records):
    print("| pipeline | cells | wide, ms | %s, ms | ratio |" % records[0]["cube"])
    print("| --- | --- | --- | --- | --- |")
    for r in records:
        print("| %s | %d | %.1f | %.1f | %.2f |" % (
            r["pipeline"], r["cells"], r["ms"]["wide"], r["ms"][r["cube"]], r["ratio"]))


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


def compare_all(options):
    """The records of both scenes in both projections."""
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
    return records


def main(options):
    scene.load_plugin(options)
    prefix = os.environ["WIDEFOV_PARAVIEW_PREFIX"]
    (peer,) = glob.glob(os.path.join(os.path.abspath(prefix), PANORAMIC))
    simple.LoadPlugin(peer, False, vars(simple))
    turning = time_turning()
    print_turning(turning)
    records = [] if os.environ.get("WIDEFOV_TURNING") else compare_all(options)
    with open(os.path.join(options.output, "comparison.json"), "w") as out:
        json.dump({"turning": turning, "records": records}, out, indent=1)
    if records:
        print_table(records)


scene.run(main)
