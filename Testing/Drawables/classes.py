# SPDX-License-Identifier: BSD-3-Clause
"""The classes of Python's vtk that draw."""

import warnings

import vtk


def concrete(*kinds, but=()):
    """Names of the classes that can be made and are of one of the kinds: what a factory puts in the
    place of another is under the other's name alone, if the other can be made."""
    names = []
    for name in sorted(dir(vtk)):
        kind = getattr(vtk, name)
        if not isinstance(kind, type) or not issubclass(kind, kinds) or issubclass(kind, but):
            continue
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                kind()
        except (TypeError, NotImplementedError):
            continue
        names.append(name)
    return [name for name in names if name.replace("OpenGL", "", 1) == name
            or name.replace("OpenGL", "", 1) not in names]


def props():
    return concrete(vtk.vtkProp, but=(vtk.vtkWidgetRepresentation,))


def representations():
    return concrete(vtk.vtkWidgetRepresentation)


def passes():
    return concrete(vtk.vtkRenderPass)


def mappers():
    return concrete(vtk.vtkAbstractMapper)


def pickers():
    return concrete(vtk.vtkAbstractPicker)
