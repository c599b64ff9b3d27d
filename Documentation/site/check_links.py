#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that every link and picture of a site is there, and the place in its page.

    check_links.py SITE

Links to other sites are left alone: a build asks nothing of the network.
"""

import html.parser
import os
import sys
import urllib.parse

KEYS = {"a": ("href",), "img": ("src",), "link": ("href",), "script": ("src",)}


class Page(html.parser.HTMLParser):
    """The links of a page, and the names that others may link to."""

    def __init__(self, path):
        super().__init__(convert_charrefs=True)
        self.links = set()
        self.names = set()
        with open(path, encoding="utf-8") as stream:
            self.feed(stream.read())

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.names.update(values[key] for key in ("id", "name") if values.get(key))
        self.links.update(values[key] for key in KEYS.get(tag, ()) if values.get(key))


def complaints(path, page, pages):
    """What is wrong with the links of one page."""
    for link in sorted(page.links):
        parts = urllib.parse.urlsplit(link)
        if parts.scheme in ("http", "https", "mailto", "data", "javascript") or parts.netloc:
            continue
        target = path
        if parts.path:
            target = os.path.join(os.path.dirname(path), urllib.parse.unquote(parts.path))
        target = os.path.normpath(target)
        if not os.path.isfile(target):
            yield "no file for the link " + link
        elif parts.fragment and target in pages:
            if urllib.parse.unquote(parts.fragment) not in pages[target].names:
                yield "no such place: " + link


def main():
    if len(sys.argv) != 2 or not os.path.isfile(os.path.join(sys.argv[1], "index.html")):
        sys.exit("check_links.py: name the folder of a site, which has an index.html")
    site = os.path.normpath(sys.argv[1])
    files = [os.path.join(folder, name) for folder, _, names in os.walk(site) for name in names]
    pages = {path: Page(path) for path in files if path.endswith(".html")}
    wrong = 0
    for path in sorted(pages):
        for text in complaints(path, pages[path], pages):
            print("%s: %s" % (os.path.relpath(path, site), text))
            wrong += 1
    links = sum(len(page.links) for page in pages.values())
    print("links: %d of %d pages, %d complaints" % (links, len(pages), wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
