#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that all that the public headers declare is described, as Documentation/Doxyfile says.

    check_api.py ROOT

Doxygen says nothing, or names what has no description.
"""

import os
import subprocess
import sys
import tempfile

RULES = "Documentation/Doxyfile"


def main():
    if len(sys.argv) != 2 or not os.path.isfile(os.path.join(sys.argv[1], RULES)):
        sys.exit("check_api.py: name the root of the checkout, which holds %s" % RULES)
    with tempfile.TemporaryDirectory(prefix="api-") as folder:
        # the later line counts
        more = "@INCLUDE = %s\nOUTPUT_DIRECTORY = %s\n" % (RULES, folder)
        done = subprocess.run(
            ["doxygen", "-"],
            cwd=sys.argv[1],
            input=more,
            capture_output=True,
            text=True,
            check=False,
        )
        pages = sum(len(names) for _, _, names in os.walk(folder))
    said = sorted(set((done.stdout + done.stderr).split("\n")) - {""})
    print("".join(line + "\n" for line in said), end="")
    print("api: %d files written, Doxygen says %d" % (pages, done.returncode))
    sys.exit(1 if said or done.returncode or not pages else 0)


if __name__ == "__main__":
    main()
