# SPDX-License-Identifier: BSD-3-Clause
"""What the things to see are made of."""

import vtk

# Python lets go of a source whose output port is all that is asked for.
KEPT = []

BOUNDS = (-1, 1, -0.8, 0.8, -0.6, 0.6)


def mapper_of(source, kind=None):
    mapper = (kind or vtk.vtkPolyDataMapper)()
    mapper.SetInputConnection(source.GetOutputPort())
    return mapper


def ball(radius=0.5, centre=(0, 0, 0), resolution=24):
    source = vtk.vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(centre)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    KEPT.append(source)
    return source


def actor_of(source, kind=None):
    actor = (kind or vtk.vtkActor)()
    actor.SetMapper(mapper_of(source))
    return actor


def image(size=16, depth=1):
    """Colours that differ everywhere."""
    data = vtk.vtkImageData()
    data.SetDimensions(size, size, depth)
    data.SetSpacing(2 / size, 2 / size, 2 / max(2, depth))
    data.SetOrigin(-1, -1, -0.5 if depth > 1 else 0)
    data.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 1 if depth > 1 else 3)
    for k in range(depth):
        for j in range(size):
            for i in range(size):
                data.SetScalarComponentFromDouble(i, j, k, 0, 60 + 10 * i)
                if depth == 1:
                    data.SetScalarComponentFromDouble(i, j, k, 1, 250 - 8 * j)
                    data.SetScalarComponentFromDouble(i, j, k, 2, 128)
    return data


def texture():
    made = vtk.vtkTexture()
    made.SetInputData(image())
    return made


def slice_of(data, kind=None):
    mapper = (kind or vtk.vtkImageSliceMapper)()
    mapper.SetInputData(data)
    made = vtk.vtkImageSlice()
    made.SetMapper(mapper)
    made.GetProperty().SetColorWindow(255)
    made.GetProperty().SetColorLevel(128)
    made.GetProperty().SetInterpolationTypeToNearest()
    return made
