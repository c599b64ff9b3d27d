#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of widefov-render --web in Chromium: directions, keys, touch, tiles, films, from a web server and
opened as files.

    test_browser.py WIDEFOV-RENDER [FOLDER]      FOLDER: keeps the pictures
"""

import functools
import http.server
import math
import os
import shutil
import subprocess
import sys
import threading

import numpy
from matplotlib.image import imread

import browser
from pages import BALLS, RENDER, SKIPPED, PageTest, main, unit

KEPT = sys.argv[2] if len(sys.argv) > 2 else None
SIDE = 600  # pixels of the window
BELOW = 140  # pixels from the lower border that the bar of colours and the buttons may cover
MIDDLE = (SIDE / 2, SIDE / 2)
WRONG = 0.5  # degrees: what is asked of the direction in the middle of the view
NEAR = 6  # degrees round a ball, whose radius is 2.9: no other ball is so near
BUILD = os.path.dirname(os.path.dirname(RENDER))
EYE = 0.1  # from the middle between the eyes, at a distance of 1 of the balls
PIXELS = 3  # half a degree in a headset
HEADSET = """
    window.headset = new emulator.XRDevice(emulator.metaQuest3);
    headset.installRuntime({ forceInstall: true });
    headset.stereoEnabled = true;"""
FETCH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Utilities", "fetch-viewer.sh")
READY = "window.widefov?.viewer?.state?.ready === true"


class Server:
    """A folder by HTTP, on a port that is free."""

    def __init__(self, folder):
        handler = functools.partial(Handler, directory=folder)
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        self.address = "http://127.0.0.1:%d/" % self.server.server_port
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def close(self):
        self.server.shutdown()
        self.server.server_close()


class Handler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def angle(one, other):
    """Degrees between two unit vectors."""
    return math.degrees(math.acos(max(-1, min(1, sum(a * b for a, b in zip(one, other))))))


def direction_of(view, x, y):
    """Of a pixel of a view: its yaw and pitch, radians, and its angle upwards, degrees."""
    scale = math.tan(math.radians(view["vFov"]) / 2) / (SIDE / 2)
    right, up = (x - SIDE / 2) * scale, (SIDE / 2 - y) * scale
    sin, cos = math.sin(view["pitch"]), math.cos(view["pitch"])
    ahead, up = cos - up * sin, sin + up * cos
    sin, cos = math.sin(view["yaw"]), math.cos(view["yaw"])
    vector = (right * cos + ahead * sin, up, right * sin - ahead * cos)
    return tuple(each / math.hypot(*vector) for each in vector)


class Pages(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.server = Server(cls.folder)
        cls.addClassCleanup(cls.server.close)
        cls.browser = browser.Browser(SIDE, SIDE)
        cls.addClassCleanup(cls.browser.close)

    def open(self, page, served=True):
        self.browser.errors.clear()
        self.browser.loaded.clear()
        self.browser.open((self.server.address if served else "file://%s/" % self.folder) + page + "/index.html")
        self.browser.wait_for(READY)

    def view(self, frame="window."):
        viewer = frame + "widefov.viewer"
        return self.browser.ask("({ ...%s.getPosition(), vFov: %s.state.vFov })" % (viewer, viewer))

    def look(self, name):
        """What the browser shows once the view stands still and has been drawn."""
        self.browser.ask("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        self.browser.screenshot(self.path("shot.png"))
        if KEPT:
            os.makedirs(KEPT, exist_ok=True)
            shutil.copy(self.path("shot.png"), os.path.join(KEPT, name + ".png"))
        return imread(self.path("shot.png"))[:, :, :3]

    def assert_ball(self, ball, name, frame="window."):
        """The ball is where the view says that it is."""
        picture = self.look(name)
        view = self.view(frame)
        picture[-BELOW:] = 0  # the bar of colours
        yellow = (picture[:, :, 0] > 0.3) & (picture[:, :, 0] > picture[:, :, 2] + 0.2)
        seen = [direction_of(view, x + 0.5, y + 0.5) for y, x in zip(*numpy.nonzero(yellow))]
        near = [each for each in seen if angle(each, unit(*ball)) < NEAR]
        self.assertGreater(len(near), 100, "%s: no ball is seen in the view %s" % (name, view))
        middle = numpy.mean(near, axis=0)
        off = angle(middle / numpy.linalg.norm(middle), unit(*ball))
        self.assertLess(off, WRONG, "%s: in the view %s" % (name, view))

    def assert_clean(self):
        self.assertEqual(self.browser.errors, [])
        for address in self.browser.loaded:
            self.assertTrue(address.startswith((self.server.address, "file://" + self.folder, "blob:", "data:")), address)

    def check_turning(self, name):
        """By mouse, keys and touch."""
        self.assert_ball(BALLS[0], name)
        self.browser.drag(MIDDLE, (MIDDLE[0] - 200, MIDDLE[1] + 40))
        dragged = self.view()
        self.assertGreater(math.degrees(dragged["yaw"]), 15)
        self.assertGreater(math.degrees(dragged["pitch"]), 2)
        self.assert_ball(BALLS[0], name + "-dragged")
        self.browser.drag(MIDDLE, (MIDDLE[0] - 200, MIDDLE[1]))
        self.assert_ball(BALLS[1], name + "-dragged-on")
        self.browser.key("ArrowRight", 0.2)
        before = self.view()
        self.assertGreater(before["yaw"], dragged["yaw"])
        self.browser.touch("touchStart", (300, 300))
        for x in range(300, 180, -20):
            self.browser.touch("touchMove", (x, 300))
        self.browser.touch("touchEnd")
        self.assertGreater(self.view()["yaw"], before["yaw"] + 0.1)

    def check_flat(self, page):
        """Without WebGL the picture is flat, below a sentence."""
        hide = self.browser.call("Page.addScriptToEvaluateOnNewDocument",
                                 source="HTMLCanvasElement.prototype.getContext = () => null;")
        self.browser.open(self.server.address + page + "/index.html")
        self.browser.wait_for("document.querySelector('.widefov-flat')?.naturalWidth === 1024")
        self.browser.call("Page.removeScriptToEvaluateOnNewDocument", **hide)
        self.assertIn("no WebGL", self.browser.ask("document.querySelector('.widefov-sentence').textContent"))
        self.look("flat")
        self.assert_clean()

    def test_picture(self):
        self.draw("still", "--size", "1024x512", "--title", "Balls <b> & \"heat\"")
        for served in (True, False):
            with self.subTest(served=served):
                self.open("still", served)
                self.assertEqual(self.browser.ask("document.querySelector('h1').textContent"), "Balls <b> & \"heat\"")
                self.browser.wait_for("document.querySelector('.widefov-bar')?.naturalWidth > 100")
                self.check_turning("served" if served else "file")
                self.assert_clean()
        self.check_flat("still")
        size = sum(os.path.getsize(self.path("still/" + name)) for name in os.listdir(self.path("still"))
                   if not name.startswith(("panorama", "bar")))
        self.assertLess(size, 2e6)

    def test_part_and_tilt(self):
        """A part of the sphere whose middle is above the horizon."""
        self.draw("part", "--size", "1024x512", "--hfov", "200", "--vfov", "100", "--tilt", "20")
        self.open("part")
        self.browser.ask("widefov.viewer.rotate({ yaw: 0.7, pitch: 0.2 })")
        self.assert_ball(BALLS[1], "part")
        self.assert_clean()

    def test_headset(self):
        """In an emulated headset each eye sees its own picture: the left one has the ball ahead on its right."""
        self.draw("eyes", "--size", "1024x512", "--stereo", "omnidirectional", "--ipd", str(2 * EYE))
        with open(os.path.join(BUILD, "share/widefov/web/emulator.js"), encoding="utf-8") as stream:
            emulator = stream.read() + HEADSET
        added = self.browser.call("Page.addScriptToEvaluateOnNewDocument", source=emulator)
        self.open("eyes")
        self.browser.call("Page.removeScriptToEvaluateOnNewDocument", **added)
        self.browser.wait_for("document.querySelector('[title=Headset]') !== null")
        self.browser.call("Runtime.evaluate", expression="document.querySelector('[title=Headset]').click()",
                          userGesture=True)
        self.browser.wait_for("widefov.viewer.renderer.renderer.xr.isPresenting")
        picture = self.look("headset")
        wanted = math.tan(math.asin(EYE)) * SIDE / 2  # pixels: the headset sees 90 degrees upwards
        for half, sign in ((picture[:, :SIDE // 2], 1), (picture[:, SIDE // 2:], -1)):
            middle = half[SIDE // 2 - 60:SIDE // 2 + 60, SIDE // 4 - 80:SIDE // 4 + 80]
            columns = numpy.nonzero(middle[:, :, 0] > middle[:, :, 2] + 0.2)[1]
            self.assertGreater(len(columns), 100, "no ball is seen")
            self.assertLess(abs(columns.mean() + 0.5 - 80 - sign * wanted), PIXELS)
        self.browser.ask("headset.activeSession.end()")
        self.browser.wait_for("!widefov.viewer.renderer.renderer.xr.isPresenting")
        self.browser.drag(MIDDLE, (MIDDLE[0] - 200, MIDDLE[1]))
        self.assertGreater(self.view()["yaw"], 0.2)
        self.assert_clean()

    def test_tiles(self):
        self.draw("large", "--size", "8256x4128")
        for served in (True, False):
            with self.subTest(served=served):
                self.open("large", served)
                self.browser.ask("widefov.viewer.zoom(100)")
                self.browser.ask("widefov.viewer.rotate({ yaw: 0.7, pitch: 0.2 })")
                self.browser.wait_for("Object.keys(widefov.viewer.adapter.queue.tasks).length === 0")
                self.assertTrue([name for name in self.browser.loaded if "tiles/0-" in name], self.browser.loaded)
                self.assert_ball(BALLS[1], "tiles" if served else "tiles-file")
                self.assert_clean()

    def test_notebook(self):
        """widefov.show, as the cell of a page of a notebook; and what it refuses."""
        import vtk
        import widefov

        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(self.path("balls.vtp"))
        reader.Update()
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputData(reader.GetOutput())
        mapper.ScalarVisibilityOff()
        balls = vtk.vtkActor()
        balls.SetMapper(mapper)
        balls.GetProperty().SetColor(1, 1, 0)
        panorama = widefov.show(balls, (1024, 512), eye=(0, 0, 0), tilt=20, background=(0, 0, 0.5), height=SIDE,
                                title="A </script>")
        with open(self.path("notebook.html"), "w", encoding="utf-8") as stream:
            stream.write("<!DOCTYPE html><link rel=icon href='data:,'><style>body { margin: 0; overflow: hidden }</style>" + panorama._repr_html_())
        self.browser.errors.clear()
        self.browser.loaded.clear()
        self.browser.open(self.server.address + "notebook.html")
        frame = "document.querySelector('iframe')?.contentWindow?."
        self.browser.wait_for(frame + "widefov?.viewer?.state?.ready === true")
        self.assertEqual(self.browser.ask(frame + "document.querySelector('h1').textContent"), "A </script>")
        self.browser.ask(frame + "widefov.viewer.rotate({ yaw: 0.7, pitch: 0.2 })")
        self.assert_ball(BALLS[1], "notebook", frame)
        self.assert_clean()
        with self.assertRaisesRegex(ValueError, "equirectangular"):
            widefov.show(balls, projection="hammer")

    def test_film(self):
        """A turn to the right by 80 degrees in four frames."""
        self.draw("film", "--size", "1024x512", "--film", "turn", "--sweep", "80", "--seconds", "1", "--fps", "4",
                  "--ease", "none")
        for served in (True, False):
            with self.subTest(served=served):
                self.open("film", served)
                self.browser.wait_for("widefov.viewer.adapter.video.currentTime > 0.3")
                plugin = "widefov.viewer.getPlugin('video')"
                self.browser.ask("%s.pause()" % plugin)
                self.browser.ask("""new Promise((done) => {
                    widefov.viewer.adapter.video.requestVideoFrameCallback(done);
                    %s.setTime(0.3); })""" % plugin)
                self.assertEqual(self.browser.ask("document.querySelectorAll('.psv-video-progressbar').length"), 1)
                self.browser.ask("widefov.viewer.rotate({ yaw: 0, pitch: 0.1 })")
                azimuth = BALLS[1][0] - 80 / 3
                self.assert_ball((azimuth, BALLS[1][1]), "film" if served else "film-file")
                self.assert_clean()
        with open(self.path("film/film.mp4"), "wb") as stream:
            stream.write(b"no film")
        self.browser.open(self.server.address + "film/index.html")
        self.browser.wait_for("document.querySelector('.widefov-sentence')?.textContent.includes('cannot play')")
        self.look("film-broken")


def lacking():
    """What this machine lacks, or None."""
    return browser.missing() or (None if shutil.which("npm") else "npm")


if __name__ == "__main__":
    if lacking():
        print("skipped: this needs the package " + lacking())
        sys.exit(SKIPPED)
    subprocess.run(["bash", FETCH, BUILD], check=True)
    main()
