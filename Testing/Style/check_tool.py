#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the sources of the checkout with one of the programs that know their language.

    check_tool.py format|spelling|shell ROOT

format: every C++ source is as .clang-format says (to mend one: clang-format -i FILE).
spelling: no text has a word that .codespellrc does not allow.
shell: no script has what ShellCheck warns of, but for what .shellcheckrc allows.
"""

import os
import subprocess
import sys

from sources import CPP, SHELL, TEXT, find_sources

# what it reads, the file of its rules, its command
TOOLS = {
    "format": (CPP, ".clang-format", ["clang-format", "--dry-run", "-Werror", "--style=file"]),
    "spelling": (TEXT, ".codespellrc", ["codespell", "--config", ".codespellrc"]),
    "shell": (SHELL, ".shellcheckrc", ["shellcheck", "--format=gcc"]),
}


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in TOOLS:
        sys.exit("check_tool.py: name %s and the root of the checkout" % "|".join(TOOLS))
    name, root = sys.argv[1:]
    endings, rules, command = TOOLS[name]
    if not os.path.isfile(os.path.join(root, rules)):
        sys.exit("check_tool.py: name the root of the checkout, which holds %s" % rules)
    paths = [source.path for source in find_sources(root) if source.is_kind(endings)]
    if not paths:
        sys.exit("check_tool.py: nothing to read below %s" % root)
    status = subprocess.run(command + paths, cwd=root, check=False).returncode
    print("%s: %d files read, %s says %d" % (name, len(paths), command[0], status))
    sys.exit(1 if status else 0)


if __name__ == "__main__":
    main()
