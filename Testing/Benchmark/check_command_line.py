#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How widefov-bench and widefov-stress fail.

    check_command_line.py WIDEFOV-BENCH WIDEFOV-STRESS

Every bad command line must end with its exit code, one line on standard error that
begins with the program's name and says what, and no file.
"""

import os
import subprocess
import sys
import tempfile

FAILED, USAGE = 1, 2
TIMEOUT = 120  # seconds: a run that takes longer hangs

# arguments ({out} is a folder), exit code, what the line must hold, changed environment
BOTH = [
    ("", USAGE, "--output", {}),
    ("--frobnicate --output {out}/x.json", USAGE, "--frobnicate", {}),
    ("stray --output {out}/x.json", USAGE, "stray", {}),
    ("--output", USAGE, "--output", {}),
    ("--output {out}/none/x.json", FAILED, "none", {}),
    ("--output {out}", FAILED, "folder", {}),
]
if os.environ.get("WIDEFOV_NEEDS_DISPLAY") != "OFF":
    BOTH += [
        ("--output {out}/x.json", FAILED, "display", {"DISPLAY": None}),
        ("--output {out}/x.json", FAILED, "display", {"DISPLAY": ":4242"}),
    ]
BENCH = [
    ("--scenes nowhere --output {out}/x.json", USAGE, "nowhere", {}),
    ("--scenes room, --output {out}/x.json", USAGE, "--scenes", {}),
    ("--methods magic --output {out}/x.json", USAGE, "magic", {}),
    ("--size 64 --output {out}/x.json", USAGE, "--size", {}),
    ("--size 0x32 --output {out}/x.json", USAGE, "--size", {}),
    ("--size 64x32x2 --output {out}/x.json", USAGE, "--size", {}),
    ("--frames nan --output {out}/x.json", USAGE, "--frames", {}),
    ("--turn fast --output {out}/x.json", USAGE, "--turn", {}),
    ("--turn nan --output {out}/x.json", USAGE, "--turn", {}),
    ("--turn 180.5 --output {out}/x.json", USAGE, "--turn", {}),
    ("--turn --output {out}/x.json", USAGE, "--turn", {}),
    ("--turn 1 --table1 --output {out}/x.json", USAGE, "--table1", {}),
    ("--turn 1 --methods auto,floor --output {out}/x.json", USAGE, "floor", {}),
    ("--mode fly --output {out}/x.json", USAGE, "fly", {}),
    ("--mode --output {out}/x.json", USAGE, "--mode", {}),
    ("--mode film --turn 1 --output {out}/x.json", USAGE, "--mode film", {}),
    ("--mode still --turn 1 --output {out}/x.json", USAGE, "--mode still", {}),
    ("--mode turn --turn 0 --output {out}/x.json", USAGE, "--turn 0", {}),
    ("--mode first --table1 --output {out}/x.json", USAGE, "--table1", {}),
    ("--mode film --methods floor --output {out}/x.json", USAGE, "floor", {}),
    ("--samples 65 --output {out}/x.json", USAGE, "--samples", {}),
    ("--samples 4.5 --output {out}/x.json", USAGE, "--samples", {}),
    ("--methods cubemap-ss --output {out}/x.json", USAGE, "--samples", {}),
    ("--methods cubemap-ss --samples 1 --output {out}/x.json", USAGE, "--samples", {}),
    ("--tolerance 0 --output {out}/x.json", USAGE, "--tolerance", {}),
    ("--tolerance nan --output {out}/x.json", USAGE, "--tolerance", {}),
    ("--tolerance 0.5 --table1 --output {out}/x.json", USAGE, "--table1", {}),
    ("--quick --table1 --output {out}/x.json", USAGE, "--table1", {}),
    ("--projection bent --output {out}/x.json", USAGE, "bent", {}),
    ("--projection direction-map --output {out}/x.json", USAGE, "direction-map", {}),
    ("--as-direction-map --table1 --output {out}/x.json", USAGE, "--table1", {}),
    ("--projection hammer --table1 --output {out}/x.json", USAGE, "--table1", {}),
    ("--scenes room --size 100000x50 --output {out}/x.json", FAILED, "limit", {}),
    ("--scenes office --data {out} --output {out}/x.json", FAILED, "office", {}),
]
STRESS = [
    ("--projections bent --output {out}/x.json", USAGE, "bent", {}),
    ("--cases odd --output {out}/x.json", USAGE, "odd", {}),
    ("--technique cubemap --output {out}/x.json", USAGE, "cubemap", {}),
    ("--primitives 0 --output {out}/x.json", USAGE, "--primitives", {}),
    ("--primitives -5 --output {out}/x.json", USAGE, "--primitives", {}),
    ("--primitives 1e6 --output {out}/x.json", USAGE, "--primitives", {}),
    ("--seed many --output {out}/x.json", USAGE, "--seed", {}),
    ("--tolerance 0 --output {out}/x.json", USAGE, "--tolerance", {}),
]


def complaints(program, arguments, code, says, changes):
    """What is wrong with how the program fails."""
    environment = dict(os.environ)
    for name, value in changes.items():
        environment.pop(name, None)
        if value is not None:
            environment[name] = value
    with tempfile.TemporaryDirectory() as folder:
        words = arguments.replace("{out}", folder).split()
        run = subprocess.run(
            [program] + words,
            env=environment,
            timeout=TIMEOUT,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
        lines = run.stderr.splitlines()
        if run.returncode != code:
            yield "exit code %d, not %d" % (run.returncode, code)
        if len(lines) != 1:
            yield "%d lines on standard error, not one: %s" % (len(lines), run.stderr)
        for line in lines:
            if not line.startswith(os.path.basename(program) + ": ") or says not in line:
                yield "the line does not say '%s': %s" % (says, line)
        if os.listdir(folder):
            yield "it left files: %s" % os.listdir(folder)


def main():
    bench, stress = sys.argv[1:3]
    wrong = 0
    rows = [(bench, row) for row in BOTH + BENCH] + [(stress, row) for row in BOTH + STRESS]
    for program, (arguments, code, says, changes) in rows:
        for text in complaints(program, arguments, code, says, changes):
            print("%s %s: %s" % (os.path.basename(program), arguments, text))
            wrong += 1
    print("command lines: %d rows, %d wrong" % (len(rows), wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
