# SPDX-License-Identifier: BSD-3-Clause
"""Data of several blocks, whose triangles are refined block by block: visibility, colours, opacity,
colour maps, edges and selection of each are those of the same data shown as sources of their own, by
both techniques."""

import os
import random

from paraview import simple
from vtkmodules.vtkCommonCore import vtkCollection
from vtkmodules.vtkFiltersSources import vtkSphereSource

import pixels
import scene

EYE, FOCAL = [0.5, 0.3, 1], [0.6, 0.2, 0]

# Fraction of the pixels that two ways to the same picture may draw otherwise.
OTHERWISE = 1e-4

# Levels of 255 that shading may differ by.
ROUNDING = 2

SELECTIONS = 200


def make_ball():
    ball = vtkSphereSource()
    ball.SetThetaResolution(64)
    ball.SetPhiResolution(64)
    ball.SetRadius(1.5)
    ball.SetCenter(-3, 0, -2)
    return ball


def write_sources(options):
    """Three files of triangles, numbered one after the other, with a value at each point."""
    sources = []
    first = 0
    for i, algorithm in enumerate((scene.make_sphere(), make_ball(), scene.make_contours())):
        mesh = scene.triangles_of(algorithm)
        scene.number_cells(mesh, first)
        first += mesh.GetNumberOfCells()
        path = os.path.join(options.output, "part%d.vtp" % i)
        scene.write_polydata(mesh, path)
        sources.append(simple.Elevation(
            Input=simple.XMLPolyDataReader(FileName=[path]),
            LowPoint=[-5, -5, -5], HighPoint=[5, 5, 5]))
    return sources


def compare(options, name, one, other):
    """Both pictures are lit, and the same."""
    paths = []
    name = "%s-%s" % (one.GetProperty("Technique").GetData(), name)
    for kind, view in (("blocks", one), ("sources", other)):
        paths.append(scene.save(view, os.path.join(options.output, "%s-%s.png" % (name, kind))))
    different = pixels.count_other(*paths, ROUNDING)
    lit = pixels.count_lit(paths[0])
    print(name, lit, "lit,", different, "differ", flush=True)
    scene.require(lit > 1000, name + ": hardly anything is drawn")
    scene.require(different <= OTHERWISE * scene.SIZE[0] * scene.SIZE[1], name)


def show(view, source, solid=True):
    display = simple.Show(source, view)
    display.Representation = "Surface"
    if solid:
        simple.ColorBy(display, None)
    return display


def check_colours(options, blocks, parts, group, sources):
    """A colour and an opacity for the second block; the first one hidden."""
    display = show(blocks, group)
    displays = [show(parts, source) for source in sources]
    compare(options, "plain", blocks, parts)
    display.BlockSelectors = ["/Root/Block1", "/Root/Block2"]
    simple.Hide(sources[0], parts)
    compare(options, "hidden", blocks, parts)
    display.BlockColors = ["/Root/Block1", "0.9", "0.2", "0.1"]
    displays[1].AmbientColor = displays[1].DiffuseColor = [0.9, 0.2, 0.1]
    compare(options, "coloured", blocks, parts)
    for view in (blocks, parts):
        view.MaximumNumberOfPeels = 20
    display.BlockOpacities = ["/Root/Block1", "0.4"]
    displays[1].Opacity = 0.4
    compare(options, "translucent", blocks, parts)
    display.BlockOpacities, displays[1].Opacity = [], 1
    display.BlockColors = []
    display.BlockSelectors = ["/"]
    simple.Show(sources[0], parts)
    for each in [display] + displays:
        each.Representation = "Surface With Edges"
        each.DiffuseColor = [1, 1, 1]
    compare(options, "edges", blocks, parts)


def check_maps(options, blocks, parts, group, sources):
    """A colour map of the points, by texture and by vertices."""
    for interpolate in (1, 0):
        for view, shown in ((blocks, [group]), (parts, sources)):
            for source in shown:
                display = show(view, source, False)
                simple.ColorBy(display, ("POINTS", "Elevation"))
                display.InterpolateScalarsBeforeMapping = interpolate
                display.DiffuseColor = [1, 1, 1]
        compare(options, "map%d" % interpolate, blocks, parts)


def find_cells(group):
    """Block and id of each numbered cell."""
    places = {}
    data = simple.servermanager.Fetch(group)
    parts = data.NewIterator()
    parts.InitTraversal()
    while not parts.IsDoneWithTraversal():
        part = parts.GetCurrentDataObject()
        colours = part.GetCellData().GetArray("number")
        for cell in range(part.GetNumberOfCells()):
            red, green, blue = (int(c) for c in colours.GetTuple3(cell))
            places[65536 * red + 256 * green + blue] = (parts.GetCurrentFlatIndex(), cell)
        parts.GoToNextItem()
    return places


def select(view, x, y):
    """The block and the id of the cell that a selection of one pixel holds, or None."""
    representations, sources = vtkCollection(), vtkCollection()
    view.SelectSurfaceCells([x, y, x, y], representations, sources, 0)
    if sources.GetNumberOfItems() == 0:
        return None
    ids = sources.GetItemAsObject(0).GetProperty("IDs")
    scene.require(ids.GetNumberOfElements() == 3, "more than one cell in a pixel")
    return ids.GetElement(0), ids.GetElement(2)


def check_selection(options, blocks, group):
    """The picture of the numbers, and what a selection of a pixel holds."""
    scene.show_cells(group, blocks)
    drawn = pixels.read_numbers(scene.save(blocks, os.path.join(options.output, "cells.png")))
    places = find_cells(group)
    dice = random.Random(5)
    hits, wrong = 0, []
    for _ in range(SELECTIONS):
        x, y = dice.randrange(scene.SIZE[0]), dice.randrange(scene.SIZE[1])
        expected, found = places.get(drawn(x, y)), select(blocks, x, y)
        hits += found is not None
        if expected != found:
            wrong.append((x, y, expected, found))
    print("selected", hits, "cells of", len({p[0] for p in places.values()}), "blocks, wrong:", wrong)
    scene.require(not wrong and hits > SELECTIONS // 4, "selection")


def check(options, technique):
    blocks, parts = (scene.make_view(Technique=technique) for _ in range(2))
    for view in (blocks, parts):
        view.UseFXAA = 0  # a setting of the application, which each new view brings back
        scene.place_eye(view, EYE, FOCAL)
    sources = write_sources(options)
    group = simple.GroupDatasets(Input=sources, BlockNames=["Block0", "Block1", "Block2"])
    check_colours(options, blocks, parts, group, sources)
    check_maps(options, blocks, parts, group, sources)
    check_selection(options, blocks, group)


def main(options):
    scene.load_plugin(options)
    for technique in ("Exact", "Automatic"):
        check(options, technique)


scene.run(main)
