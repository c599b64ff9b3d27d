# SPDX-License-Identifier: BSD-3-Clause
"""Which cell each pixel of the view shows, in every projection, against the ray caster."""

import os

from paraview import simple

import scene

TOLERANCE = 0.25  # pixels, the view's default

# Pixels of a picture: the perspective is stock VTK's, whose depth buffer mistakes a few.
STOCK = 8


def check(options, view, mesh, name):
    picture = scene.save(view, os.path.join(options.output, name + ".png"))
    answer = scene.check_cells(options, view, mesh, picture, TOLERANCE)
    print(name, answer)
    most = STOCK if name == "perspective" else 0
    return answer["unexplained"] <= most and answer["hits"] > 3000


def main(options):
    scene.load_plugin(options)
    mesh = os.path.join(options.output, "mesh.vtp")
    scene.write_mesh(mesh)
    view = scene.make_view()
    scene.show_cells(simple.XMLPolyDataReader(FileName=[mesh]), view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    wrong = []
    formulas = view.GetProperty("Projection").Available
    formulas.remove("direction-map")  # a file of its own: ParaViewDirections
    for projection in formulas:
        view.Projection = projection
        if not check(options, view, mesh, projection):
            wrong.append(projection)
    # drawn by the techniques when exactness is asked for, where its corners are near enough
    view.Projection, view.Technique = "perspective", "Exact"
    view.HorizontalFieldOfView, view.VerticalFieldOfView = 120, 90
    if not check(options, view, mesh, "perspective-exact"):
        wrong.append("perspective-exact")
    scene.require(not wrong, "pixels that nothing explains: " + ", ".join(wrong))


scene.run(main)
