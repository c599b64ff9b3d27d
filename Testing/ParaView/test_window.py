# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window with the plugin in it: the toolbar, undo, presets, photographed.

    test_window.py --prefix PREFIX --plugin WideFoV.so --driver DRIVER.so --output FOLDER
"""

import argparse
import json
import os
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))

# What the driver does, as the settings have to follow one another.
EXPECTED = [
    {"Projection": "equirectangular", "StereoRender": 0},
    {"Projection": "hammer"},
    {"Projection": "equirectangular", "Eye": [1, 1, 1], "Ahead": [0.1, 0.04, -0.99]},
    {"Eye": [0, 0, 0], "Ahead": [0.1, 0.04, -0.99]},
    {"Eye": [0, 0, 0], "Ahead": [1, 0, 0], "Up": [0, 0, 1]},
    {"Eye": [0, 0, 0], "Ahead": [0.1, 0.04, -0.99], "Up": [0, 1, 0], "PreviewMode": [0, 0]},
    {"PreviewMode": [4096, 2048]},
    {"PreviewMode": [0, 0]},
    {"Projection": "azimuthal-equidistant", "HorizontalFieldOfView": 180, "Tilt": 90,
     "StereoRender": 1, "StereoModel": "omnidirectional"},
]

PHOTOGRAPHS = ["panorama", "hammer", "undone", "inside", "along", "two-to-one", "presets", "dome",
               "stereo", "dark"]


def drive(options):
    """ParaView's exit code and what it said."""
    environment = dict(
        os.environ, LD_PRELOAD=options.driver, WIDEFOV_PHOTOGRAPHS=options.output,
        WIDEFOV_PLUGIN=options.plugin, LD_LIBRARY_PATH=os.path.join(
            options.prefix, "lib", os.uname().machine + "-linux-gnu"),
        PYTHONPATH=os.path.join(options.prefix, "lib", "python3", "dist-packages"))
    done = subprocess.run(
        [os.path.join(options.prefix, "bin", "paraview"), "--dr",
         "--script=" + os.path.join(HERE, "Window", "scene_in_window.py")],
        env=environment, capture_output=True, text=True, timeout=800, check=False)
    return done.returncode, done.stdout + done.stderr


def check_settings(path):
    """Each expected state comes after the one before it."""
    with open(path) as file:
        states = [json.loads(line) for line in file]
    at = 0
    for wanted in EXPECTED:
        while at < len(states) and not all(states[at][k] == v for k, v in wanted.items()):
            at += 1
        if at == len(states):
            sys.exit("test_window.py: the settings never were %s: %s" % (wanted, states))
    print(len(states), "changes, the last:", states[-1])


def main():
    parser = argparse.ArgumentParser()
    for name in ("prefix", "plugin", "driver", "output"):
        parser.add_argument("--" + name, required=True)
    options = parser.parse_args()
    shutil.rmtree(options.output, ignore_errors=True)
    os.makedirs(options.output)
    code, text = drive(options)
    if code != 0 or "window driver: done" not in text:
        sys.exit("test_window.py: ParaView ended with %d:\n%s" % (code, text))
    check_settings(os.path.join(options.output, "settings.log"))
    contents = []
    for name in PHOTOGRAPHS:
        with open(os.path.join(options.output, name + ".png"), "rb") as file:
            contents.append(file.read())
    for first, second in zip(contents, contents[1:]):
        if first == second:
            sys.exit("test_window.py: two photographs in a row are the same")


if __name__ == "__main__":
    main()
