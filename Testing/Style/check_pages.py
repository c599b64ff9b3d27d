#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that every projection has its page, its picture and its line in the index, and that the
page on exactness says of every technique what it promises.

    check_pages.py ROOT

The names come from the registries, Module/Projections/ProjectionRegistry.cxx and
Module/Frame/Technique.cxx.
"""

import os
import re
import sys

REGISTRY = "Module/Projections/ProjectionRegistry.cxx"
TECHNIQUES = "Module/Frame/Technique.cxx"
PROMISES = "Documentation/exactness.md"
PAGES = "Documentation/projections"
INDEX = "Documentation/README.md"
ENTRY = re.compile(r'WFV_PROJECTION\(\s*\w+,\s*"([^"]+)"')
TECHNIQUE = re.compile(r'^\s*\{ "(\w+)", "', re.M)
PICTURE = re.compile(r"^!\[[^\]]+\]\(([^)]+)\)$", re.M)
SECTIONS = (
    "Formula", "Inverse", "Domain", "Discontinuities", "Parameters", "Properties", "Sources",
)


def read(root, path):
    full = os.path.join(root, path)
    if not os.path.isfile(full):
        return None
    with open(full, encoding="utf-8") as stream:
        return stream.read()


def complaints(root, name, index):
    """What is missing of one projection."""
    if read(root, "Module/Projections/%s.glsl" % name) is None:
        yield "there is no Module/Projections/%s.glsl" % name
    if "(projections/%s.md)" % name not in index:
        yield "%s has no link to projections/%s.md" % (INDEX, name)
    page = read(root, "%s/%s.md" % (PAGES, name))
    if page is None:
        yield "there is no %s/%s.md" % (PAGES, name)
        return
    for section in SECTIONS:
        if "\n## %s\n" % section not in page:
            yield "its page has no section '%s'" % section
    if "--projection %s" % name not in page:
        yield "its page has no command that draws it"
    pictures = PICTURE.findall(page)
    if not pictures:
        yield "its page has no picture"
    for picture in pictures:
        if not os.path.isfile(os.path.join(root, PAGES, picture)):
            yield "its picture %s is missing" % picture


def main():
    if len(sys.argv) != 2 or read(sys.argv[1], REGISTRY) is None:
        sys.exit("check_pages.py: name the root of the checkout")
    root = sys.argv[1]
    names = ENTRY.findall(read(root, REGISTRY))
    index = read(root, INDEX) or ""
    wrong = 0 if names else 1
    for name in names:
        for text in complaints(root, name, index):
            print("%s: page: %s" % (name, text))
            wrong += 1
    pages = os.path.join(root, PAGES)
    for file in sorted(os.listdir(pages)) if os.path.isdir(pages) else []:
        if file.endswith(".md") and file[:-3] not in names:
            print("%s: page: no projection has this name" % file)
            wrong += 1
    promises = read(root, PROMISES) or ""
    for technique in TECHNIQUE.findall(read(root, TECHNIQUES) or ""):
        if not re.search(r"^\| `%s`" % technique, promises, re.M):
            print("%s: page: %s promises nothing of it" % (technique, PROMISES))
            wrong += 1
    print("pages: %d projections, %d complaints" % (len(names), wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
