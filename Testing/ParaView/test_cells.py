# SPDX-License-Identifier: BSD-3-Clause
"""Which cell each pixel of the view shows, in every projection and by both techniques, against the
ray caster."""

import os

from paraview import simple

import scene

# Pixels of a picture: the perspective is stock VTK's, whose depth buffer mistakes a few.
STOCK = 8

HITS = 3000


def check_stock(options, view, mesh):
    """The perspective, which auto leaves to stock VTK."""
    view.Projection = "perspective"
    picture = scene.save(view, os.path.join(options.output, "perspective.png"))
    answer = scene.check_cells(options, view, mesh, picture, scene.TOLERANCE)
    print("perspective", answer)
    return answer["unexplained"] <= STOCK and answer["hits"] > HITS


def check(options, view, mesh, name):
    picture = scene.save(view, os.path.join(options.output, name + ".png"))
    return scene.keeps_promise(options, view, mesh, picture, HITS)


def main(options):
    scene.load_plugin(options)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    view = scene.make_view()
    scene.show_cells(simple.XMLPolyDataReader(FileName=[mesh]), view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    wrong = [] if check_stock(options, view, mesh) else ["perspective"]
    formulas = view.GetProperty("Projection").Available
    formulas.remove("direction-map")  # a file of its own: ParaViewDirections
    formulas.remove("perspective")
    for technique in ("Automatic", "Exact"):
        view.Technique = technique
        for projection in formulas:
            view.Projection = projection
            name = "%s %s" % (projection, technique)
            if not check(options, view, mesh, name):
                wrong.append(name)
    # drawn by the techniques when exactness is asked for, where its corners are near enough
    view.Projection = "perspective"
    view.HorizontalFieldOfView, view.VerticalFieldOfView = 120, 90
    if not check(options, view, mesh, "perspective Exact"):
        wrong.append("perspective Exact")
    scene.require(not wrong, "pixels that nothing explains: " + ", ".join(wrong))


scene.run(main)
