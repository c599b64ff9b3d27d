#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A seeded part of widefov-stress as a test.

    run_stress.py WIDEFOV-STRESS WIDEFOV-RENDER

Draws one picture of some cases in every projection, so that every case and every
projection takes part; with WIDEFOV_STRESS_PRIMITIVES=N in the environment everything, N
primitives of each projection. What is not zero and not listed in NOT_YET fails. From the tolerance
CHORDS on, auto projects triangles. Of the pixels that the 48 points do not explain those pass then
whose cell is within the tolerance: seen there after all, for the points step over what is thin, or
hidden, of which there may be as many as the share HIDDEN. All others fail.
"""

import json
import os
import subprocess
import sys
import tempfile

SEED = 1
PICTURES = 36  # of the small run: about a second each

COUNTERS = ["nan", "gl_errors", "holes", "double_hits", "unexplained", "crashes"]
EXACT = 0.02  # pixels
CHORDS = 0.05  # pixels
HIDDEN = 2e-4  # of the pixels: HiddenFaces.h
# of the pixels, where most triangles are seen edge-on: their neighbours hide them or not
HIDDEN_EDGE_ON = {"eye": 2e-2, "denormals": 5e-3}
# of the pixels: two chords beside a rim, each within the tolerance, may cross, and the map of closed
# meshes folds there. Nothing may be missing.
FOLDED = 5e-3
PARTS = [(["exact", "auto"], EXACT), (["auto"], 0.25)]

# What is not zero yet: (technique, counter), or (technique, counter, case). Nothing is.
NOT_YET = set()

# Pictures that were wrong once: projection, case, batch, and the seed where it is another.
ONCE_WRONG = [
    ("mercator", "closed-thin", 77),  # columns narrower than a rasterizer tells apart
    ("azimuthal-equidistant", "eye", 6),  # triangles that pass the eye within 1e-6 near radii
    ("azimuthal-equidistant", "eye", 20),
    ("equi-angular-cubemap", "eye", 30),
    ("equi-angular-cubemap", "eye", 40),
    ("sinusoidal", "closed", 24),  # edges that reach far beyond the ends of their chords
    ("winkel-tripel", "closed", 99),
    ("azimuthal-equidistant", "eye", 17),  # thinner than a ray in float32 is exact
    ("eckert-iv", "slivers", 22),
    ("equi-angular-cubemap", "slivers", 6),
    ("panini", "slivers", 6),
    ("winkel-tripel", "eye", 5),
    ("equi-angular-cubemap", "slivers", 37),  # tilted: by a matrix in float32
    ("equirectangular", "eye", 20),  # a triangle that passes the eye, beyond the near sphere or not
    ("perspective", "signed-zeros", 1, 5),  # places that are no numbers, of corners in the eye
]


def output_of(command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def stress(program, arguments, part=PARTS[0], seed=SEED):
    """Runs the program and returns its report."""
    techniques, tolerance = part
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "stress.json")
        command = [program, "--seed", str(seed), "--technique", ",".join(techniques)]
        command += ["--tolerance", str(tolerance)]
        subprocess.run(command + arguments + ["--output", path], check=True)
        with open(path, encoding="utf-8") as stream:
            return json.load(stream)


def case_names(program):
    """From the program's own help."""
    words = output_of([program, "--help"]).split("kinds of primitives:")[1].split("--")[0]
    return [word.strip() for word in words.replace("\n", " ").split(",") if word.strip()]


def small_run(program, projections, cases, part):
    """Every projection and every case, in pairs that go round both lists."""
    chosen = {}
    for i in range(max(PICTURES, len(projections), len(cases))):
        chosen.setdefault(projections[i % len(projections)], set()).add(cases[i % len(cases)])
    for projection, names in chosen.items():
        where = ["--projections", projection, "--cases", ",".join(sorted(names)), "--batch", "0"]
        yield stress(program, where, part)


def once_wrong(program):
    for projection, case, batch, *seed in ONCE_WRONG:
        where = ["--projections", projection, "--cases", case, "--batch", str(batch)]
        yield stress(program, where, PARTS[0], *seed)


def allowed(technique, counter, case):
    return (technique, counter) in NOT_YET or (technique, counter, case) in NOT_YET


def broken_promises(case, counts):
    """What speaks against pixels of auto that the points do not explain."""
    astray = counts["unexplained"] - counts["near"] - counts["hidden"]
    if astray > 0:
        yield "%d pixels show what is nowhere near" % astray
    if counts["hidden"] > HIDDEN_EDGE_ON.get(case, HIDDEN) * counts["pixels"]:
        yield "%d of %d pixels show what is hidden" % (counts["hidden"], counts["pixels"])


def breaches(report):
    for case, techniques in report["by_case"].items():
        for technique, counts in techniques.items():
            projects = technique == "auto" and report["tolerance"] >= CHORDS
            for counter in COUNTERS:
                if projects and counter == "unexplained":
                    for text in broken_promises(case, counts):
                        yield "%s, %s: %s" % (technique, case, text)
                elif projects and counter == "double_hits" and counts[counter] <= FOLDED * counts["pixels"]:
                    continue
                elif counts[counter] > 0 and not allowed(technique, counter, case):
                    yield "%s, %s: %s %d" % (technique, case, counter, counts[counter])


def print_failures(report):
    for failure in report["failures"]:
        print(failure["reproduce"])
        for line in failure.get("lines", [failure.get("crash")]):
            print("   ", line)


def crash_complaints(program):
    """One of three batches crashes: it is counted, and the others are drawn."""
    cases = ["seams", "poles", "eye"]
    where = ["--projections", "hammer", "--cases", ",".join(cases), "--batch", "0"]
    report = stress(program, where + ["--abort-at", "1"])
    if report["crashes"] != 1 or report["by_case"]["poles"]["exact"]["crashes"] != 1:
        yield "a crash was counted as %d" % report["crashes"]
    for case in ("seams", "eye"):
        if report["by_case"][case]["exact"]["batches"] != 1:
            yield "after a crash, %s was not drawn" % case


def main():
    program, render = sys.argv[1:3]
    primitives = os.environ.get("WIDEFOV_STRESS_PRIMITIVES")
    if primitives:
        reports = [stress(program, ["--primitives", primitives], part) for part in PARTS]
    else:
        # a direction map is a file's; CompareSampled has some
        projections = output_of([render, "--list-projections"]).split()
        projections.remove("direction-map")
        cases = case_names(program)
        reports = [r for part in PARTS for r in small_run(program, projections, cases, part)]
        reports += once_wrong(program)
    found = list(crash_complaints(program))
    for report in reports:
        bad = list(breaches(report))
        if bad:
            print_failures(report)
        where = "%s at %g" % (", ".join(report["projections"]), report["tolerance"])
        found += ["%s: %s" % (where, text) for text in bad]
    pictures = sum(t["batches"] for r in reports for c in r["by_case"].values() for t in c.values())
    print("stress: %d pictures, %d breaches" % (pictures, len(found)))
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
