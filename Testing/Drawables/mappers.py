# SPDX-License-Identifier: BSD-3-Clause
"""Something to see of every mapper of VTK."""

import vtk

from materials import BOUNDS, actor_of, ball, image, mapper_of, slice_of


def volume(mapper):
    """A volume of a ball's distances, half of it seen through."""
    wavelet = vtk.vtkRTAnalyticSource()
    wavelet.SetWholeExtent(-5, 5, -5, 5, -5, 5)
    change = vtk.vtkImageChangeInformation()
    change.SetInputConnection(wavelet.GetOutputPort())
    change.SetOutputSpacing([(BOUNDS[2 * i + 1] - BOUNDS[2 * i]) / 10 for i in range(3)])
    change.SetOutputExtentStart(0, 0, 0)
    change.SetOutputOrigin(BOUNDS[0], BOUNDS[2], BOUNDS[4])
    mapper.SetInputConnection(change.GetOutputPort())
    made = vtk.vtkVolume()
    made.SetMapper(mapper)
    opacity = vtk.vtkPiecewiseFunction()
    opacity.AddPoint(0, 0.3)
    opacity.AddPoint(300, 0.8)
    made.GetProperty().SetScalarOpacity(opacity)
    return made


def tetrahedra(mapper):
    made = volume(vtk.vtkFixedPointVolumeRayCastMapper())
    triangles = vtk.vtkDataSetTriangleFilter()
    triangles.SetInputConnection(made.GetMapper().GetInputConnection(0, 0))
    mapper.SetInputConnection(triangles.GetOutputPort())
    made.SetMapper(mapper)
    return made


def graph(kind):
    source = vtk.vtkRandomGraphSource()
    source.SetNumberOfVertices(12)
    source.SetNumberOfEdges(14)
    source.SetSeed(3)
    layout = vtk.vtkGraphLayout()
    layout.SetLayoutStrategy(vtk.vtkCircularLayoutStrategy())
    layout.SetInputConnection(source.GetOutputPort())
    mapper = kind()
    mapper.SetInputConnection(layout.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def glyphs(culled=False):
    points = vtk.vtkPlaneSource()
    points.SetResolution(6, 6)
    points.SetOrigin(-1, -1, 0)
    points.SetPoint1(1, -1, 0)
    points.SetPoint2(-1, 1, 0)
    mapper = mapper_of(points, vtk.vtkGlyph3DMapper)
    mapper.SetSourceConnection(ball(0.12).GetOutputPort())
    mapper.ScalingOff()
    if culled:
        mapper.SetCullingAndLOD(True)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def blocks(kind):
    group = vtk.vtkMultiBlockDataGroupFilter()
    for x in (-0.5, 0.5):
        group.AddInputConnection(ball(0.4, (x, 0, 0)).GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper_of(group, kind))
    return actor


def molecule(kind):
    made = vtk.vtkMolecule()
    one = made.AppendAtom(6, -0.4, 0, 0)
    made.AppendBond(one, made.AppendAtom(8, 0.6, 0, 0), 1)
    mapper = kind()
    mapper.SetInputData(made)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def scaled(kind, vertical=False):
    """Balls and sticks, whose sizes are in arrays."""
    points = vtk.vtkPoints()
    sizes = vtk.vtkFloatArray()
    sizes.SetName("size")
    sizes.SetNumberOfComponents(3 if vertical else 1)
    colours = vtk.vtkUnsignedCharArray()  # without any, stock VTK ends the process
    colours.SetNumberOfComponents(3)
    turns = vtk.vtkFloatArray()
    turns.SetName("turn")
    turns.SetNumberOfComponents(3)
    cells = vtk.vtkCellArray()
    for i in range(4):
        points.InsertNextPoint(0.5 * i - 0.75, 0.1 * i, 0)
        sizes.InsertNextTuple((0.4, 0.1, 0) if vertical else (0.2,))
        colours.InsertNextTuple((230, 90 + 40 * i, 60))
        turns.InsertNextTuple((0.3, 1, 0))
        cells.InsertNextCell(1)
        cells.InsertCellPoint(i)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetVerts(cells)
    data.GetPointData().AddArray(sizes)
    data.GetPointData().AddArray(turns)
    data.GetPointData().SetScalars(colours)
    mapper = kind()
    mapper.SetInputData(data)
    mapper.SetScaleArray("size")
    if vertical:
        mapper.SetOrientationArray("turn")
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def contours(kind):
    plane = vtk.vtkPlaneSource()
    plane.SetResolution(20, 20)
    height = vtk.vtkElevationFilter()
    height.SetInputConnection(plane.GetOutputPort())
    height.SetLowPoint(-0.5, -0.5, 0)
    height.SetHighPoint(0.5, 0.5, 0)
    lines = vtk.vtkContourFilter()
    lines.SetInputConnection(height.GetOutputPort())
    lines.GenerateValues(4, 0.2, 0.8)
    strips = vtk.vtkStripper()
    strips.SetInputConnection(lines.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper_of(strips, kind))
    return actor


def labels():
    """Over the eight corners of a box, laid out by the picture."""
    points = vtk.vtkCubeSource()
    points.SetBounds(BOUNDS)
    names = vtk.vtkStringArray()
    names.SetName("names")
    clean = vtk.vtkCleanPolyData()
    clean.SetInputConnection(points.GetOutputPort())
    clean.Update()
    data = vtk.vtkPolyData()
    data.ShallowCopy(clean.GetOutput())
    for i in range(data.GetNumberOfPoints()):
        names.InsertNextValue("L%d" % i)
    data.GetPointData().AddArray(names)
    hierarchy = vtk.vtkPointSetToLabelHierarchy()
    hierarchy.SetInputData(data)
    hierarchy.SetLabelArrayName("names")
    mapper = vtk.vtkLabelPlacementMapper()
    mapper.SetInputConnection(hierarchy.GetOutputPort())
    actor = vtk.vtkActor2D()
    actor.SetMapper(mapper)
    return actor


def made_by(kind):
    actor = vtk.vtkActor()
    actor.SetMapper(mapper_of(ball(), kind))
    return actor


def fluid():
    points = vtk.vtkPointSource()
    points.SetNumberOfPoints(200)
    points.SetRadius(0.5)
    mapper = vtk.vtkOpenGLFluidMapper()
    mapper.SetInputConnection(points.GetOutputPort())
    mapper.SetParticleRadius(0.1)
    made = vtk.vtkVolume()
    made.SetMapper(mapper)
    return made


def reslice():
    mapper = vtk.vtkImageResliceMapper()
    mapper.SetInputData(image())
    made = vtk.vtkImageSlice()
    made.SetMapper(mapper)
    made.GetProperty().SetInterpolationTypeToNearest()
    return made


def overlay(mapper):
    """In the picture's plane."""
    made = vtk.vtkActor2D()
    made.SetMapper(mapper)
    return made


def flat_image():
    mapper = vtk.vtkImageMapper()
    mapper.SetInputData(image())
    mapper.SetColorWindow(255)
    mapper.SetColorLevel(128)
    return overlay(mapper)


def flat_text():
    mapper = vtk.vtkTextMapper()
    mapper.SetInput("Ahoy")
    return overlay(mapper)


def labels_of_points(kind):
    """Over four points."""
    plane = vtk.vtkPlaneSource()
    numbers = vtk.vtkIdFilter() if not hasattr(vtk, "vtkGenerateIds") else vtk.vtkGenerateIds()
    numbers.SetInputConnection(plane.GetOutputPort())
    mapper = mapper_of(numbers, kind)
    mapper.SetLabelModeToLabelIds()
    return overlay(mapper)


def grids():
    """A volume of tetrahedra in a block."""
    single = tetrahedra(vtk.vtkProjectedTetrahedraMapper())
    group = vtk.vtkMultiBlockDataGroupFilter()
    group.AddInputConnection(single.GetMapper().GetInputConnection(0, 0))
    mapper = vtk.vtkMultiBlockUnstructuredGridVolumeMapper()
    mapper.SetInputConnection(group.GetOutputPort())
    single.SetMapper(mapper)
    return single


# What is drawn by a mapper of its own, by the mapper's name.
MAPPERS = {
    "vtkPolyDataMapper": lambda: actor_of(ball()),
    "vtkDataSetMapper": lambda: made_by(vtk.vtkDataSetMapper),
    "vtkGlyph3DMapper": glyphs,
    "vtkGlyph3DMapper CullingAndLOD": lambda: glyphs(True),
    "vtkGraphMapper": lambda: graph(vtk.vtkGraphMapper),
    "vtkCompositePolyDataMapper": lambda: blocks(vtk.vtkCompositePolyDataMapper),
    "vtkCompositePolyDataMapper2": lambda: blocks(vtk.vtkCompositePolyDataMapper2),
    "vtkHierarchicalPolyDataMapper": lambda: blocks(vtk.vtkHierarchicalPolyDataMapper),
    "vtkMoleculeMapper": lambda: molecule(vtk.vtkMoleculeMapper),
    "vtkOpenGLSphereMapper": lambda: scaled(vtk.vtkOpenGLSphereMapper),
    "vtkOpenGLStickMapper": lambda: scaled(vtk.vtkOpenGLStickMapper, True),
    "vtkPointGaussianMapper": lambda: scaled(vtk.vtkPointGaussianMapper),
    "vtkLabeledContourMapper": lambda: contours(vtk.vtkLabeledContourMapper),
    "vtkLabelPlacementMapper": labels,
    "vtkLabeledDataMapper": lambda: labels_of_points(vtk.vtkLabeledDataMapper),
    "vtkDynamic2DLabelMapper": lambda: labels_of_points(vtk.vtkDynamic2DLabelMapper),
    "vtkPolyDataMapper2D": lambda: overlay(mapper_of(ball(40, (60, 60, 0)), vtk.vtkPolyDataMapper2D)),
    "vtkImageMapper": flat_image,
    "vtkTextMapper": flat_text,
    "vtkImageSliceMapper": lambda: slice_of(image()),
    "vtkImageResliceMapper": reslice,
    "vtkGPUVolumeRayCastMapper": lambda: volume(vtk.vtkGPUVolumeRayCastMapper()),
    "vtkSmartVolumeMapper": lambda: volume(vtk.vtkSmartVolumeMapper()),
    "vtkMultiBlockVolumeMapper": lambda: volume(vtk.vtkMultiBlockVolumeMapper()),
    "vtkFixedPointVolumeRayCastMapper": lambda: volume(vtk.vtkFixedPointVolumeRayCastMapper()),
    "vtkUnstructuredGridVolumeRayCastMapper": lambda: tetrahedra(
        vtk.vtkUnstructuredGridVolumeRayCastMapper()
    ),
    "vtkUnstructuredGridVolumeZSweepMapper": lambda: tetrahedra(
        vtk.vtkUnstructuredGridVolumeZSweepMapper()
    ),
    "vtkMultiBlockUnstructuredGridVolumeMapper": grids,
    "vtkOSPRayVolumeInterface": lambda: volume(vtk.vtkOSPRayVolumeInterface()),
    "vtkProjectedTetrahedraMapper": lambda: tetrahedra(vtk.vtkProjectedTetrahedraMapper()),
    "vtkOpenGLFluidMapper": lambda: fluid(),
}
