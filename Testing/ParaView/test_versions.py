# SPDX-License-Identifier: BSD-3-Clause
"""A server whose plugin is of another version than the client's: one line that names both versions
and no view, as where one of them lacks the plugin; nothing that hangs or ends. Of the same version,
a view and no such line. A plugin that was built for another ParaView is not loaded, with one line."""

import os
import re

from paraview import simple

import scene
import server
from messages import Log

# The server's plugins, and their versions. The later one has a property that the client's view does
# not know, which ParaView by itself does not survive.
OTHERS = (("widefov-earlier-version", "0.0.9"), ("widefov-later-version", "99.0.0"))

LINE = "of the plugin WideFoV"


# A library of ParaView, with its version, as the plugin names those that it was linked with.
LIBRARY = re.compile(rb"libvtkRemotingCore-pv([0-9.]+)\.so")


def check_other_paraview(options):
    """As built for another ParaView: of libraries with another version, which are not there."""
    with open(options.plugin, "rb") as file:
        plugin = file.read()
    built = LIBRARY.search(plugin).group(1)
    other = re.sub(b"[0-9]", b"9", built)
    path = os.path.join(options.output, "WideFoV.so")
    with open(path, "wb") as file:
        file.write(plugin.replace(b"-pv" + built + b".so", b"-pv" + other + b".so"))
    with Log(options, "other-paraview") as log:
        try:
            simple.LoadPlugin(path, remote=False, ns=vars(simple))
        except RuntimeError as error:
            print(error)
    lines = log.find("-pv" + other.decode() + ".so")
    print(lines)
    scene.require(len(lines) == 1 and path in lines[0], "no line that names the plugin and its ParaView")
    scene.require(log.count("ERROR") == 1, "further errors")
    simple.Render(simple.CreateRenderView())


def load(options, server_plugin):
    simple.LoadPlugin(server_plugin, remote=True, ns=vars(simple))
    simple.LoadPlugin(options.plugin, remote=False, ns=vars(simple))


def check_other(options, name, version):
    """The line, no view, and a Render View that works on."""
    plugin = os.path.join(os.path.dirname(options.output), name + ".so")
    log_path = os.path.join(options.output, name + "-server.log")
    with server.connected(log_path) as process:
        load(options, plugin)
        with Log(options, name) as log:
            server.check_refused(process)
        lines = log.find(LINE)
        print(lines)
        scene.require(len(lines) == 1, "%s: %d lines of it" % (name, len(lines)))
        scene.require(log.count("ERROR") == 1, name + ": further errors")
        scene.require("server version " + version + "." in lines[0], "it lacks the server's version")
        simple.Disconnect()


def check_same(options):
    with server.connected(os.path.join(options.output, "same-server.log")) as process:
        load(options, options.plugin)
        with Log(options, "same") as log:
            simple.Render(scene.make_view())
        scene.require(log.count(LINE) == 0, "an error of versions that are the same")
        scene.require(process.poll() is None, "the server has gone")
        simple.Disconnect()


def main(options):
    check_other_paraview(options)
    for name, version in OTHERS:
        check_other(options, name, version)
    check_same(options)


scene.run(main)
