#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs widefov-render or widefov-viewer on bad input and checks how it fails.

    run_bad_input.py PROGRAM [GROUP...]      groups: see cases.py; none named: all

For every row of the table: the exit code of the contract, exactly one line on standard
error that begins with the program's name and holds what the row says, an earlier output
file untouched, no other file left, no crash, no hang.
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
import time

from cases import DONE, GROUPS
from inputs import write_inputs
from places import OLD, Place

# Seconds until a run counts as hanging: far above what the slowest row takes, also on
# two busy cores.
TIMEOUT = 60

RENDER = "widefov-render"
VIEWER = "widefov-viewer"


def is_viewer(program):
    return os.path.basename(program) == VIEWER


def prefix_of(program):
    """What each line begins with."""
    return (VIEWER if is_viewer(program) else RENDER) + ": "


def command_of(program, case, out):
    """The command line of a row, small and with two outputs where it names none; the viewer
    ends by itself."""
    words = [word.replace("{out}", out) for word in shlex.split(case.arguments)]
    if words and not {"--size", "--display"} & set(words):
        words += ["--size", "64x32"]
    if is_viewer(program):
        return [program] + words + ([] if "--frames" in words else ["--frames", "2"])
    if words and not {"--output", "--aov"} & set(words) and not words[0].startswith("--list"):
        words += ["--output", os.path.join(out, "old.png")]
        words += ["--output", os.path.join(out, "new.png")]
    return [program] + words


def environment_of(case, place):
    env = {**os.environ, **place.environment()}
    for name, value in case.env.items():
        env.pop(name, None)
        if value is not None:
            env[name] = value
    return env


# What a slow machine makes the program say while it works: no message about the input.
PROGRESS = re.compile(r"widefov-\w+: [^:]* \((\d+ %, )?\d+ s\)$")

# Where the eye is of files for which nobody says: of good ones, too.
EYE = re.compile(r"widefov-\w+: the eye is (in|out)side, at ")


def complaints_about_text(program, case, text):
    """What is wrong with standard error."""
    lines = [line for line in text.splitlines() if not PROGRESS.match(line) and not EYE.match(line)]
    wanted = 0 if case.says is None else 1
    if len(lines) != wanted:
        yield "%d lines on standard error, not %d" % (len(lines), wanted)
    for line in lines:
        if not line.startswith(prefix_of(program)):
            yield "a line does not begin with '%s'" % prefix_of(program)
    if case.says and case.says.lower() not in text.lower():
        yield "the message does not name '%s'" % case.says


def complaints_about_files(program, case, place):
    """What is wrong with the folder of outputs."""
    left = sorted(os.listdir(place.folder))
    if case.code == DONE and not is_viewer(program):
        if left != ["new.png", "old.png"]:
            yield "outputs are %s" % left
        return
    if left != place.before:
        yield "files left behind: %s, at first %s" % (left, place.before)
    with open(os.path.join(place.folder, "old.png"), "rb") as stream:
        if stream.read() != OLD:
            yield "the earlier output file was changed"


def run(command, case, place, inputs):
    """Exit code and standard error, or None for a run that hangs."""
    options = {"stdout": subprocess.DEVNULL, **place.options()}
    try:
        done = subprocess.run(
            place.wrap(command),
            cwd=inputs,
            env=environment_of(case, place),
            stdin=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            timeout=TIMEOUT,
            check=False,
            **options,
        )
    except subprocess.TimeoutExpired:
        return None, ""
    return done.returncode, done.stderr.decode("utf-8", "replace")


def try_case(program, case, inputs):
    """The complaints about one row, [] where it is as it should be, None where this
    machine cannot try it (a container that allows no mounts of one's own)."""
    with tempfile.TemporaryDirectory(prefix="bad-input-") as parent:
        place = Place(case.place, parent)
        if not place.possible:
            return None
        code, text = run(command_of(program, case, place.out), case, place, inputs)
        if code is None:
            return ["still running after %d s" % TIMEOUT]
        found = []
        if code < 0 or code >= 128:
            found.append("crashed: exit code %d" % code)
        elif code != case.code:
            found.append("exit code %d, not %d" % (code, case.code))
        found += complaints_about_text(program, case, text)
        found += complaints_about_files(program, case, place)
        return found + (["it said:\n%s" % text[:1000].rstrip()] if found else [])


def report(case, found, seconds):
    """Prints one row and what is wrong with it; its verdict."""
    verdict = "none" if found is None else "BAD" if found else "good"
    extra = " ".join("%s=%s" % item for item in case.env.items())
    label = "%s  [%s] %s" % (case.arguments or "(nothing)", case.place, extra)
    print("%-4s %5.1f s  %s" % (verdict, seconds, label.rstrip()))
    for complaint in found or []:
        print("       " + complaint.replace("\n", "\n         "))
    sys.stdout.flush()
    return verdict


def main():
    if len(sys.argv) < 2 or not os.access(sys.argv[1], os.X_OK):
        sys.exit("run_bad_input.py: name the program to test")
    program = os.path.abspath(sys.argv[1])
    all_names = ["Viewer"] if is_viewer(program) else [name for name in GROUPS if name != "Viewer"]
    names = sys.argv[2:] or all_names
    verdicts = []
    with tempfile.TemporaryDirectory(prefix="bad-input-files-") as inputs:
        write_inputs(inputs)
        for case in [case for name in names for case in GROUPS[name]]:
            start = time.monotonic()
            found = try_case(program, case, inputs)
            verdicts.append(report(case, found, time.monotonic() - start))
    good, bad, none = [verdicts.count(verdict) for verdict in ("good", "BAD", "none")]
    print("bad input: %d rows good, %d wrong, %d that cannot be tried here" % (good, bad, none))
    sys.exit(0 if good and not bad else 1)


if __name__ == "__main__":
    main()
