# SPDX-License-Identifier: BSD-3-Clause
"""What else ParaView draws: blocks, glyphs, pictures larger than the window, against the
ray caster; and what the view cannot draw."""

import os

from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkCubeSource

import scene

def check(options, view, mesh, name, size=None):
    path = os.path.join(options.output, name + ".vtp")
    scene.write_polydata(mesh, path)
    for technique in ("Exact", "Automatic"):
        view.Technique = technique
        file = os.path.join(options.output, "%s %s.png" % (name, technique))
        picture = scene.save(view, file, size)
        scene.require(scene.keeps_promise(options, view, path, picture, 1000), name)


def show_blocks(options, view):
    """Two blocks, each a mesh of its own; returns both as one."""
    meshes = [scene.triangles_of(a) for a in (scene.make_sphere(), scene.make_contours())]
    readers = []
    first = 0
    for i, mesh in enumerate(meshes):
        scene.number_cells(mesh, first)
        first += mesh.GetNumberOfCells()
        path = os.path.join(options.output, "block%d.vtp" % i)
        scene.write_polydata(mesh, path)
        readers.append(simple.XMLPolyDataReader(FileName=[path]))
    group = simple.GroupDatasets(Input=readers)
    scene.show_cells(group, view)
    whole = scene.triangles_of(scene.make_sphere(), scene.make_contours())
    scene.number_cells(whole)
    return whole, group


def make_places():
    """Points all round the eye, some of them near the seam and the poles."""
    points = vtkPoints()
    for i in range(-3, 4):
        for j in range(-3, 4):
            for k in (-3, -1, 2, 4):
                points.InsertNextPoint(2.1 * i, 1.9 * j, 2.3 * k)
    places = vtkPolyData()
    places.SetPoints(points)
    return places


def show_glyphs(options, view):
    """Cubes by the glyph mapper, a number each; returns them as one mesh."""
    places = make_places()
    cube = vtkCubeSource()
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(places)
    glyphs.SetSourceConnection(cube.GetOutputPort())
    mesh = scene.triangles_of(glyphs)
    scene.number_cells(mesh, 0, mesh.GetNumberOfCells() // places.GetNumberOfPoints())

    scene.number_points(places)
    path = os.path.join(options.output, "places.vtp")
    scene.write_polydata(places, path)
    display = simple.Show(simple.XMLPolyDataReader(FileName=[path]), view)
    display.SetRepresentationType("3D Glyphs")
    display.GlyphType = "Box"
    simple.ColorBy(display, ("POINTS", "number"))
    scene.show_as_numbers(display)
    return mesh


def main(options):
    scene.load_plugin(options)
    view = scene.make_view()
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    mesh, group = show_blocks(options, view)
    check(options, view, mesh, "blocks")
    # beyond the window: tiles, of a panorama and of a round map
    check(options, view, mesh, "tiles", [700, 350])
    view.Projection = "stereographic"
    check(options, view, mesh, "round-tiles", [700, 350])
    simple.Hide(group, view)
    view.Projection = "hammer"
    check(options, view, show_glyphs(options, view), "glyphs")


scene.run(main)
