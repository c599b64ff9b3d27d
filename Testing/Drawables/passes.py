# SPDX-License-Identifier: BSD-3-Clause
"""What every render pass of VTK makes of a wide view."""

import vtk

import draw
import materials

# Ahead of an eye at (0, 0, 3), beside it and behind it.
BALLS = ((0, 0, 0), (3, 0.5, 3), (0.3, 0, 6))
NEAR = 6  # pixels: what blurs, glows and outlines reach

FIRST = ("vtkClearRGBPass", "vtkClearZPass")  # of a sequence


def add_balls(stage):
    for centre in BALLS:
        actor = materials.actor_of(materials.ball(0.7, centre))
        actor.GetProperty().SetColor(0.9, 0.5, 0.1)
        stage.add(actor)


def sequence(*parts):
    passes = vtk.vtkRenderPassCollection()
    for part in parts:
        passes.AddItem(part)
    made = vtk.vtkSequencePass()
    made.SetPasses(passes)
    return made


def translucent(made):
    """With what it peels, if it does."""
    if hasattr(made, "SetTranslucentPass"):
        made.SetTranslucentPass(vtk.vtkTranslucentPass())
    return made


def alone(made):
    """One for several ranks, with a controller of the only one."""
    if hasattr(made, "SetController"):
        made.SetController(vtk.vtkDummyController())
    if hasattr(made, "SetServerSideRendering"):
        made.SetServerSideRendering(False)
    return made


def in_steps(name):
    """Of one that calls no other: with the lights and what is opaque, in a camera pass."""
    steps = [vtk.vtkLightsPass(), vtk.vtkOpaquePass()]
    if name not in ("vtkCameraPass", "vtkSequencePass"):
        steps.insert(0 if name in FIRST else len(steps), translucent(alone(getattr(vtk, name)())))
    made = vtk.vtkCameraPass()
    made.SetDelegatePass(sequence(*steps))
    return made


def chains(name, own):
    """The ways to use a pass: round the renderer's own, round stock VTK's steps, or among them."""
    kind = getattr(vtk, name)
    if hasattr(kind, "SetRenderPass"):  # it draws what it is told to draw
        made = alone(kind())
        made.SetRenderPass(own or vtk.vtkRenderStepsPass())
        return [made]
    if not hasattr(kind, "SetDelegatePass") or name == "vtkCameraPass":
        return [in_steps(name)]
    made = []
    for inner in (own, vtk.vtkRenderStepsPass()):
        if inner:
            made.append(kind())
            made[-1].SetDelegatePass(inner)
    return made


def draw_with(stage, chain):
    """The second frame with a pass."""
    stage.renderer.SetPass(chain)
    stage.draw()
    picture = stage.draw()
    chain.ReleaseGraphicsResources(stage.window)
    return picture


def differs(picture):
    """Where it is not as in its corner."""
    return (abs(picture - picture[0, 0]) > 2).any(-1)


def faults_of(plain, picture):
    """What is seen where nothing is, and of what nothing is seen."""
    there = draw.covered(plain)
    shown = differs(picture)
    faults = []
    beside = float((shown & ~draw.grown(there, NEAR)).mean())
    if beside > 0:
        faults.append("%.3g of the picture shows what is not there" % beside)
    missing = float((there & ~draw.grown(shown, NEAR)).sum()) / there.sum()
    if missing > 0.5:
        faults.append("%.3g of what there is are not shown" % missing)
    return faults


def show_stock(name):
    """Whether stock VTK shows anything by it."""
    stage = draw.stock_stage()
    add_balls(stage)
    plain = stage.draw()
    for chain in chains(name, None):
        if faults_of(plain, draw_with(stage, chain)):
            return False
    return True


def measure(name):
    heard = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(heard)
    found = {"faults": [], "changes": False, "stock": True}
    stage = draw.wide_stage()
    add_balls(stage)
    plain = stage.draw()
    own = stage.renderer.GetPass()
    for chain in chains(name, own):
        picture = draw_with(stage, chain)
        found["faults"] += faults_of(plain, picture)
        found["changes"] |= bool((picture != plain).any())
    stage.renderer.SetPass(own)
    found["gl"], found["said"] = draw.gl_errors(), heard.GetOutput()
    if found["faults"]:
        found["stock"] = show_stock(name)
    return found


def verdict(found):
    if found["gl"]:
        return "OpenGL notes errors %s" % found["gl"], True
    warned = found["said"].count("Warning:")
    if warned > 1 or "ERROR:" in found["said"]:
        return "more is said than one warning: %r" % found["said"], True
    if found["faults"] and not found["stock"]:
        return "shows nothing by itself, as in stock VTK", False
    if found["faults"] and not warned:
        return "; ".join(found["faults"]), True
    if warned:
        return "left out, with a warning", bool(found["changes"]) and not found["faults"]
    return "works on the wide view" if found["changes"] else "draws the wide view as it is", False
