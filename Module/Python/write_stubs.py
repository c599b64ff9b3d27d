#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the type stubs (.pyi) of a module that VTK's wrapper made.

    write_stubs.py MODULE FILE

The types are read from the first lines of the methods' documentation, which the wrapper writes:
`SetLens(self, c1:float, ..) -> bool`, once for each signature, each followed by its line of C++. In
them (float, float) is a tuple, and [float, float] a list that is filled.
"""

import ast
import importlib
import keyword
import re
import sys

PLAIN = {"bool", "bytes", "float", "int", "str", "None"}

# A signature ends where the line of C++ begins; it may go on over indented lines.
SIGNATURE = re.compile(r"^(\w+\(.*?)\nC\+\+:", re.S | re.M)

HEADER = '''# Written by Module/Python/write_stubs.py
from typing import Any, MutableSequence, Sequence, Tuple, overload

'''


def find_classes():
    """Name of each class of VTK's that is loaded -> its module."""
    homes = {}
    for name, module in sorted(sys.modules.items()):
        if name.startswith("vtkmodules.vtk"):
            for key, value in vars(module).items():
                if isinstance(value, type):
                    homes.setdefault(key, value.__module__)
    return homes


class Types:
    """Python's words for the wrapper's; `used` are the classes of other modules that it met."""

    def __init__(self, own):
        self.own = own
        self.homes = find_classes()
        self.used = set()

    def name(self, word):
        if word in PLAIN or word in self.own:
            return word
        if word in self.homes:
            self.used.add(word)
            return word
        return "Any"

    def of(self, node, given=False):
        """given: it is an argument, for which any sequence serves."""
        if isinstance(node, ast.Constant) and node.value in (None, ...):
            return "None" if node.value is None else "..."
        if isinstance(node, ast.Name):
            return self.name(node.id)
        if isinstance(node, ast.Tuple) and given:
            return "Sequence[%s]" % self.of(node.elts[0])
        if isinstance(node, ast.Tuple):
            return "Tuple[%s]" % ", ".join(self.of(each) for each in node.elts)
        if isinstance(node, ast.List) and node.elts:
            return "MutableSequence[%s]" % self.of(node.elts[0])
        return "Any"


def argument(types, arg, default):
    words = arg.arg if arg.annotation is None else "%s: %s" % (arg.arg, types.of(arg.annotation, given=True))
    return words + (" = ..." if default else "")


def head_of(types, signature, static):
    """A function's head from one signature."""
    name, rest = signature.split("(", 1)
    node = ast.parse("def f(%s: ..." % rest).body[0]
    args = node.args.args
    plain = len(args) - len(node.args.defaults)
    words = [argument(types, arg, i >= plain) for i, arg in enumerate(args)]
    if node.args.vararg:
        words.append("*" + argument(types, node.args.vararg, False))
    if static and words[:1] == ["self"]:
        words = words[1:]
    result = types.of(node.returns) if node.returns else "Any"
    return "def %s(%s) -> %s: ..." % (name, ", ".join(words), result)


def method_lines(types, method):
    doc = method.__doc__ or ""
    signatures = [" ".join(text.split()) for text in SIGNATURE.findall(doc)]
    for signature in signatures:
        static = "(self" not in signature
        if len(signatures) > 1:
            yield "@overload"
        if static:
            yield "@staticmethod"
        yield head_of(types, signature, static)


def getter_of(cls, name):
    """The method that a property of the wrapper's (VTK 9.4 and later) calls, or None."""
    wanted = "get" + name.replace("_", "")
    found = [key for key in dir(cls) if key.lower() == wanted and key[0] == "G"]
    return getattr(cls, found[0]) if found else None


def property_line(types, cls, name):
    getter = getter_of(cls, name)
    lines = list(method_lines(types, getter)) if getter else []
    heads = [line for line in lines if line.startswith("def") and "(self)" in line]
    return "%s: %s" % (name, re.search(r"-> (.*): \.\.\.", heads[0]).group(1) if heads else "Any")


def member_lines(types, cls):
    for name, value in cls.__dict__.items():
        kind = type(value).__name__
        if name.startswith("__") or keyword.iskeyword(name):  # as vtkRenderer's property "pass"
            continue
        if isinstance(value, type):  # an enumeration
            yield "class %s(int): ..." % name
        elif isinstance(value, int):
            yield "%s: %s" % (name, type(value).__name__)
        elif kind == "getset_descriptor":
            yield property_line(types, cls, name)
        elif callable(value):
            yield from method_lines(types, value)


def class_lines(types, cls):
    base = cls.__bases__[0].__name__
    yield "class %s(%s):" % (cls.__name__, types.name(base))
    members = list(member_lines(types, cls))
    for line in members or ["..."]:
        yield "    " + line


def in_order(classes):
    """A base before what is derived from it."""
    return sorted(classes, key=lambda cls: (len(cls.__mro__), cls.__name__))


def write(module_name):
    module = importlib.import_module(module_name)
    classes = in_order(value for value in vars(module).values() if isinstance(value, type))
    types = Types({cls.__name__ for cls in classes})
    body = []
    for cls in classes:
        body += ["", *class_lines(types, cls)]
    imports = ["from %s import %s" % (types.homes[name], name) for name in sorted(types.used)]
    return HEADER + "\n".join(imports + body) + "\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    text = write(sys.argv[1])
    ast.parse(text)  # what is no Python is not written
    with open(sys.argv[2], "w", encoding="utf-8") as stream:
        stream.write(text)


if __name__ == "__main__":
    main()
