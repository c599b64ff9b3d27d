# SPDX-License-Identifier: BSD-3-Clause
"""A player of panoramas, in Chromium without a window: what test_player.py drives."""

import base64
import functools
import http.server
import json
import os
import queue
import shutil
import signal
import subprocess
import tempfile
import threading

HERE = os.path.dirname(os.path.abspath(__file__))
THREE = "/usr/share/javascript/three/three.min.js"  # Debian's package libjs-three
PAGE = {"/player.html": "player.html", "/player.js": "player.js"}
LONGEST = 150  # seconds for all views, on a busy machine


def missing():
    """The package that this machine lacks for the player, or None."""
    if not shutil.which("chromium"):
        return "chromium"
    return None if os.path.isfile(THREE) else "libjs-three"


class Handler(http.server.SimpleHTTPRequestHandler):
    """The page, three.js, the files of a folder; what the page posts goes into a queue."""

    def __init__(self, *arguments, views, posted, **more):
        self.views = views
        self.posted = posted
        super().__init__(*arguments, **more)

    def translate_path(self, path):
        if path == "/three.js":
            return THREE
        return os.path.join(HERE, PAGE[path]) if path in PAGE else super().translate_path(path)

    def do_GET(self):
        if self.path != "/views.json":
            super().do_GET()
            return
        body = json.dumps(self.views).encode()
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def do_POST(self):
        body = self.rfile.read(int(self.headers["Content-Length"]))
        self.send_response(204)
        self.end_headers()
        self.posted.put((self.path[1:], body))

    def log_message(self, *_):
        pass


def browse(address, profile):
    words = ["chromium", "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--autoplay-policy=no-user-gesture-required", "--mute-audio",
             "--no-first-run", "--disable-background-networking", "--disable-component-update",
             "--disable-dev-shm-usage", "--user-data-dir=" + profile, address]
    # its helpers share its group, which ends with it
    return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL, start_new_session=True)


def collect(posted, folder):
    """Writes the pictures as they come; what the page says went wrong, or None."""
    while True:
        try:
            name, body = posted.get(timeout=LONGEST)
        except queue.Empty:
            return "the page says nothing"
        if name in ("done", "failed"):
            return body.decode() or None
        with open(os.path.join(folder, name + ".png"), "wb") as stream:
            stream.write(base64.b64decode(body.partition(b",")[2]))


def play(folder, size, views):
    """Name -> a view of a file of the folder, in a square picture; NAME.png appears in the folder.
    What went wrong, or None."""
    posted = queue.Queue()
    handler = functools.partial(
        Handler, directory=folder, posted=posted, views={"size": size, "views": views})
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server, \
            tempfile.TemporaryDirectory(prefix="player-", ignore_cleanup_errors=True) as profile:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        browser = browse("http://127.0.0.1:%d/player.html" % server.server_port, profile)
        try:
            return collect(posted, folder)
        finally:
            os.killpg(browser.pid, signal.SIGTERM)
            browser.wait()
            server.shutdown()
