#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that Documentation/tolerances.md tells the truth.

    check_tolerances.py ROOT

Every row of its tables, `| name | value | unit | ... | [file](../path) |`, must find
`name = value` in that file.
"""

import os
import re
import sys

PAGE = "Documentation/tolerances.md"
ROW = re.compile(r"^\| `(\w+)` \| `([^`]+)` \|.*\| \[[^\]]+\]\(\.\./([^)]+)\) \|$", re.M)


def complaint(root, name, value, path):
    """What is wrong with one row, or None."""
    full = os.path.join(root, path)
    if not os.path.isfile(full):
        return "there is no %s" % path
    with open(full, encoding="utf-8") as stream:
        found = re.findall(r"\b%s\s*=\s*([^;#\n]+)" % name, stream.read())
    values = [text.strip() for text in found]
    if value not in values:
        return "%s has %s, not %s" % (path, " and ".join(values) or "no such name", value)
    return None


def main():
    if len(sys.argv) != 2 or not os.path.isfile(os.path.join(sys.argv[1], PAGE)):
        sys.exit("check_tolerances.py: name the root of the checkout")
    with open(os.path.join(sys.argv[1], PAGE), encoding="utf-8") as stream:
        text = stream.read()
    rows = ROW.findall(text)
    written = len(re.findall(r"^\| `", text, re.M))
    wrong = 0 if rows and len(rows) == written else 1
    for name, value, path in rows:
        text = complaint(sys.argv[1], name, value, path)
        if text:
            print("%s: tolerance: %s: %s" % (PAGE, name, text))
            wrong += 1
    print("tolerances: %d of %d rows read, %d wrong" % (len(rows), written, wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
