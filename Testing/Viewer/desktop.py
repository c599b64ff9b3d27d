# SPDX-License-Identifier: BSD-3-Clause
"""An X display of its own, the viewer in it, hands on its mouse and keys, and a camera."""

import json
import os
import subprocess
import tempfile
import time

import numpy
from Xlib import X, XK, display, error
from Xlib.ext import xtest
from Xlib.protocol import event

# Seconds until something that was asked for counts as missing: far above what it takes on
# two busy cores.
PATIENCE = 60
# Seconds between looks.
PAUSE = 0.02

BUTTONS = {"left": 1, "middle": 2, "right": 3, "wheel up": 4, "wheel down": 5}


class Gone(Exception):
    """What was waited for did not come."""


def wait_for(what, look):
    """Returns what `look` returns as soon as that is true."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        found = look()
        if found:
            return found
        time.sleep(PAUSE)
    raise Gone("%s: still not so after %d s" % (what, PATIENCE))


def pixels_of(drawable, width, height):
    """Rows from the top, red, green, blue."""
    raw = drawable.get_image(0, 0, width, height, X.ZPixmap, 0xFFFFFFFF)
    pixels = numpy.frombuffer(raw.data, numpy.uint8).reshape(height, width, 4)
    return pixels[:, :, 2::-1].copy()


class Desktop:
    """An Xvfb without a window manager; the keyboard goes where the pointer is."""

    def __init__(self, size="1280x1024"):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", size + "x24", "-noreset"],
            pass_fds=[writing],
            stderr=subprocess.DEVNULL,
        )
        os.close(writing)
        with os.fdopen(reading) as stream:
            number = stream.readline().strip()
        if not number:
            raise Gone("Xvfb does not start")
        self.name = ":" + number
        self.display = display.Display(self.name)
        self.root = self.display.screen().root

    def close(self):
        """The display goes, whoever uses it."""
        if self.server.poll() is None:
            self.display.close()
            self.server.terminate()
            self.server.wait()

    def photograph(self, width, height):
        """The upper left part of the screen: rows from the top, red, green, blue."""
        return pixels_of(self.root, width, height)

    def point(self, x, y):
        """Moves the pointer, in pixels of the screen."""
        xtest.fake_input(self.display, X.MotionNotify, x=int(x), y=int(y))
        self.display.sync()

    def press(self, button):
        xtest.fake_input(self.display, X.ButtonPress, BUTTONS[button])
        self.display.sync()

    def release(self, button):
        xtest.fake_input(self.display, X.ButtonRelease, BUTTONS[button])
        self.display.sync()

    def click(self, button):
        self.press(button)
        self.release(button)

    def code(self, key):
        return self.display.keysym_to_keycode(XK.string_to_keysym(key))

    def hold(self, key):
        xtest.fake_input(self.display, X.KeyPress, self.code(key))
        self.display.sync()

    def let_go(self, key):
        xtest.fake_input(self.display, X.KeyRelease, self.code(key))
        self.display.sync()

    def key(self, key, shift=False):
        """Types one key."""
        if shift:
            self.hold("Shift_L")
        self.hold(key)
        self.let_go(key)
        if shift:
            self.let_go("Shift_L")


class Source:
    """A program that files are dragged from, by the protocol XDND."""

    def __init__(self, desktop):
        self.display = desktop.display
        self.window = desktop.root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)

    def atom(self, name):
        return self.display.intern_atom(name)

    def send(self, target, name, *numbers):
        data = [self.window.id] + list(numbers) + [0] * (4 - len(numbers))
        target.send_event(
            event.ClientMessage(window=target, client_type=self.atom(name), data=(32, data))
        )
        self.display.sync()

    def wait_for(self, what, is_it):
        def look():
            while self.display.pending_events():
                happened = self.display.next_event()
                if is_it(happened):
                    return happened
            return None

        return wait_for(what, look)

    def wait_for_answer(self, name):
        self.wait_for(
            name, lambda e: e.type == X.ClientMessage and e.client_type == self.atom(name)
        )

    def drop(self, target, paths):
        """Drops the files on a window; returns when it has taken them."""
        self.window.set_selection_owner(self.atom("XdndSelection"), X.CurrentTime)
        self.send(target, "XdndEnter", 5 << 24, self.atom("text/uri-list"))
        self.send(target, "XdndPosition", 0, 5 << 16 | 5, 0, self.atom("XdndActionCopy"))
        self.wait_for_answer("XdndStatus")
        self.send(target, "XdndDrop")
        asked = self.wait_for("the question", lambda e: e.type == X.SelectionRequest)
        names = "".join("file://" + path + "\r\n" for path in paths).encode()
        asked.requestor.change_property(asked.property, asked.target, 8, names)
        asked.requestor.send_event(
            event.SelectionNotify(
                time=asked.time,
                requestor=asked.requestor,
                selection=asked.selection,
                target=asked.target,
                property=asked.property,
            )
        )
        self.wait_for_answer("XdndFinished")


class Viewer:
    """widefov-viewer in a desktop, with its log."""

    def __init__(self, desktop, program, arguments, folder, waits=True):
        self.desktop = desktop
        self.log_name = os.path.join(folder, "viewer.log")
        if os.path.exists(self.log_name):
            os.remove(self.log_name)
        self.errors = tempfile.TemporaryFile()
        self.output = tempfile.TemporaryFile()
        self.process = subprocess.Popen(
            [program] + arguments + ["--log", self.log_name],
            cwd=folder,
            env={**os.environ, "DISPLAY": desktop.name},
            stdin=subprocess.DEVNULL,
            stdout=self.output,
            stderr=self.errors,
        )
        self.window = wait_for("the window", self.find)
        if waits:
            self.wait()

    def windows(self):
        """The viewer's windows by their titles, mapped; without a window manager children of
        the root."""
        self.check_running()
        found = {}
        for window in self.desktop.root.query_tree().children:
            try:
                title = window.get_wm_name() or ""
                if title.startswith("widefov-viewer"):
                    if window.get_attributes().map_state == X.IsViewable:
                        found[title] = window
            except error.XError:
                pass  # it went meanwhile
        return found

    def find(self):
        """A window of the viewer."""
        return next(iter(self.windows().values()), None)

    def check_running(self):
        if self.process.poll() is not None:
            raise Gone("the viewer ended with %d: %s" % (self.process.returncode, self.said()))

    @staticmethod
    def text_of(stream):
        stream.seek(0)
        return stream.read().decode("utf-8", "replace")

    def said(self):
        return self.text_of(self.errors)

    def printed(self):
        return self.text_of(self.output)

    def states(self):
        """All lines of the log so far."""
        if not os.path.exists(self.log_name):
            return []
        with open(self.log_name, encoding="utf-8") as stream:
            text = stream.read()
        return [json.loads(line) for line in text.split("\n")[:-1]]

    def state(self):
        return self.states()[-1]

    def wait(self, look=lambda state: True, after=0):
        """The last state, as soon as everything is drawn and `look` is true of it; `after`
        so many lines of the log."""

        def looked():
            self.check_running()
            states = self.states()
            if len(states) <= after or states[-1]["pending"] or not look(states[-1]):
                return None
            return states[-1]

        return wait_for("a state of the viewer", looked)

    def after(self, act, look=lambda state: True):
        """Does something and returns the state that comes of it."""
        before = len(self.states())
        act()
        return self.wait(look, before)

    def key(self, key, shift=False, look=lambda state: True):
        """Types a key that changes what is shown, and returns the state after it."""
        return self.after(lambda: self.desktop.key(key, shift), look)

    def click(self, widget):
        """Clicks on a widget of the panel, and returns the state that comes of it."""
        left, top, right, bottom = self.wait(lambda s: s["panel"] and widget in s["panel"])["panel"][
            widget
        ]
        self.point(round(0.8 * left + 0.2 * right), round((top + bottom) / 2))
        return self.after(lambda: self.desktop.click("left"), lambda s: s["event"] == "panel")

    def origin(self):
        """Where the window's upper left corner is on the screen."""
        place = self.window.translate_coords(self.desktop.root, 0, 0)
        return -place.x, -place.y

    def point(self, x, y):
        """Moves the pointer to that pixel of the window."""
        left, top = self.origin()
        self.desktop.point(left + x, top + y)

    def drag(self, start, end, button="left", steps=5):
        """Drags from pixel to pixel, as a hand does, in steps."""
        self.point(*start)
        self.desktop.press(button)
        for i in range(1, steps + 1):
            self.point(*[round(a + (b - a) * i / steps) for a, b in zip(start, end)])
            time.sleep(PAUSE)
        return self.after(
            lambda: self.desktop.release(button),
            lambda state: [int(place) for place in state["cursor"]] == list(end),
        )

    def photograph(self):
        """What the screen shows of the window: rows from the top, red, green, blue."""
        size = self.window.get_geometry()
        return pixels_of(self.window, size.width, size.height)

    def preview(self, title):
        """The window of that title, beside the others: its picture and where it is on the screen."""
        window = wait_for(title,
            lambda: next((w for name, w in self.windows().items() if name.endswith(": " + title)), None))
        size = window.get_geometry()
        return pixels_of(window, size.width, size.height), (size.x, size.y)

    def resize(self, width, height):
        """Returns the state of the first frame of that size."""

        def act():
            self.window.configure(width=width, height=height)
            self.desktop.display.sync()

        return self.after(act, lambda state: state["size"] == [width, height])

    def ask_to_close(self):
        """What a window manager sends when its close button is pressed."""
        protocols = self.desktop.display.intern_atom("WM_PROTOCOLS")
        message = self.desktop.display.intern_atom("WM_DELETE_WINDOW")
        self.window.send_event(
            event.ClientMessage(
                window=self.window, client_type=protocols, data=(32, [message, 0, 0, 0, 0])
            )
        )
        self.desktop.display.sync()

    def end(self):
        """The exit code, or None where it goes on."""
        try:
            return self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            return None

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
