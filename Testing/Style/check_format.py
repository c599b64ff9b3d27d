#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that every C++ source of the checkout is formatted as .clang-format says.

    check_format.py ROOT [CLANG_FORMAT]

To mend a file: clang-format -i FILE.
"""

import os
import subprocess
import sys

from sources import CPP, find_sources


def main():
    if len(sys.argv) < 2 or not os.path.isfile(os.path.join(sys.argv[1], ".clang-format")):
        sys.exit("check_format.py: name the root of the checkout, which holds .clang-format")
    tool = sys.argv[2] if len(sys.argv) > 2 else "clang-format"
    paths = [source.path for source in find_sources(sys.argv[1]) if source.is_kind(CPP)]
    if not paths:
        sys.exit("check_format.py: no C++ source below %s" % sys.argv[1])
    command = [tool, "--dry-run", "-Werror", "--style=file"] + paths
    status = subprocess.run(command, cwd=sys.argv[1], check=False).returncode
    print("format: %d sources read, clang-format says %d" % (len(paths), status))
    sys.exit(1 if status else 0)


if __name__ == "__main__":
    main()
