#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of the page of errors: the worst of all scenes for each projection.

    errors.py PAGE.md BENCH.json...

Replaces what stands between <!-- begin errors --> and <!-- end errors --> in the page, and
between the same marks of "limits", "wide" and "stretched". Rows that the files tell nothing of
stay, so that one projection can be measured anew.
"""

import json
import re
import sys

# Those that the second table is of: what is unexplained at 0.02 pixels, and distances.
STRICT = ("exact", "auto 0.02")

# Pixels of a picture: tables of their own have those of so many, and of so many more.
MANY = 4e6
MOST = 3e7


def name_of(record):
    parameter = record["parameter"]
    return record["method"] + ("" if parameter is None else " %g" % parameter)


def worst(errors, key, form="%.2g"):
    return form % max(error[key] for error in errors)


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def table(heads, rows):
    return row(heads) + row(["---"] * len(heads)) + "".join(row(cells) for cells in rows)


def pixels_of(record):
    return record["size"][0] * record["size"][1]


def read(files):
    for name in files:
        with open(name, encoding="utf-8") as file:
            yield from json.load(file)["records"]


def collect(records):
    """{projection: {method: [error of a picture]}}"""
    found = {}
    for record in records:
        of = record.get("directions_of")
        name = record["projection"] + (" of " + of if of else "")
        methods = found.setdefault(name, {})
        methods.setdefault(name_of(record), []).append(record["error"])
    return dict(sorted(found.items()))


def largest_errors(found):
    """Pixels, a column for each method and tolerance."""
    methods = sorted({method for of in found.values() for method in of}, key=order)
    pictures = {m: max(len(of.get(m, ())) for of in found.values()) for m in methods}
    heads = ["%s (%d)" % (method, pictures[method]) for method in methods]
    rows = (
        [projection] + [worst(of[m], "max_px") if m in of else "" for m in methods]
        for projection, of in found.items()
    )
    return table(["projection", *heads], rows)


def order(method):
    """exact first, then by name and tolerance."""
    name, _, tolerance = method.partition(" ")
    return (name != "exact", name, float(tolerance or 0))


def strict_errors(found):
    heads = ["projection", "method", "scenes", "wrong pixels", "unexplained", "max, px"]
    rows = (
        [
            projection,
            method,
            str(len(of[method])),
            str(sum(e["mismatched_pixels"] for e in of[method])),
            worst(of[method], "unexplained"),
            worst(of[method], "max_px"),
            worst(of[method], "max_depth_rel"),
        ]
        for projection, of in found.items()
        for method in STRICT
        if method in of
    )
    return table([*heads, "depth, relative"], rows)


def rows_of(lines, keys):
    """{what is in its first cells: a row}"""
    return {tuple(line.split("|")[1 : keys + 1]): line for line in lines}


def put(text, mark, keys, new):
    """Replaces the heads of a table and the rows that are new, told by so many first cells."""
    begin, end = "<!-- begin %s -->\n" % mark, "<!-- end %s -->" % mark
    place = re.search(re.escape(begin) + "(.*?)" + re.escape(end), text, flags=re.S)
    if not place:
        sys.exit("errors.py: the page has no place for the table \"%s\"" % mark)
    lines = new.splitlines(True)
    rows = {**rows_of(place.group(1).splitlines(True)[2:], keys), **rows_of(lines[2:], keys)}
    if len({line.count("|") for line in [lines[0], *rows.values()]}) > 1:
        sys.exit("errors.py: rows that stay in %s have other columns; measure all methods" % mark)
    in_order = sorted(rows, key=lambda cells: [cells[0], *map(order, map(str.strip, cells[1:]))])
    merged = "".join(lines[:2]) + "".join(rows[cells] for cells in in_order)
    return text[: place.start(1)] + merged + text[place.end(1) :]


def main():
    page, files = sys.argv[1], sys.argv[2:]
    records = list(read(files))
    found = collect(r for r in records if pixels_of(r) < MANY)
    stretched = collect(r for r in records if MANY <= pixels_of(r) < MOST)
    whole = collect(r for r in records if pixels_of(r) >= MOST)
    with open(page, encoding="utf-8") as file:
        text = file.read()
    # a projection that was drawn at the finest tolerance alone has no row among all of them
    coarse = {name: of for name, of in found.items() if not set(of) <= set(STRICT)}
    tables = [("errors", 2, strict_errors, found), ("limits", 1, largest_errors, coarse)]
    tables += [("wide", 2, strict_errors, whole), ("stretched", 2, strict_errors, stretched)]
    for mark, keys, write, of in tables:
        if of:
            text = put(text, mark, keys, write(of))
    with open(page, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
