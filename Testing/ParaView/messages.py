# SPDX-License-Identifier: BSD-3-Clause
"""What VTK and ParaView say in this process, for tests of messages."""

import os

from vtkmodules.vtkCommonCore import vtkFileOutputWindow, vtkOutputWindow


class Log:
    """What VTK and ParaView say in the meantime."""

    def __init__(self, options, name):
        self.path = os.path.join(options.output, name + ".log")

    def __enter__(self):
        self.before = vtkOutputWindow.GetInstance()
        self.window = vtkFileOutputWindow()
        self.window.SetFileName(self.path)
        self.window.FlushOn()
        open(self.path, "w").close()
        vtkOutputWindow.SetInstance(self.window)
        return self

    def __exit__(self, *_):
        vtkOutputWindow.SetInstance(self.before)

    def count(self, words):
        with open(self.path) as file:
            return file.read().count(words)

    def find(self, words):
        """The lines with these words in them."""
        with open(self.path) as file:
            return [line.strip() for line in file if words in line]
