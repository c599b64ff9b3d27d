#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands that stand on pages, and shows below each what it drew.

    run_pages.py PROGRAMS LARGEST CHECKOUT PAGE...

Every fenced block of "sh" on the pages is run by bash, in a folder beside its page and in the order of
the page, with the programs of the folder PROGRAMS; pictures are LARGEST pixels along their longer
side. The page is written anew with the pictures in it: it may be a link to the page of the checkout.
"""

import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
BLOCK = re.compile(r"^```sh\n(.*?)^```\n", re.S | re.M)
SHOWN = (".png", ".jpg")
# Of a film, or of the walls of a room.
MOST_SHOWN = 4


def fail(text):
    sys.exit("run_pages.py: " + text)


def spread(names):
    """No more than MOST_SHOWN of them, from the first to the last."""
    if len(names) <= MOST_SHOWN:
        return names
    return [names[i * (len(names) - 1) // (MOST_SHOWN - 1)] for i in range(MOST_SHOWN)]


def prepare(folder, checkout):
    """What the commands of a page find: their data, and the examples of the checkout."""
    os.makedirs(folder)
    os.symlink(os.path.join(checkout, "Examples"), os.path.join(folder, "Examples"))
    subprocess.run([sys.executable, "-B", os.path.join(HERE, "data.py"), os.path.join(folder, "data.vtu")],
        check=True)


def run(block, folder, environment):
    """The pictures that the block made, by their names."""
    before = set(os.listdir(folder))
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", block], cwd=folder, env=environment,
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        check=False)
    new = sorted(set(os.listdir(folder)) - before)
    if done.returncode or not new:
        said = done.stdout.strip() or "nothing"
        fail("%s: ended with %d, made %d files and said: %s\n%s"
            % (os.path.basename(folder), done.returncode, len(new), said, block))
    return spread([name for name in new if name.endswith(SHOWN)])


def show(folder, names):
    place = os.path.basename(folder)
    return "".join("\n![What the command above draws: %s](%s/%s)\n" % (name, place, name) for name in names)


def run_page(page, checkout, environment):
    with open(page, encoding="utf-8") as stream:
        text = stream.read()
    folder = os.path.splitext(page)[0] + "-files"
    prepare(folder, checkout)
    blocks = 0

    def with_pictures(match):
        nonlocal blocks
        blocks += 1
        return match.group(0) + show(folder, run(match.group(1), folder, environment))

    text = BLOCK.sub(with_pictures, text)
    os.remove(page)
    with open(page, "w", encoding="utf-8") as stream:
        stream.write(text)
    return blocks


def environment_of(programs, largest):
    """What the commands see: the programs, with pictures no larger than that."""
    environment = dict(os.environ, WIDEFOV_PROGRAMS=programs, WIDEFOV_LARGEST=largest)
    environment["PATH"] = os.pathsep.join([os.path.join(HERE, "programs"), programs, os.environ["PATH"]])
    return environment


def main():
    if len(sys.argv) < 5 or not sys.argv[2].isdigit():
        sys.exit(__doc__)
    programs, largest, checkout = sys.argv[1:4]
    environment = environment_of(programs, largest)
    blocks = 0
    for page in sys.argv[4:]:
        blocks += run_page(page, checkout, environment)
    print("run_pages.py: %d blocks of %d pages" % (blocks, len(sys.argv) - 4))
    if not blocks:
        fail("no commands on these pages")


if __name__ == "__main__":
    main()
