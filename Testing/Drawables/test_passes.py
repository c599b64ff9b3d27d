# SPDX-License-Identifier: BSD-3-Clause
"""Passes over the whole picture round a wide view: the picture that they should make, or one warning.

    test_passes.py FOLDER [NAME...]

FOLDER has the package widefov. Each in a process of its own. What a pass should make is reckoned from
the picture without it.
"""

import sys

import numpy


def steps():
    import vtk

    made = vtk.vtkRenderStepsPass()
    return made


def blurred(picture):
    """By the kernel of vtkGaussianBlurPass: binomial, of five pixels in each direction."""
    kernel = numpy.array([1, 4, 6, 4, 1]) / 16
    padded = numpy.pad(picture.astype(float), ((2, 2), (2, 2), (0, 0)), mode="edge")
    across = sum(k * padded[:, i : i + picture.shape[1]] for i, k in enumerate(kernel))
    return sum(k * across[i : i + picture.shape[0]] for i, k in enumerate(kernel))


def inner(picture, margin=6):
    return picture[margin:-margin, margin:-margin]


def same(a, b, most=2):
    """The share of the pixels that differ by more."""
    return float((abs(inner(a) - inner(b)).max(-1) > most).mean())


def scene(stage):
    import materials

    for centre in ((0, 0, 0), (2.5, 0.5, 3), (0.3, 0, 6)):
        actor = materials.actor_of(materials.ball(0.7, centre))
        actor.GetProperty().SetColor(0.9, 0.5, 0.1)
        stage.add(actor)


def draw(change):
    """The picture without and with what change(stage) does, and what was said meanwhile."""
    import vtk

    import draw as drawing

    stage = drawing.wide_stage()
    scene(stage)
    plain = stage.draw()
    heard = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(heard)
    change(stage)
    stage.draw()
    return plain, stage.draw(), heard.GetOutput(), drawing.gl_errors()


def around(kind, inside):
    """A pass over the picture, round the wide pass itself or stock VTK's steps."""

    def change(stage):
        made = kind()
        made.SetDelegatePass(stage.renderer.GetPass() if inside == "wide" else steps())
        stage.renderer.SetPass(made)

    return change


def is_blurred(plain, changed):
    """But for half a pixel: the pass draws rectangles that are a pixel smaller than their pictures. At
    the edges here that is half of the 38 levels that a blurred one rises by in a pixel."""
    return same(blurred(plain), changed, 20)


def is_same(plain, changed):
    return same(plain, changed)


def is_smoother(plain, changed):
    """As the plain picture but at its edges, where colours lie between."""
    edges = numpy.zeros(plain.shape[:2], bool)
    for axis in (0, 1):
        step = abs(numpy.diff(plain, axis=axis)).max(-1) > 12
        for side in (0, 1):
            pad = [(0, 0), (0, 0)]
            pad[axis] = (side, 1 - side)
            edges |= numpy.pad(step, pad)
    far = abs(inner(plain) - inner(changed)).max(-1) > 12
    kept = float((far & ~inner(edges)).mean())
    return kept if (plain != changed).any() else 1.0


def is_edges(plain, changed):
    """Black but where the plain picture changes."""
    flat = numpy.ones(plain.shape[:2], bool)
    for dy in range(-2, 3):
        for dx in range(-2, 3):
            flat &= (numpy.roll(plain, (dy, dx), (0, 1)) == plain).all(-1)
    lit = changed.max(-1) > 40
    wrong = float((inner(lit) & inner(flat)).mean())
    return wrong if lit.any() else 1.0


def shadows(stage):
    stage.renderer.UseShadowsOn()


def occlusion(stage):
    stage.renderer.UseSSAOOn()


def plain_camera(stage):
    import vtk

    camera = vtk.vtkCamera()
    camera.SetPosition(0, 0, 3)
    stage.renderer.SetActiveCamera(camera)


def large_picture(stage):
    import vtk

    large = vtk.vtkRenderLargeImage()
    large.SetInput(stage.renderer)
    large.SetMagnification(2)
    large.Update()


def cases():
    """Name: what is changed; what the picture is to be, or None; what is said where it is left out."""
    import vtk

    def clamp():
        made = vtk.vtkToneMappingPass()
        made.SetToneMappingType(vtk.vtkToneMappingPass.Clamp)
        return made

    kinds = {
        "blur": (vtk.vtkGaussianBlurPass, is_blurred),
        "tone mapping": (clamp, is_same),
        "supersampling": (vtk.vtkSSAAPass, is_smoother),
        "FXAA": (vtk.vtkOpenGLFXAAPass, is_smoother),
        "Sobel": (vtk.vtkSobelGradientMagnitudePass, is_edges),
    }
    made = {}
    for name, (kind, is_right) in kinds.items():
        for inside in ("wide", "stock"):
            made["%s round the %s pass" % (name, inside)] = (around(kind, inside), is_right, None)
    for name, kind in {
        "vtkEDLShading": vtk.vtkEDLShading,
        "vtkDepthOfFieldPass": vtk.vtkDepthOfFieldPass,
        "vtkSSAOPass": vtk.vtkSSAOPass,
    }.items():
        made[name] = (around(kind, "stock"), is_same, name)
    made["UseShadows"] = (shadows, is_same, "UseShadows")
    made["UseSSAO"] = (occlusion, is_same, "UseSSAO")
    made["vtkRenderLargeImage"] = (large_picture, is_same, "vtkRenderLargeImage")
    made["a camera of VTK's own"] = (plain_camera, None, "flat")
    return made


LEAST = 0.003  # share of the pixels that may be otherwise


def judge(name):
    change, is_right, word = cases()[name]
    plain, changed, said, errors = draw(change)
    faults = []
    if errors:
        faults.append("OpenGL notes errors %s" % errors)
    if word and said.count(word) < 1:
        faults.append("nothing names %s: %r" % (word, said))
    if said.count("Warning:") > (1 if word else 0):
        faults.append("more is said than that: %r" % said)
    if is_right and is_right(plain, changed) > LEAST:
        faults.append("%.3g of the pixels are otherwise" % is_right(plain, changed))
    return faults


def main(folder, *names):
    sys.path.insert(0, folder)
    import forked

    import draw  # noqa: F401, loaded once for all

    return forked.judge_all(names or forked.run(lambda _: sorted(cases()), ""), judge)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
