#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of the page of errors: the worst of all scenes for each projection.

    errors.py PAGE.md BENCH.json...

Replaces what stands between <!-- begin errors --> and <!-- end errors --> in the page.
"""

import json
import re
import sys

COLUMNS = ["projection", "method", "pictures", "wrong pixels", "unexplained", "max, px",
           "depth, relative", "depth, px"]


def rows_of(bench):
    """One a method: the worst of its pictures, pixels counted."""
    methods = {}
    for r in bench["records"]:
        name = r["method"] + (" %g" % r["parameter"] if r["parameter"] is not None else "")
        methods.setdefault(name, []).append(r)
    for name, records in sorted(methods.items()):
        errors = [r["error"] for r in records]
        yield [
            records[0]["projection"],
            name,
            str(len(records)),
            str(sum(e["mismatched_pixels"] for e in errors)),
            "%.2g" % max(e["unexplained"] for e in errors),
            "%.2g" % max(e["max_px"] for e in errors),
            "%.2g" % max(e["max_depth_rel"] for e in errors),
            "%.2g" % max(e["depth_px"] for e in errors),
        ]


def main():
    page, files = sys.argv[1], sys.argv[2:]
    rows = [COLUMNS, ["---"] * len(COLUMNS)]
    for name in files:
        with open(name, encoding="utf-8") as file:
            rows += rows_of(json.load(file))
    table = "".join("| " + " | ".join(row) + " |\n" for row in rows)
    with open(page, encoding="utf-8") as file:
        text = file.read()
    begin, end = "<!-- begin errors -->\n", "<!-- end errors -->"
    text, found = re.subn(
        re.escape(begin) + ".*?" + re.escape(end), lambda _: begin + table + end, text, flags=re.S)
    if found != 1:
        sys.exit("errors.py: %s has no place for the table" % page)
    with open(page, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
