# SPDX-License-Identifier: BSD-3-Clause
"""What the ParaView tests share: options, the view, scenes of numbered cells, the check."""

import argparse
import json
import os
import subprocess
import sys
import traceback

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkContourFilter, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

SIZE = [240, 120]

# Pixels: what the technique `auto` may be off by, the view's default.
TOLERANCE = 0.25

# Pixels: `exact`, which tests every ray, up to the rounding of its numbers.
EXACT = 0.02

# Clip spheres that hold the scene, as the automatic ones do.
EVERYTHING = [1e-3, 1e3]


def require(good, text):
    """Fails the test with this text."""
    if not good:
        raise AssertionError(text)


def run(main):
    """Runs a test. A failure ends the process at once, and with it its other ranks, which
    would wait for ever; sys.exit crashes in ParaView's own clean-up."""
    try:
        main(parse_arguments())
    except BaseException:  # whatever it was, it has to end here
        traceback.print_exc()
        sys.stdout.flush()
        os._exit(1)


def parse_arguments():
    """The options every test is called with; the output folder exists afterwards."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--plugin", required=True)
    parser.add_argument("--checker", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--server-ranks", type=int, default=0, help="of a server that draws")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    return options


def save_extracts(folder, frames):
    """Of all frames. ParaView 5.13 saves the first alone where it is not told."""
    settings = servermanager.misc.SaveAnimationExtracts()
    window = {"FrameWindow": [0, frames - 1]} if settings.GetProperty("FrameWindow") else {}
    simple.SaveExtracts(ExtractsOutputDirectory=folder, **window)


def load_plugin(options, remote=False):
    """ParaView 5.13 finds none by a relative path."""
    plugin = os.path.abspath(options.plugin)
    simple.LoadPlugin(plugin, remote=remote, ns=vars(simple))
    if remote:
        simple.LoadPlugin(plugin, remote=False, ns=vars(simple))


def make_view(size=None, kind="WideFoVView", **properties):
    """A view on black with nothing in it that is not data."""
    # no scene decides where the eye is
    simple._DisableFirstRenderCameraReset()
    view = simple.CreateView(kind)
    view.ViewSize = size or SIZE
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.UseFXAA = 0  # blends neighbours, whose numbers mean nothing then
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [0, 0, 0]
    for name, value in properties.items():
        setattr(view, name, value)
    return view


def place_eye(view, eye, focal, up=(0, 1, 0)):
    view.CameraPosition = eye
    view.CameraFocalPoint = focal
    view.CameraViewUp = up


def _make_numbers(count, first, per_number):
    colours = vtkUnsignedCharArray()
    colours.SetName("number")
    colours.SetNumberOfComponents(3)
    for i in range(count):
        n = first + i // per_number + 1
        colours.InsertNextTuple3(n >> 16, n >> 8 & 255, n & 255)
    return colours


def number_cells(mesh, first=0, per_number=1):
    """Colours that count the cells, from first + 1 on: a picture of the mesh in them says
    which cell each pixel shows. So many cells in a row may share a number."""
    numbers = _make_numbers(mesh.GetNumberOfCells(), first, per_number)
    mesh.GetCellData().AddArray(numbers)


def number_points(mesh):
    """Colours that count the points."""
    mesh.GetPointData().AddArray(_make_numbers(mesh.GetNumberOfPoints(), 0, 1))


def triangles_of(*algorithms):
    """One mesh of bare triangles."""
    both = vtkAppendPolyData()
    for algorithm in algorithms:
        both.AddInputConnection(algorithm.GetOutputPort())
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(both.GetOutputPort())
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    mesh = vtkPolyData()
    mesh.CopyStructure(triangles.GetOutput())
    return mesh


def make_sphere():
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(48)
    sphere.SetPhiResolution(48)
    sphere.SetRadius(2)
    sphere.SetCenter(4, 1, -3)
    return sphere


def make_contours():
    wavelet = vtkRTAnalyticSource()
    contour = vtkContourFilter()
    contour.SetInputConnection(wavelet.GetOutputPort())
    contour.GenerateValues(2, 120, 180)
    return contour


def write_mesh(path):
    """A sphere and the contours of a wavelet, round the origin, as one file of triangles."""
    mesh = triangles_of(make_sphere(), make_contours())
    number_cells(mesh)
    write_polydata(mesh, path)
    return mesh


def write_polydata(mesh, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(mesh)
    writer.Write()


def spread(source):
    """The surface of the source, a part of it on each rank."""
    parts = simple.RedistributeDataSet(Input=source)
    parts.BoundaryMode = "Assign to one region"
    return simple.ExtractSurface(Input=parts)


def show_cells(source, view):
    """Shows the numbers as they are: no light, no colour map, no interpolation."""
    display = simple.Show(source, view)
    display.Representation = "Surface"
    simple.ColorBy(display, ("CELLS", "number"))
    show_as_numbers(display)
    return display


def show_as_numbers(display):
    display.MapScalars = 0
    display.Interpolation = "Flat"
    display.Ambient = 1
    display.Diffuse = 0
    display.Specular = 0


def save(view, path, size=None, **options):
    simple.SaveScreenshot(path, view, ImageResolution=size or list(view.ViewSize), **options)
    return path


def pose_of(view):
    return {
        "eye": list(view.CameraPosition),
        "focal": list(view.CameraFocalPoint),
        "up": list(view.CameraViewUp),
    }


def check(options, request, mesh_path, picture_path, tolerance):
    """The checker's answer about a saved picture of numbered cells."""
    request = dict(request, mesh=mesh_path, picture=picture_path, tolerance=tolerance)
    path = picture_path + ".json"
    with open(path, "w") as out:
        json.dump(request, out)
    answer = subprocess.run(
        [options.checker, path], capture_output=True, text=True, check=False
    )
    if answer.returncode != 0:
        raise RuntimeError(answer.stderr)
    return json.loads(answer.stdout)


def _stereo_of(view, side):
    return {
        "side": side,
        "model": view.GetProperty("StereoModel").GetData(),
        "ipd": view.InterpupillaryDistance,
        "fade": list(view.PoleFade),
        "warped": list(view.WarpedStereo),
        "separation": view.Separation,
        "convergence": view.Convergence,
    }


def describe(view, side=0):
    """What a wide view shows now, as the checker wants to know it; of its left eye (-1) or the
    right one (1)."""
    request = {
        "projection": view.GetProperty("Projection").GetData(),
        "hfov": view.HorizontalFieldOfView,
        "vfov": view.VerticalFieldOfView,
        "tilt": view.Tilt,
        "clip": list(EVERYTHING if view.AutomaticClipSpheres else view.ClipSpheres),
    }
    request.update(pose_of(view))
    if side:
        request["stereo"] = _stereo_of(view, side)
    return request


def check_cells(options, view, mesh_path, picture_path, tolerance, side=0):
    """The checker's answer about a picture of a wide view as it is now."""
    return check(options, describe(view, side), mesh_path, picture_path, tolerance)


def keeps_promise(options, view, mesh_path, picture_path, least, side=0):
    """Whether the view's picture shows the cells in more pixels than these, and as its technique
    promises. Of `exact` every pixel is explained; of `auto` those off are few, and show a face
    hidden there, beside a silhouette or where surfaces cross (Testing/Tools/Reference/HiddenFaces.h)."""
    exact = view.GetProperty("Technique").GetData() == "Exact"
    tolerance = EXACT if exact else TOLERANCE
    answer = check_cells(options, view, mesh_path, picture_path, tolerance, side)
    print(picture_path, answer, flush=True)
    return answer["hits"] > least and is_promised(answer, exact)


def is_promised(answer, exact):
    """The same of the checker's answer."""
    few = answer["broken"] == 0 and answer["off"] <= answer["allowed"]
    return answer["unexplained"] == 0 if exact else few
