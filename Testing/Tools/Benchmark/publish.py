# SPDX-License-Identifier: BSD-3-Clause
"""Copies results of widefov-bench to a page of benchmarks, without the places of single pixels.

    /usr/bin/python3 -B publish.py FOLDER FILE.json...
"""

import json
import pathlib
import sys


def publish(source, folder):
    document = json.loads(source.read_text(encoding="utf-8"))
    for record in document["records"]:
        if record.get("error"):
            record["error"].pop("places", None)
    text = json.dumps(document, indent=2, ensure_ascii=False)
    (folder / source.name).write_text(text + "\n", encoding="utf-8")


def main():
    if len(sys.argv) < 3:
        sys.exit("publish.py: FOLDER FILE.json... are needed")
    for name in sys.argv[2:]:
        publish(pathlib.Path(name), pathlib.Path(sys.argv[1]))


main()
