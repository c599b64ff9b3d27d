# SPDX-License-Identifier: BSD-3-Clause
"""How to show what widgets of VTK draw: by their representations, and by themselves."""

import vtk

import materials
import recipes


def checkerboard(representation):
    picture = vtk.vtkImageActor()
    board = vtk.vtkImageCheckerboard()
    board.SetInputData(0, materials.image())
    board.SetInputData(1, materials.image())
    board.SetNumberOfDivisions(4, 4, 1)  # of more than there are pixels VTK divides by 0
    picture.GetMapper().SetInputConnection(board.GetOutputPort())
    representation.SetCheckerboard(board)
    representation.SetImageActor(picture)
    for side in ("Top", "Right", "Bottom", "Left"):  # thinner than a pixel they are seen by chance
        slider = getattr(representation, "Get%sRepresentation" % side)()
        slider.SetTubeWidth(0.1)


def wipe(representation):
    both = vtk.vtkImageRectilinearWipe()
    both.SetInputData(0, materials.image())
    both.SetInputData(1, materials.image())
    picture = vtk.vtkImageActor()
    picture.GetMapper().SetInputConnection(both.GetOutputPort())
    representation.SetRectilinearWipe(both)
    representation.SetImageActor(picture)


def cursor(representation):
    made = vtk.vtkResliceCursor()
    made.SetImage(materials.image(16, 8))
    made.SetCenter(0, 0, 0)
    algorithm = representation.GetResliceCursorActor().GetCursorAlgorithm()
    algorithm.SetResliceCursor(made)
    algorithm.SetReslicePlaneNormal(2)


def cloud(representation):
    vtk.vtkMath.RandomSeed(1)
    points = vtk.vtkPointSource()
    points.Update()
    actor = materials.actor_of(points)
    representation.PlacePointCloud(actor)


# What a representation needs before it can be placed.
NEEDS = {
    "vtkCheckerboardRepresentation": checkerboard,
    "vtkRectilinearWipeRepresentation": wipe,
    "vtkResliceCursorLineRepresentation": cursor,
    "vtkResliceCursorThickLineRepresentation": cursor,
    "vtkPointCloudRepresentation": cloud,
    "vtkSeedRepresentation": lambda r: r.SetHandleRepresentation(
        vtk.vtkPointHandleRepresentation3D()
    ),
    "vtkScalarBarRepresentation": lambda r: r.SetScalarBarActor(recipes.vtkScalarBarActor()),
    "vtkTexturedButtonRepresentation2D": lambda r: textured_button(r),
    "vtkTexturedButtonRepresentation": lambda r: textured_button(r, True),
    "vtkProp3DButtonRepresentation": lambda r: prop_button(r),
    "vtkCaptionRepresentation": lambda r: r.SetCaptionActor2D(recipes.vtkCaptionActor2D()),
    "vtkTextRepresentation": lambda r: r.SetText("Ahoy"),
    "vtkLogoRepresentation": lambda r: r.SetImage(materials.image()),
    "vtkCameraRepresentation": lambda r: r.SetCamera(vtk.vtkCamera()),
    "vtkBalloonRepresentation": lambda r: r.SetBalloonText("Ahoy"),
    "vtkAngleRepresentation2D": lambda r: r.SetHandleRepresentation(
        vtk.vtkPointHandleRepresentation2D()
    ),
    "vtkDistanceRepresentation2D": lambda r: ends(r, vtk.vtkPointHandleRepresentation2D),
    "vtkDistanceRepresentation3D": lambda r: ends(r, vtk.vtkPointHandleRepresentation3D),
    "vtkAngleRepresentation3D": lambda r: ends(r, vtk.vtkPointHandleRepresentation3D, True),
    "vtkBiDimensionalRepresentation2D": lambda r: r.SetHandleRepresentation(
        vtk.vtkPointHandleRepresentation2D()
    ),
    "vtkEllipsoidTensorProbeRepresentation": lambda r: r.SetTrajectory(way()),
    "vtkPolygonalHandleRepresentation3D": lambda r: r.SetHandle(materials.ball(0.3).GetOutput()),
    "vtkOrientedPolygonalHandleRepresentation3D": lambda r: r.SetHandle(
        materials.ball(0.3).GetOutput()
    ),
    "vtkOrientedGlyphContourRepresentation": lambda r: contour(r),
    "vtkOrientedGlyphFocalPlaneContourRepresentation": lambda r: contour(r),
}


def ends(representation, handle, angle=False):
    """Of what measures: between two places, or three."""
    representation.SetHandleRepresentation(handle())
    representation.InstantiateHandleRepresentation()
    representation.SetPoint1WorldPosition((-0.8, -0.3, 0))
    representation.SetPoint2WorldPosition((0.8, 0.3, 0))
    for scale in ("SetLabelScale", "SetTextActorScale"):
        if hasattr(representation, scale):
            getattr(representation, scale)((0.2, 0.2, 0.2))
    if angle:
        representation.SetCenterWorldPosition((0, -0.3, 0))


def way():
    """A line with tensors."""
    line = vtk.vtkLineSource()
    line.SetResolution(4)
    line.Update()
    data = line.GetOutput()
    tensors = vtk.vtkDoubleArray()
    tensors.SetNumberOfComponents(9)
    for _ in range(data.GetNumberOfPoints()):
        tensors.InsertNextTuple((0.3, 0, 0, 0, 0.2, 0, 0, 0, 0.1))
    data.GetPointData().SetTensors(tensors)
    return data


def contour(representation):
    for place in ((-0.7, -0.4, 0), (0.7, -0.3, 0), (0.1, 0.6, 0)):
        representation.AddNodeAtWorldPosition(place)


def textured_button(representation, placed=False):
    representation.SetNumberOfStates(1)
    representation.SetButtonTexture(0, materials.image())
    if placed:
        representation.SetButtonGeometry(materials.ball(0.5).GetOutput())


def prop_button(representation):
    representation.SetNumberOfStates(1)
    representation.SetButtonProp(0, recipes.vtkActor())


def representation(name, renderer):
    """One of this class, placed in the renderer."""
    made = getattr(vtk, name)()
    made.SetRenderer(renderer)
    NEEDS.get(name, lambda r: None)(made)
    made.PlaceWidget(materials.BOUNDS)
    made.SetVisibility(True)
    made.BuildRepresentation()
    renderer.AddViewProp(made)
    return made


# What a widget needs before it is switched on.
SUBJECTS = {
    "vtkCheckerboardWidget": ("vtkCheckerboardRepresentation",),
    "vtkRectilinearWipeWidget": ("vtkRectilinearWipeRepresentation",),
    "vtkResliceCursorWidget": ("vtkResliceCursorLineRepresentation",),
    "vtkPointCloudWidget": ("vtkPointCloudRepresentation",),
    "vtkSliderWidget": ("vtkSliderRepresentation3D",),
    "vtkSeedWidget": ("vtkSeedRepresentation",),
    "vtkScalarBarWidget": ("vtkScalarBarRepresentation",),
    "vtkButtonWidget": ("vtkProp3DButtonRepresentation",),
    "vtkHandleWidget": ("vtkPointHandleRepresentation3D",),
    # without an image its corners are where the memory happens to say
    "vtkLogoWidget": ("vtkLogoRepresentation",),
    "vtkDistanceWidget": ("vtkDistanceRepresentation3D",),
    "vtkAngleWidget": ("vtkAngleRepresentation3D",),
}


def widget(name, stage):
    """One of this class, switched on in the stage's window."""
    made = getattr(vtk, name)()
    made.SetInteractor(stage.interactor)
    if isinstance(made, vtk.vtk3DWidget):
        made.SetProp3D(recipes.vtkActor())
        image = vtk.vtkImagePlaneWidget, vtk.vtkImageTracerWidget
        if isinstance(made, image):
            made.SetInputData(materials.image(16, 8))
        made.PlaceWidget(materials.BOUNDS)
        if hasattr(made, "TubingOff"):
            made.TubingOff()  # thinner than a pixel they are seen by chance
    elif name in SUBJECTS:
        kind = SUBJECTS[name][0]
        shown = getattr(vtk, kind)()
        NEEDS.get(kind, lambda r: None)(shown)
        made.SetRepresentation(shown)
    elif hasattr(made, "CreateDefaultRepresentation"):
        made.CreateDefaultRepresentation()
    made.SetEnabled(True)
    return made
