# SPDX-License-Identifier: BSD-3-Clause
"""Python imports this when it starts, where widefov-run has put it ahead on PYTHONPATH.

Classes of programs (PyVista's Renderer, for one) that are derived from vtkOpenGLRenderer are made by no
factory of VTK's, but those derived from vtkRenderer are: the one name stands for the other here.
"""

import importlib.abc
import importlib.util
import os
import sys


def come_first(_):
    """Since VTK 9.6 the package puts a finder of its own, of all its modules, ahead of others."""
    sys.meta_path.remove(FINDER)
    sys.meta_path.insert(0, FINDER)


def make_wide(module):
    from vtkmodules.vtkRenderingCore import vtkCamera, vtkPolyDataMapper, vtkRenderer

    module.vtkOpenGLRenderer = vtkRenderer
    module.vtkOpenGLCamera = vtkCamera
    module.vtkOpenGLPolyDataMapper = vtkPolyDataMapper


class Loader(importlib.abc.Loader):
    """Of a module, by its own loader, and then one thing more."""

    def __init__(self, own, more):
        self.own = own
        self.more = more

    def __getattr__(self, name):
        return getattr(self.own, name)

    def create_module(self, spec):
        return self.own.create_module(spec)

    def exec_module(self, module):
        self.own.exec_module(module)
        self.more(module)


MORE = {"vtkmodules": come_first, "vtkmodules.vtkRenderingOpenGL2": make_wide}


class Finder(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if name not in MORE:
            return None
        sys.meta_path.remove(self)
        try:
            spec = importlib.util.find_spec(name)  # of those who are left
        finally:
            sys.meta_path.insert(0, self)
        if spec is not None:
            spec.loader = Loader(spec.loader, MORE[name])
        return spec


def import_next():
    """The file of this name that Python would have imported without this one."""
    here = os.path.dirname(os.path.abspath(__file__))
    sys.path[:] = [folder for folder in sys.path if os.path.abspath(folder) != here]
    own = sys.modules.pop("sitecustomize", None)
    try:
        import sitecustomize  # noqa: F401 pylint: disable=import-self
    except ImportError:
        sys.modules["sitecustomize"] = own


FINDER = Finder()
sys.meta_path.insert(0, FINDER)
import_next()
