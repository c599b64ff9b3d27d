# SPDX-License-Identifier: BSD-3-Clause
"""What is no surface: streamlines as lines and as tubes, outlines, wireframes, points, edges of a
surface, gaussian splats, each where an independent formula of the map says; slices and tubes
against the ray caster; and every other representation that this ParaView offers is drawn."""

import math
import os

from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

import pixels
import places
import scene
from messages import Log

SIZE = [360, 180]
EYE = [0.53, 0.31, 1.07]  # below no line of the box

# Pixels: the rim of a splat is where its shader says, in float32.
RIM = 1.5


def output_of(source):
    source.UpdatePipeline()
    return simple.FetchData(source)[0]


def places_of_edges(data):
    """Places along all lines of the data's cells, the borders of its polygons among them."""
    edges = set()
    for c in range(data.GetNumberOfCells()):
        ids = data.GetCell(c).GetPointIds()
        row = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
        around = row + row[:1] if data.GetCell(c).GetCellDimension() == 2 else row
        edges.update(tuple(sorted(pair)) for pair in zip(around, around[1:]))
    return [p for a, b in edges
            for p in places.places_of_line(data.GetPoint(a), data.GetPoint(b), EYE, SIZE)]


def show_white(source, view, kind):
    display = simple.Show(source, view)
    display.SetRepresentationType(kind)
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = [1, 1, 1]
    display.Ambient, display.Diffuse, display.Specular = 1, 0, 0
    return display


def picture(options, view, name):
    return scene.save(view, os.path.join(options.output, name + ".png"))


def trace_lines(wavelet):
    gradient = simple.Gradient(Input=wavelet, ScalarArray=["POINTS", "RTData"])
    gradient.UpdatePipeline()
    lines = simple.StreamTracer(Input=gradient, SeedType="Line", Vectors=["POINTS", "Gradient"])
    lines.SeedType.Point1 = [-8, -6, -7]
    lines.SeedType.Point2 = [7, 5, 8]
    lines.SeedType.Resolution = 5
    # not to where the gradient vanishes: OpenGL leaves out what is smaller than a pixel there
    lines.TerminalSpeed = 2
    return lines


def check_streamlines(options, view, lines):
    """Arcs as wide as they are said to be."""
    expected = places_of_edges(output_of(lines))
    display = show_white(lines, view, "Surface")
    wide = {}
    for width in (1, 4):
        display.LineWidth = width
        found = pixels.lit_pixels(picture(options, view, "streamlines%d" % width))
        places.check_places("streamlines of width %d" % width, found, expected, width, SIZE)
        wide[width] = len(found)
    scene.require(2.5 < wide[4] / wide[1] < 4.5, "their width: %s" % wide)
    simple.Hide(lines, view)


def check_mesh(options, view, name, source):
    """Its triangles against the ray caster."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(output_of(source))
    triangles.PassLinesOff()
    mesh = scene.triangles_of(triangles)
    scene.number_cells(mesh)
    path = os.path.join(options.output, name + ".vtp")
    scene.write_polydata(mesh, path)
    reader = simple.XMLPolyDataReader(FileName=[path])
    scene.show_cells(reader, view)
    for technique in ("Exact", "Automatic"):
        view.Technique = technique
        drawn = picture(options, view, name + technique)
        scene.require(scene.keeps_promise(options, view, path, drawn, 1000), name)
    simple.Delete(reader)


def check_lines(options, view):
    """The lines of a box of few cells, of which an eye inside it sees all."""
    box = simple.Wavelet(WholeExtent=[-3, 3, -2, 2, -3, 3])
    surface = output_of(simple.ExtractSurface(Input=box))
    hull = output_of(simple.Outline(Input=box))
    for kind, data, width in (("Outline", hull, 1), ("Feature Edges", hull, 1),
                              ("Wireframe", surface, 1), ("Wireframe", surface, 3)):
        show_white(box, view, kind).LineWidth = width
        name = "%s%d" % (kind.replace(" ", ""), width)
        found = pixels.lit_pixels(picture(options, view, name))
        places.check_places(name, found, places_of_edges(data), width, SIZE)
    display = show_white(box, view, "Surface With Edges")
    display.EdgeColor = [1, 0, 0]
    display.LineWidth = 1
    found = pixels.lit_pixels(picture(options, view, "SurfaceWithEdges"), red_only=True)
    places.check_places("surface with edges", found, places_of_edges(surface), 1, SIZE)
    display = show_white(box, view, "Points")
    display.PointSize = 3
    found = pixels.lit_pixels(picture(options, view, "Points"))
    dots = [places.place_of(surface.GetPoint(i), EYE, SIZE) for i in range(surface.GetNumberOfPoints())]
    places.check_places("points", found, dots, 3 * math.sqrt(2), SIZE)
    simple.Hide(box, view)


def excess(ray, point, radius):
    """Radians by which the ray passes a disc of this radius that faces the eye."""
    way = [a - b for a, b in zip(point, EYE)]
    far = math.hypot(*way)
    cosine = sum(a * b for a, b in zip(ray, way)) / far
    return math.acos(max(-1, min(1, cosine))) - math.atan(radius / far)


def show_splats(options, view, points, radius):
    cloud = vtkPolyData()
    cloud.SetPoints(vtkPoints())
    cloud.SetVerts(vtkCellArray())
    for point in points:
        cloud.GetVerts().InsertNextCell(1, [cloud.GetPoints().InsertNextPoint(point)])
    path = os.path.join(options.output, "cloud.vtp")
    scene.write_polydata(cloud, path)
    reader = simple.XMLPolyDataReader(FileName=[path])
    display = show_white(reader, view, "Point Gaussian")
    display.ShaderPreset = "Plain circle"
    display.GaussianRadius = radius
    return reader


def check_gaussian(options, view):
    """Splats are discs round their points, as large as their radius is there, also where the map
    stretches them and across its border."""
    radius = 0.4
    points = [(4, 1, -3), (-3, 3, 2), (0.5, 4, 1.5), (0.6, -1, 5), (-2, -0.5, -3), (3, -3, 2)]
    reader = show_splats(options, view, points, radius)
    found = pixels.lit_pixels(picture(options, view, "PointGaussian"))
    margin = RIM * math.pi / SIZE[1]
    wrong, inside = [], 0
    for i, j in ((i, j) for i in range(SIZE[0]) for j in range(SIZE[1])):
        ray = places.direction_of(i + 0.5, j + 0.5, SIZE)
        over = min(excess(ray, point, radius) for point in points)
        inside += over < -margin
        if abs(over) > margin and ((i, j) in found) != (over < 0):
            wrong.append((i, j))
    print("splats:", len(found), "pixels, surely", inside, "wrong", len(wrong), wrong[:3], flush=True)
    scene.require(inside > 500 and not wrong, "splats")
    simple.Delete(reader)


def errors_in_render_view(options, source, kind):
    """Of ParaView itself: 6.1 says of Surface LIC that there are no vectors."""
    view = simple.CreateView("RenderView")
    display = simple.Show(source, view)
    display.SetRepresentationType(kind)
    with Log(options, kind + " stock") as log:
        simple.Render(view)
        errors = log.count("ERR")
    simple.Delete(view)
    return errors


def check_others(options, view, wavelet):
    """Whatever else this ParaView offers, with no warning and no error but those of its Render
    View."""
    display = show_white(wavelet, view, "Surface")
    for kind in display.GetProperty("Representation").GetAvailable():
        display.SetRepresentationType(kind)
        with Log(options, kind) as log:
            lit = pixels.count_lit(picture(options, view, "any-" + kind.replace(" ", "")))
            warnings = log.count("WARN") + log.count("Warning"), log.count("ERR")
        print(kind, "lit", lit, "warnings and errors", warnings)
        expected = errors_in_render_view(options, wavelet, kind) if warnings[1] else 0
        scene.require(warnings == (0, expected) and lit > 0, kind)
    simple.Hide(wavelet, view)


def main(options):
    scene.load_plugin(options)
    view = scene.make_view(SIZE)
    scene.place_eye(view, EYE, [EYE[0], EYE[1], EYE[2] - 1])
    wavelet = simple.Wavelet()
    lines = trace_lines(wavelet)
    check_streamlines(options, view, lines)
    check_mesh(options, view, "tubes", simple.Tube(Input=lines, Radius=0.3))
    cut = simple.Slice(Input=wavelet)
    cut.SliceType.Origin = [0, -1, 0]
    cut.SliceType.Normal = [0.2, 1, 0.3]
    check_mesh(options, view, "slice", cut)
    check_lines(options, view)
    check_gaussian(options, view)
    check_others(options, view, wavelet)


scene.run(main)
