# SPDX-License-Identifier: BSD-3-Clause
"""How to make something to see of every class of VTK that draws: round the origin, about two wide.

A class without a recipe is made as it comes. What a version of VTK does not have is left out by the caller.
"""

import vtk

from mappers import MAPPERS, volume
from materials import BOUNDS, actor_of, ball, image, mapper_of, slice_of, texture


def vtkAssembly():
    made = vtk.vtkAssembly()
    for x in (-0.6, 0.6):
        made.AddPart(actor_of(ball(0.4, (x, 0, 0))))
    return made


def vtkPropAssembly():
    made = vtk.vtkPropAssembly()
    for x in (-0.6, 0.6):
        made.AddPart(actor_of(ball(0.4, (x, 0, 0))))
    return made


def vtkAnnotatedCubeActor():
    made = vtk.vtkAnnotatedCubeActor()
    made.SetFaceTextScale(0.4)
    return made


def vtkAxesActor():
    made = vtk.vtkAxesActor()
    made.AxisLabelsOff()  # of pixels
    made.SetShaftTypeToCylinder()
    return made


def vtkAxisActor():
    made = vtk.vtkAxisActor()
    made.SetAxisTypeToX()
    made.SetPoint1(-1, 0, 0)
    made.SetPoint2(1, 0, 0)
    made.SetBounds(BOUNDS)
    made.SetRange(0, 1)
    made.SetDeltaRangeMajor(0.25)
    made.SetMajorTickSize(0.2)
    made.LabelVisibilityOff()
    made.TitleVisibilityOff()
    return made


def vtkCubeAxesActor():
    made = vtk.vtkCubeAxesActor()
    made.SetBounds(BOUNDS)
    made.SetFlyModeToStaticEdges()
    for axis in "XYZ":
        getattr(made, "%sAxisLabelVisibilityOff" % axis)()
        getattr(made, "Set%sTitle" % axis)("")
    return made


def vtkGridAxesActor3D():
    made = vtk.vtkGridAxesActor3D()
    made.SetGridBounds(*BOUNDS)
    made.SetLabelMask(0)  # of pixels
    for axis in range(3):
        made.SetUseCustomLabels(axis, True)  # or each view has as many lines as it has room for
        made.SetNumberOfLabels(axis, 3)
        for i in range(3):
            made.SetLabel(axis, i, 0.3 * (i - 1))
    return made


def vtkPolarAxesActor():
    made = vtk.vtkPolarAxesActor()
    made.SetBounds(-1, 1, -1, 1, 0, 0)
    made.SetPole(0, 0, 0)
    made.SetMaximumRadius(1)
    made.SetMaximumAngle(300)
    made.PolarLabelVisibilityOff()
    made.PolarTitleVisibilityOff()
    made.RadialTitleVisibilityOff()
    return made


def vtkCameraActor():
    camera = vtk.vtkCamera()
    camera.SetPosition(0, 0, 0.8)
    camera.SetFocalPoint(0.2, 0.1, -1)
    camera.SetClippingRange(0.3, 1.6)
    made = vtk.vtkCameraActor()
    made.SetCamera(camera)
    return made


def vtkLightActor():
    light = vtk.vtkLight()
    light.SetPositional(True)
    light.SetConeAngle(25)
    light.SetPosition(0, 0.8, 0)
    light.SetFocalPoint(0, -0.8, 0)
    made = vtk.vtkLightActor()
    made.SetLight(light)
    made.SetClippingRange(0.2, 1.4)
    return made


def vtkImageStack():
    made = vtk.vtkImageStack()
    for layer in range(2):
        part = slice_of(image())
        part.SetScale(1 - 0.5 * layer)
        part.GetProperty().SetLayerNumber(layer)
        part.GetProperty().SetOpacity(1)
        made.AddImage(part)
    return made


def vtkImageSlice():
    return slice_of(image())


def vtkImageActor():
    made = vtk.vtkImageActor()
    made.SetInputData(image())
    made.InterpolateOff()
    return made


def vtkLODActor():
    return actor_of(ball(), vtk.vtkLODActor)


def vtkQuadricLODActor():
    return actor_of(ball(), vtk.vtkQuadricLODActor)


def vtkLODProp3D():
    made = vtk.vtkLODProp3D()
    made.AddLOD(mapper_of(ball()), 0.0)
    return made


def words():
    text = vtk.vtkVectorText()
    text.SetText("Ahoy")
    return text


def vtkFollower():
    return actor_of(words(), vtk.vtkFollower)


def vtkAxisFollower():
    axis = vtkAxisActor()
    made = actor_of(words(), vtk.vtkAxisFollower)
    made.SetAxis(axis)
    return made


def vtkProp3DFollower():
    made = vtk.vtkProp3DFollower()
    made.SetProp3D(actor_of(words()))
    return made


def vtkProp3DAxisFollower():
    made = vtk.vtkProp3DAxisFollower()
    made.SetProp3D(actor_of(words()))
    made.SetAxis(vtkAxisActor())
    return made


def with_input(kind, text="Ahoy"):
    made = kind()
    made.SetInput(text)
    return made


def vtkBillboardTextActor3D():
    return with_input(vtk.vtkBillboardTextActor3D)


def vtkFlagpoleLabel():
    made = with_input(vtk.vtkFlagpoleLabel)
    made.SetBasePosition(0, -0.5, 0)
    made.SetTopPosition(0, 0.5, 0)
    return made


def vtkTextActor3D():
    made = with_input(vtk.vtkTextActor3D)
    made.SetScale(0.05)
    return made


def vtkTextActor():
    return with_input(vtk.vtkTextActor)


def vtkScaledTextActor():
    return with_input(vtk.vtkScaledTextActor)


def vtkCornerAnnotation():
    made = vtk.vtkCornerAnnotation()
    made.SetText(0, "Ahoy")
    return made


def vtkCaptionActor2D():
    made = vtk.vtkCaptionActor2D()
    made.SetCaption("Ahoy")
    made.SetAttachmentPoint(0, 0, 0)
    return made


def vtkScalarBarActor():
    made = vtk.vtkScalarBarActor()
    table = vtk.vtkLookupTable()
    table.Build()
    made.SetLookupTable(table)
    return made


def vtkTexturedActor2D():
    plane = vtk.vtkPlaneSource()
    made = vtk.vtkTexturedActor2D()
    mapper = vtk.vtkPolyDataMapper2D()
    mapper.SetInputConnection(plane.GetOutputPort())
    made.SetMapper(mapper)
    made.SetTexture(texture())
    return made


def vtkCubeAxesActor2D():
    made = vtk.vtkCubeAxesActor2D()
    made.SetBounds(*BOUNDS)
    return made


def vtkResliceCursorActor():
    cursor = vtk.vtkResliceCursor()
    cursor.SetImage(image(16, 8))
    cursor.SetCenter(0, 0, 0)
    cursor.Initialize() if hasattr(cursor, "Initialize") else None
    made = vtk.vtkResliceCursorActor()
    made.GetCursorAlgorithm().SetResliceCursor(cursor)
    made.GetCursorAlgorithm().SetReslicePlaneNormal(2)
    return made


def vtkVolume():
    return volume(vtk.vtkGPUVolumeRayCastMapper())


def vtkSkybox():
    made = vtk.vtkSkybox()
    made.SetTexture(texture())
    made.SetProjectionToSphere()
    return made


def vtkActor():
    return actor_of(ball())


def make(name):
    """Something of this class, or by this mapper."""
    recipe = MAPPERS.get(name) or globals().get(name)
    return recipe() if recipe else getattr(vtk, name)()
