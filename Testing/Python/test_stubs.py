#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The type stubs name every class and every method of the module, with types.

    PYTHONPATH=FOLDER test_stubs.py
"""

import ast
import keyword
import os
import unittest

import widefov
from widefov import vtkRenderingWideFoV as module


def read_stubs():
    """Class -> (base, names of its members, member -> its heads)."""
    folder = os.path.dirname(widefov.__file__)
    with open(os.path.join(folder, "vtkRenderingWideFoV.pyi"), encoding="utf-8") as stream:
        tree = ast.parse(stream.read())
    classes = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            heads = {}
            for member in node.body:
                if isinstance(member, ast.FunctionDef):
                    heads.setdefault(member.name, []).append(member)
                elif isinstance(member, ast.AnnAssign):
                    heads.setdefault(member.target.id, [])
            classes[node.name] = (node.bases[0].id, heads)
    return classes


class Stubs(unittest.TestCase):
    def setUp(self):
        self.stubs = read_stubs()
        self.classes = {k: v for k, v in vars(module).items() if isinstance(v, type)}

    def test_all_is_there(self):
        self.assertEqual(set(self.stubs), set(self.classes))
        for name, cls in self.classes.items():
            base, members = self.stubs[name]
            self.assertEqual(base, cls.__bases__[0].__name__)
            own = {
                key for key, value in vars(cls).items()
                if not key.startswith("__") and not isinstance(value, type)
                and not keyword.iskeyword(key)  # a property "pass", which stubs cannot name
            }
            self.assertEqual(own - set(members), set(), name)

    def test_types(self):
        heads = self.stubs["vtkWideFoVCamera"][1]
        (lens,) = heads["SetLens"]
        self.assertEqual([ast.unparse(arg.annotation) for arg in lens.args.args[1:]], ["float"] * 5)
        self.assertEqual(ast.unparse(lens.returns), "bool")
        (ray,) = heads["NDCToRay"]
        self.assertEqual(
            [ast.unparse(arg.annotation) for arg in ray.args.args[1:]],
            ["Sequence[float]", "float", "MutableSequence[float]", "MutableSequence[float]"])
        self.assertEqual(len(self.stubs["vtkWideFoVPass"][1]["SetRelaxationRange"]), 2)

    def test_nothing_is_left_open(self):
        for name, (_base, members) in self.stubs.items():
            for heads in members.values():
                for head in heads:
                    self.assertNotIn("Any", ast.unparse(head), name)


if __name__ == "__main__":
    unittest.main(verbosity=2)
