#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the spelling of every text file of the checkout, as .codespellrc says.

    check_spelling.py ROOT [CODESPELL]
"""

import os
import subprocess
import sys

from sources import find_sources


def main():
    if len(sys.argv) < 2 or not os.path.isdir(sys.argv[1]):
        sys.exit("check_spelling.py: name the root of the checkout")
    tool = sys.argv[2] if len(sys.argv) > 2 else "codespell"
    paths = [source.path for source in find_sources(sys.argv[1])]
    if not paths:
        sys.exit("check_spelling.py: no text below %s" % sys.argv[1])
    rules = os.path.abspath(os.path.join(sys.argv[1], ".codespellrc"))
    command = [tool, "--config", rules] + paths
    status = subprocess.run(command, cwd=sys.argv[1], check=False).returncode
    print("spelling: %d files read, codespell says %d" % (len(paths), status))
    sys.exit(1 if status else 0)


if __name__ == "__main__":
    main()
