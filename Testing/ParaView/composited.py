# SPDX-License-Identifier: BSD-3-Clause
"""What is asked of a picture that ranks draw together, with a client of their own and without:
that of the ray caster, and that of one rank without a client."""

import os

from paraview import simple
from vtkmodules.vtkCommonCore import vtkIntArray
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

import pixels
import scene

PROJECTIONS = ["equirectangular", "azimuthal-equidistant"]

# Fraction of the pixels of a picture that other ranks may draw otherwise.
OTHERWISE = 1e-4

# Levels of 255: blending in another order rounds otherwise.
ROUNDING = 3

# Triangles that are large beside a pixel fill more of a picture than this many pixels.
HITS = 3000


def _write_counted_mesh(path):
    """The cells with their number as a scalar beside the one that is a colour."""
    mesh = scene.write_mesh(path)
    counts = vtkIntArray()
    counts.SetName("count")
    for cell in range(mesh.GetNumberOfCells()):
        counts.InsertNextValue(cell + 1)
    mesh.GetCellData().AddArray(counts)
    scene.write_polydata(mesh, path)
    return mesh.GetNumberOfCells()


def _map_counts(display, count):
    """A colour map whose colours are the numbers."""
    simple.ColorBy(display, ("CELLS", "count"))
    table = simple.GetColorTransferFunction("count")
    table.AutomaticRescaleRangeMode = "Never"
    table.Discretize = 0
    table.ColorSpace = "RGB"
    points = []
    for green in range(count // 256 + 1):
        points += [256 * green, 0, green / 255, 0, 256 * green + 255, 0, green / 255, 1]
    table.RGBPoints = points


def show_parts(options, share=scene.spread, **properties):
    """A view of numbered cells, of which each rank has a part: the view, the file of the cells,
    what is shown and how. By the technique `exact`, which draws the same whoever has a
    triangle. The colours are those of a map: where they are data, ParaView puts the
    ranks' pictures over each other in order, as if they could be seen through, and not by depth."""
    mesh = os.path.join(options.output, "mesh.vtp")
    count = _write_counted_mesh(mesh)
    view = scene.make_view(**{"Technique": "Exact", **properties})
    source = share(simple.XMLPolyDataReader(FileName=[mesh]))
    display = scene.show_cells(source, view)
    scene.place_eye(view, [0.5, 0.3, 1], [0.6, 0.2, 0])
    display.MapScalars = 1
    _map_counts(display, count)
    return view, mesh, source, display


def show_in_order(display):
    """The same colours, put over each other in order."""
    simple.ColorBy(display, ("CELLS", "number"))
    display.MapScalars = 0


def check_file(options, view, mesh, picture, side=0):
    """The picture is the ray caster's, as the view's technique promises."""
    width, height = view.ViewSize
    rows = pixels.read_rows(picture)
    share = len(rows) * len(rows[0]) / (width * height)  # of a reduced one
    scene.require(scene.keeps_promise(options, view, mesh, picture, HITS * share, side), picture)


def _of_one_rank(options, name):
    """The picture of pvbatch on one rank, a test of its own."""
    return os.path.join(os.path.dirname(options.output), "Ranks1", name)


def _most():
    return OTHERWISE * scene.SIZE[0] * scene.SIZE[1]


def _check_numbers(options, view, mesh, name, one):
    """Beside the ray caster's picture and that of one rank, which has a name of its own."""
    picture = scene.save(view, os.path.join(options.output, name))
    check_file(options, view, mesh, picture)
    alone = pixels.read_rows(_of_one_rank(options, one))
    other = pixels.count_different(pixels.read_rows(picture), alone)
    print(other, "opaque pixels differ from one rank's", flush=True)
    scene.require(other <= _most(), name)


def check_opaque(options, view, mesh):
    for projection in PROJECTIONS:
        view.Projection = projection
        _check_numbers(options, view, mesh, projection + ".png", projection + ".png")


def check_in_order(options, view, mesh, display):
    view.Projection = "equirectangular"
    show_in_order(display)
    _check_numbers(options, view, mesh, "in-order.png", "equirectangular.png")


def check_translucent(options, view, display):
    """Several layers of one surface."""
    view.Projection = "equirectangular"
    view.MaximumNumberOfPeels = 30
    display.Opacity = 0.5
    simple.ColorBy(display, None)
    picture = scene.save(view, os.path.join(options.output, "translucent.png"))
    alone = _of_one_rank(options, "translucent.png")
    levels = {level for row in pixels.read_levels(alone) for level in row}
    scene.require({128, 192} <= levels, "one layer alone is drawn: %s" % sorted(levels))
    other = pixels.count_other(picture, alone, ROUNDING)
    print(other, "translucent pixels differ from one rank's", flush=True)
    scene.require(other <= _most(), "translucency")


def check_volume(options, view):
    """Parts of a volume put over each other in order."""
    for projection in PROJECTIONS:
        view.Projection = projection
        name = "volume-%s.png" % projection
        picture = scene.save(view, os.path.join(options.output, name))
        scene.require(pixels.count_lit(picture) > HITS, "no volume")
        other = pixels.count_other(picture, _of_one_rank(options, name), ROUNDING)
        print(other, "pixels of a volume differ from one rank's", flush=True)
        scene.require(other <= _most(), name)


def grab(view, path):
    """The window as it is, which a screenshot would draw anew."""
    window = vtkWindowToImageFilter()
    window.SetInput(view.GetRenderWindow())
    window.ShouldRerenderOff()
    window.ReadFrontBufferOff()
    window.Update()
    pixels.write(window.GetOutput(), path)
    return path


def check_reduced(options, view, mesh, picture, factor):
    """So many times fewer pixels on each side, each the ray caster's, and magnified."""
    rows = pixels.read_rows(picture)
    width, height = len(rows[0]), len(rows)
    few = pixels.reduce(rows, width // factor, height // factor)
    other = pixels.count_different(rows, pixels.magnify(few, width, height))
    scene.require(other == 0, "%d pixels of %s are not reduced" % (other, picture))
    reduced = picture[:-len(".png")] + "-reduced.png"
    pixels.write_rows(few, reduced)
    check_file(options, view, mesh, reduced)
