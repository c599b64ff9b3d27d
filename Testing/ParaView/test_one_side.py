# SPDX-License-Identifier: BSD-3-Clause
"""Servers that lack something: the plugin, OpenGL, a display; and a client without the plugin.
An error that says so, or a picture drawn by the client; nothing that hangs or ends."""

import os

from paraview import simple

import pixels
import scene
import server

EYE = ([0, 0, 0], [0, 0, -1])


def draw(options, name):
    """The whole sphere is covered by a ball round the eye, drawn where ParaView can."""
    view = scene.make_view(RemoteRenderThreshold=0)
    ball = simple.Sphere(Radius=3)
    display = simple.Show(ball, view)
    display.Ambient, display.Diffuse, display.Specular = 1, 0, 0
    display.AmbientColor = display.DiffuseColor = [1, 1, 1]
    scene.place_eye(view, *EYE)
    picture = scene.save(view, os.path.join(options.output, name + ".png"))
    white = sum(level > 250 for row in pixels.read_levels(picture) for level in row)
    print(name, white, "pixels of the ball")
    scene.require(white > 0.99 * scene.SIZE[0] * scene.SIZE[1], name)


def check_one_side(options, name, remote):
    """The plugin in one of the two processes; the other views go on working."""
    log = os.path.join(options.output, name + ".log")
    with server.connected(log) as process:
        simple.LoadPlugin(options.plugin, remote=remote, ns=vars(simple))
        server.check_refused(process)
        simple.Disconnect()


def survives(options, name, **environment):
    """Whether such a server goes on where ParaView's own Render View asks it to draw. That of
    ParaView 6.1 without a display ends where OpenGL is too old for it."""
    with server.connected(os.path.join(options.output, name + "-stock.log"), **environment) as process:
        view = simple.CreateView("RenderView")
        view.RemoteRenderThreshold = 0
        simple.Show(simple.Sphere(), view)
        simple.Render(view)
        lives = process.poll() is None
        simple.Disconnect()
    print(name, "a Render View", "is drawn" if lives else "ends the server")
    return lives


def check_no_graphics(options, name, words, **environment):
    """The client draws instead; the server's log says why."""
    log = os.path.join(options.output, name + ".log")
    with server.connected(log, **environment) as process:
        scene.load_plugin(options, remote=True)
        draw(options, name)
        scene.require(process.poll() is None, "the server has gone")
        simple.Disconnect()
    with open(log) as file:
        text = file.read()
    scene.require(words in text, name + ": the log lacks " + words)


def main(options):
    check_one_side(options, "server", True)  # first: what the client has loaded stays
    check_one_side(options, "client", False)
    old = {"MESA_GL_VERSION_OVERRIDE": "2.1", "MESA_GLSL_VERSION_OVERRIDE": "120"}
    check_no_graphics(options, "no-display", "", DISPLAY=None)
    if survives(options, "old-opengl", **old):
        check_no_graphics(options, "old-opengl", "OpenGL 3.2", **old)


scene.run(main)
