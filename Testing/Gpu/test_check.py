#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The check on a graphics card, in its small sizes: every part leaves what it should.

    test_check.py CHECK.SH FOLDER

FOLDER holds the programs: that of a bundle, or the bin/ of a build. Each picture has to be a whole
PNG of its size that is not all one colour, and each JSON has to have what its program writes.
Before that, a check whose parts fail has to say so of each: where programs fail, where a filter
fits no test, and where the time is over.
"""

import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib

PICTURES = {"gl": (64, 32)}
PICTURES.update(dict.fromkeys(["cornell", "room", "atrium", "globe", "balls", "sphere"], (256, 128)))
TESTS = [
    "CompareExact", "Watertight", "CompareLines", "ComparePoints", "CompareQuadrics", "CompareStereo",
]
BENCHES = {
    "256x128-0": ([256, 128], {"auto", "vertex", "perspective", "cubemap"}),
    "256x128-4": ([256, 128], {"auto", "vertex", "perspective", "cubemap"}),
    "512x256-0": ([512, 256], {"auto", "vertex", "perspective", "cubemap"}),
    "512x256-4": ([512, 256], {"auto", "vertex", "perspective", "cubemap"}),
    "stereo": ([256, 128], {"auto", "stereo-omnidirectional", "stereo-offaxis"}),
}
SCENES = {"cornell", "room"}
PARTS = len(PICTURES) + len(TESTS) + len(BENCHES) + 1  # and stress


def read_png(path):
    """Width, height and the rows as they are in the file, filtered."""
    with open(path, "rb") as stream:
        data = stream.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path + " is no PNG"
    place, packed, kind, size = 8, b"", b"", (0, 0)
    while kind != b"IEND":
        length, kind = struct.unpack(">I4s", data[place : place + 8])
        body = data[place + 8 : place + 8 + length]
        check = struct.unpack(">I", data[place + 8 + length : place + 12 + length])[0]
        assert check == zlib.crc32(kind + body), path + " has a wrong check sum"
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        packed += body if kind == b"IDAT" else b""
        place += 12 + length
    return size, zlib.decompress(packed)


def read_json(folder, *names):
    with open(os.path.join(folder, *names), encoding="utf-8") as stream:
        return json.load(stream)


def check_pictures(folder):
    for name, size in PICTURES.items():
        found, rows = read_png(os.path.join(folder, "pictures", name + ".png"))
        assert found == size, f"{name}.png is {found} pixels, not {size}"
        # rows, as differences from their neighbours: of one colour they are two kinds at most
        stride = len(rows) // size[1]
        kinds = {rows[i * stride : (i + 1) * stride] for i in range(size[1])}
        assert len(kinds) > 8, name + ".png shows nothing"
        stats = read_json(folder, "gl.json") if name == "gl" else read_json(
            folder, "pictures", name + ".json")
        assert stats["size"] == list(size) and stats["ms"]["median"] > 0, stats
        assert all(stats["gl"][key] for key in ("vendor", "renderer", "version")), stats["gl"]


def check_scenes(script):
    """What is timed is to be seen, too, in both sizes."""
    with open(script, encoding="utf-8") as stream:
        text = stream.read()
    drawn = [names.split() for names in re.findall(r"^ *scenes=\(([a-z -]+)\)", text, re.M)]
    timed = [names.split(",") for names in re.findall(r"^ *bench_scenes=([a-z,-]+)", text, re.M)]
    assert len(drawn) == len(timed) == 2, (drawn, timed)
    for pictures, scenes in zip(drawn, timed):
        assert not set(scenes) - set(pictures), f"no picture of {set(scenes) - set(pictures)}"


def check_tests(folder):
    for name in TESTS:
        results = read_json(folder, "tests", name + "-equirectangular.json")
        assert results["failures"] == 0 and results["errors"] == 0, results
        cases = [case for suite in results["testsuites"] for case in suite["testsuite"]]
        # (one that is left out counts as run there)
        ran = [case for case in cases if case["result"] == "COMPLETED"]
        assert ran, name + ": no test was run"


def check_stress(folder):
    report = read_json(folder, "stress.json")
    assert report["primitives"] >= 100 and report["by_case"], report
    assert report["crashes"] == 0 and report["nan"] == 0, report


def check_benches(folder):
    for name, (size, methods) in BENCHES.items():
        result = read_json(folder, "bench-" + name + ".json")
        records = result["records"]
        assert {record["scene"] for record in records} == SCENES, name
        assert {record["method"] for record in records} == methods, name
        for record in records:
            assert record["size"] == size and record["ms"]["median"] > 0, record


def check_summary(folder):
    with open(os.path.join(folder, "summary.txt"), encoding="utf-8") as stream:
        lines = stream.read().splitlines()
    wrong = [line for line in lines if "exit code 0," not in line]
    assert not wrong, wrong
    assert len(lines) == PARTS, f"{len(lines)} parts, not {PARTS}: {lines}"


def run(script, programs, results, **settings):
    return subprocess.run(
        ["bash", script, "--small", programs, results], env=dict(os.environ, **settings),
        capture_output=True, text=True, check=False)


def run_replaced(script, programs, scratch, text, **settings):
    """The lines of the summary where each program is a shell's text; how it ended is checked."""
    folder = tempfile.mkdtemp(dir=scratch)
    for name in os.listdir(programs):
        if name.startswith("widefov-"):
            path = os.path.join(folder, name)
            with open(path, "w", encoding="utf-8") as stream:
                stream.write("#!/bin/sh\n" + text + "\n")
            os.chmod(path, 0o755)
    results = os.path.join(folder, "results")
    ended = run(script, folder, results, **settings)
    assert ended.returncode == 1, ended
    with open(os.path.join(results, "summary.txt"), encoding="utf-8") as stream:
        lines = dict(line.split(": ", 1) for line in stream.read().splitlines())
    assert len(lines) == PARTS, lines
    return lines


def check_failures(script, programs, scratch):
    failing = run_replaced(script, programs, scratch, "exit 3")
    assert all(line.startswith("exit code 3,") for line in failing.values()), failing
    # a filter that fits no test
    empty = run_replaced(
        script, programs, scratch, "echo '[==========] Running 0 tests from 0 test suites.'")
    assert all(line.startswith("exit code 1,") for line in empty.values()), empty
    # the first step takes all the time there is
    slow = run_replaced(script, programs, scratch, "sleep 1000", WIDEFOV_GPU_SECONDS="10")
    assert slow.pop("gl").startswith("exit code 124 (cut)"), slow
    assert all(line.startswith("exit code 125 (left out") for line in slow.values()), slow


def main():
    script, programs = sys.argv[1:3]
    check_scenes(script)
    with tempfile.TemporaryDirectory() as scratch:
        check_failures(script, programs, scratch)
        results = os.path.join(scratch, "results")
        ended = run(script, programs, results)
        print(ended.stdout)
        check_summary(results)
        for check in (check_pictures, check_tests, check_stress, check_benches):
            check(results)
        assert ended.returncode == 0, ended


if __name__ == "__main__":
    main()
